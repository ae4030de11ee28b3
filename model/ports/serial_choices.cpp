#include "serial_choices.h"

#include "catalog.h"
#include "serial_codes.h"

#include <algorithm>

namespace lds::ports {

using catalog::ItemId;

namespace {

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
    for (const catalog::Choice& choice : catalog::hlG2(ItemId::CommunicationSpeed).choices)
        speeds.append(catalog::lineSpeed(choice.code).value_or(0));
    return speeds;
}

std::optional<catalog::Value> speedCode(int baud) { return catalog::lineSpeedCode(baud); }

catalog::Value parityCode(SerialParity parity) { return catalog::lineParityCode(parity); }

std::optional<SerialSettings> serialSettingsOf(catalog::Value speedCode, catalog::Value parityCode)
{
    const auto speed = catalog::lineSpeed(speedCode);
    const auto parity = catalog::lineParity(parityCode);
    if (!speed || !parity)
        return std::nullopt;
    return SerialSettings{*speed, *parity};
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
