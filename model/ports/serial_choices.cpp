#include "serial_choices.h"

#include "catalog.h"

#include <algorithm>
#include <QLatin1StringView>

namespace lds::ports {

using catalog::ItemId;

namespace {

std::span<const catalog::Choice> speedChoices() { return catalog::hlG2(ItemId::CommunicationSpeed).choices; }

/// The catalog names a speed by its number: "38400 bps".
int baudOf(const catalog::Choice& choice)
{
    const QLatin1StringView name(choice.name);
    return name.first(std::max<qsizetype>(0, name.indexOf(QLatin1Char(' ')))).toInt();
}

SerialSettings asDelivered()
{
    const auto code = [](ItemId item) {
        return catalog::hlG2(item).limitsFor(catalog::SensorModel::HlG203).defaultValue; // same for all types
    };
    return serialSettingsOf(code(ItemId::CommunicationSpeed), code(ItemId::ParityStopBit))
        .value_or(SerialSettings());
}

} // namespace

QList<int> serialSpeeds()
{
    QList<int> speeds;
    for (const catalog::Choice& choice : speedChoices())
        speeds.append(baudOf(choice));
    return speeds;
}

std::optional<catalog::Value> speedCode(int baud)
{
    for (const catalog::Choice& choice : speedChoices()) {
        if (baudOf(choice) == baud)
            return choice.code;
    }
    return std::nullopt;
}

// SerialParity lists NON, EVEN and ODD in the order of the catalog's codes.
catalog::Value parityCode(SerialParity parity) { return catalog::Value(parity); }

std::optional<SerialSettings> serialSettingsOf(catalog::Value speedCode, catalog::Value parityCode)
{
    const auto speeds = speedChoices();
    const auto speed = std::ranges::find(speeds, speedCode, &catalog::Choice::code);
    const auto parities = catalog::hlG2(ItemId::ParityStopBit).choices;
    const auto parity = std::ranges::find(parities, parityCode, &catalog::Choice::code);
    if (speed == speeds.end() || parity == parities.end())
        return std::nullopt;
    return SerialSettings{baudOf(*speed), SerialParity(parityCode)};
}

QList<SerialSettings> everySerialSettings()
{
    const SerialSettings usual = asDelivered();
    QList<SerialParity> parities{usual.parity};
    for (const SerialParity parity : {SerialParity::None, SerialParity::Odd, SerialParity::Even}) {
        if (!parities.contains(parity))
            parities.append(parity);
    }
    QList<int> speeds = serialSpeeds();
    std::ranges::reverse(speeds);
    QList<SerialSettings> all{usual};
    for (const SerialParity parity : std::as_const(parities)) {
        for (const int speed : std::as_const(speeds)) {
            if (const SerialSettings settings{speed, parity}; !all.contains(settings))
                all.append(settings);
        }
    }
    return all;
}

QList<SerialSettings> usualSerialSettings() { return everySerialSettings().first(serialSpeeds().size()); }

} // namespace lds::ports
