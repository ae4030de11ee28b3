#include "hlg2_rows.h"
#include "hlg2_tables.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr ModelDescription describe(SensorModel model, const char* typeName, int centerDistance,
                                    Value measurementRange, int decimals)
{
    const auto index = std::size_t(model);
    return {
        model,   typeName, centerDistance, measurementRange, displayLimit[index], settingResolution[index],
        decimals};
}

constexpr ModelDescription descriptions[] = {
    describe(SensorModel::HlG203, "HL-G203B-S-MK", 30, 50'000, 4),
    describe(SensorModel::HlG205, "HL-G205B-S-MK", 50, 100'000, 3),
    describe(SensorModel::HlG208, "HL-G208B-S-MK", 85, 200'000, 3),
    describe(SensorModel::HlG212, "HL-G212B-S-MK", 120, 300'000, 3),
    describe(SensorModel::HlG225, "HL-G225B-S-MK", 250, 1'500'000, 2),
};

} // namespace

std::span<const ModelDescription> models() { return descriptions; }

} // namespace lds::catalog::hlg2
