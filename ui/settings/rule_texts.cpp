#include "rule_texts.h"

#include "item_text.h"
#include "row_facts.h"

#include <QCoreApplication>

namespace lds::ui {

using catalog::ItemId;
using catalog::Value;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::RuleTexts)
};

class Numbers {
public:
    explicit Numbers(const sensor::SensorSession& session)
        : m_session(session)
        , m_values(RowFacts::wantedValues(session))
    {}

    bool has(ItemId id) const { return m_values.contains(id); }
    qint64 value(ItemId id) const { return m_values.value(id); }
    /// With its unit; "?" while it is not known.
    QString text(ItemId id) const { return has(id) ? text(id, m_values.value(id)) : QStringLiteral("?"); }
    QString text(ItemId id, qint64 value) const
    {
        return displayValueWithUnit(m_session.catalog().item(id), m_session.model(), Value(value));
    }
    QString choice(ItemId id, Value code) const
    {
        return displayValue(m_session.catalog().item(id), m_session.model(), code);
    }

private:
    const sensor::SensorSession& m_session;
    settings::Values m_values;
};

/// §4.4.1, §4.4.2, §4.4.3
QString windowRule(const Numbers& numbers)
{
    const QString rule = Texts::tr("HIGH − LOW must be more than twice the hysteresis.");
    if (!numbers.has(ItemId::HighSetValue) || !numbers.has(ItemId::LowSetValue) ||
        !numbers.has(ItemId::Hysteresis))
        return rule;
    const qint64 window = numbers.value(ItemId::HighSetValue) - numbers.value(ItemId::LowSetValue);
    return Texts::tr("HIGH − LOW must be more than twice the hysteresis (2 × %1). It is %2.")
        .arg(numbers.text(ItemId::Hysteresis), numbers.text(ItemId::Hysteresis, window));
}

QStringList portRules(const Numbers& numbers, ItemId other)
{
    return {Texts::tr("Not 44818, which EtherNet/IP uses."),
            Texts::tr("Not the same as the other port (%1).").arg(numbers.text(other))};
}

QStringList addressRules(catalog::WriteGroup group)
{
    switch (group) {
    case catalog::WriteGroup::IpAddress:
        return {
            Texts::tr("The first number is not 0, 127 or 224 to 255."),
            Texts::tr("With the mask, neither the network part nor the host part is all zeros, and the host "
                      "part is not all ones."),
            Texts::tr("In one subnet with the default gateway.")};
    case catalog::WriteGroup::SubnetMask:
        return {Texts::tr("In binary: ones, then zeros, as in 255.255.255.0."),
                Texts::tr("IP address and default gateway stay in one subnet.")};
    case catalog::WriteGroup::DefaultGateway:
        return {Texts::tr("0.0.0.0 for none; else the first number is not 0, 127 or 224 to 255."),
                Texts::tr("With the mask, the host part is neither all zeros nor all ones."),
                Texts::tr("In one subnet with the IP address.")};
    case catalog::WriteGroup::None:
        break;
    }
    return {};
}

QStringList judgmentRules(ItemId id, const Numbers& numbers)
{
    switch (id) {
    case ItemId::HighSetValue:
        return {Texts::tr("Greater than the LOW set value (%1).").arg(numbers.text(ItemId::LowSetValue)),
                windowRule(numbers)};
    case ItemId::LowSetValue:
        return {Texts::tr("Less than the HIGH set value (%1).").arg(numbers.text(ItemId::HighSetValue)),
                windowRule(numbers)};
    case ItemId::Hysteresis:
        return {
            windowRule(numbers),
            Texts::tr("Free of the tolerance (%1), but 1 point teaching may fail when it is not below it.")
                .arg(numbers.text(ItemId::Tolerance))};
    case ItemId::Tolerance:
        return {Texts::tr("Greater than the hysteresis (%1).").arg(numbers.text(ItemId::Hysteresis))};
    default:
        return {};
    }
}

} // namespace

QStringList ruleTexts(const SettingRow& row, const sensor::SensorSession& session)
{
    if (row.isHeading())
        return {};
    const Numbers numbers(session);
    const ItemId id = row.first()->id;
    switch (id) {
    case ItemId::HoldMode: // §4.3.4
        return {Texts::tr("Any other mode than “%1” turns trigger mode “%2” into “%3”.")
                    .arg(numbers.choice(ItemId::HoldMode, 0), numbers.choice(ItemId::TriggerMode, 1),
                         numbers.choice(ItemId::TriggerMode, 0))};
    case ItemId::TriggerMode: // §4.6.2
        return {Texts::tr("“%1” only while hold mode is “%2”. Hold mode is “%3”.")
                    .arg(numbers.choice(ItemId::TriggerMode, 1), numbers.choice(ItemId::HoldMode, 0),
                         numbers.text(ItemId::HoldMode))};
    case ItemId::PortModbus:
        return portRules(numbers, ItemId::PortTool);
    case ItemId::PortTool:
        return portRules(numbers, ItemId::PortModbus);
    default:
        break;
    }
    if (row.first()->group != catalog::WriteGroup::None)
        return addressRules(row.first()->group);
    return judgmentRules(id, numbers);
}

} // namespace lds::ui
