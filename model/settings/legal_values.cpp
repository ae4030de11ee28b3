#include "legal_values.h"

#include <algorithm>

namespace lds::settings {

bool hasChoice(const catalog::SettingItem& item, catalog::SensorModel model, catalog::Value code)
{
    return std::any_of(item.choices.begin(), item.choices.end(), [&](const catalog::Choice& choice) {
        return choice.code == code && (choice.models & catalog::maskOf(model)) != 0;
    });
}

bool isLegal(const catalog::SettingItem& item, catalog::SensorModel model, catalog::Value value)
{
    if (item.kind == catalog::Kind::Choice)
        return hasChoice(item, model, value);
    const catalog::Limits& limits = item.limitsFor(model);
    return value >= limits.minimum && value <= limits.maximum;
}

} // namespace lds::settings
