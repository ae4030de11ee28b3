#include "sensor_view.h"

#include "entry_digits.h"
#include "panel_text.h"

#include <algorithm>
#include <array>

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

IndicatorState indicator(const VirtualSensor& sensor, bool lit)
{
    if (sensor.error().code != 0) // §2.2: both blink if an error occurs
        return IndicatorState::Blinking;
    return lit ? IndicatorState::Lit : IndicatorState::Off;
}

} // namespace

QString measuredValueText(const VirtualSensor& sensor, int decimals)
{
    const Value value = sensor.read(ItemId::MeasuredValue);
    switch (value) {
    case sentinel::over:
        return QString::fromLatin1(words::over);
    case sentinel::under:
        return QString::fromLatin1(words::under);
    case sentinel::indeterminate:
        return QString::fromLatin1(words::indeterminate);
    case sentinel::alarm:
        return QString::fromLatin1(words::alarm);
    default:
        return measuredText(value, decimals);
    }
}

int fullDecimals(const VirtualSensor& sensor) { return Catalog::hlG2().model(sensor.model()).decimals; }

int displayDecimals(const VirtualSensor& sensor)
{
    // Code 0 is four digits, each further code one less (§4.8.1).
    const Value code = sensor.memory().value(ItemId::DisplayDigit);
    return std::clamp(4 - code, 0, fullDecimals(sensor));
}

QString receivedLightText(const VirtualSensor& sensor)
{
    const Value intensity = sensor.read(ItemId::PeakIntensity);
    return intensity == sentinel::noIntensity ? QString::fromLatin1(words::indeterminate)
                                              : QString::number(intensity);
}

QString errorText(const VirtualSensor& sensor)
{
    const ErrorState error = sensor.error();
    return error.code == 0 ? QString() : u"E%1%2"_s.arg(error.code).arg(error.internal, 2, 10, QChar(u'0'));
}

DisplayIcons iconsOf(const VirtualSensor& sensor)
{
    // In the order of the codes of §4.3.4.
    static const std::array<QString, 4> holdModes{QString(), u"P"_s, u"B"_s, u"PP"_s};
    const Value holdMode = sensor.memory().value(ItemId::HoldMode);
    const Measured measured = sensor.measured();
    DisplayIcons icons;
    icons.laser = measured.laserEmitting;
    icons.high = measured.outputs.high;
    icons.go = measured.outputs.go;
    icons.low = measured.outputs.low;
    icons.hold = measured.holding;
    icons.zero = measured.zeroSet;
    icons.bank = u"B%1"_s.arg(sensor.memory().bank() + 1);
    icons.holdMode = holdModes[std::size_t(std::clamp<Value>(holdMode, 0, Value(holdModes.size()) - 1))];
    return icons;
}

IndicatorState laserIndicator(const VirtualSensor& sensor)
{
    return indicator(sensor, sensor.measured().laserEmitting);
}

IndicatorState alarmIndicator(const VirtualSensor& sensor)
{
    return indicator(sensor, sensor.measured().alarmNow);
}

} // namespace lds::emulator
