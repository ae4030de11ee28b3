#include "model_guess.h"

#include "legal_values.h"

#include <algorithm>
#include <array>

namespace lds::settings {

namespace {

/// What differs between the types and stands in a register (protocols.md).
constexpr std::array tellingItems{ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis,
                                  ItemId::Offset,       ItemId::Tolerance,   ItemId::DisplayDigit};

bool admits(catalog::SensorModel model, const Values& values)
{
    return std::all_of(tellingItems.begin(), tellingItems.end(), [&](ItemId id) {
        const auto found = values.constFind(id);
        return found == values.constEnd() || isLegal(catalog::hlG2(id), model, *found);
    });
}

} // namespace

catalog::ModelMask modelsThatFit(const Values& values)
{
    catalog::ModelMask fitting = 0;
    for (const catalog::ModelDescription& description : catalog::Catalog::hlG2().models()) {
        if (admits(description.model, values))
            fitting = catalog::ModelMask(fitting | maskOf(description.model));
    }
    return fitting;
}

} // namespace lds::settings
