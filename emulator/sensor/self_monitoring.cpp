#include "self_monitoring.h"

#include <algorithm>

namespace lds::emulator {

namespace {

enum NotificationBit : quint16 {
    ExcessiveLight = 1 << 0,
    InsufficientLight = 1 << 1,
    OutsideRange = 1 << 2,
    ExtraneousLight = 1 << 3,
};
enum CautionBit : quint16 { OperatingHoursExceeded = 1 << 0, MemoryWritesExceeded = 1 << 1 };
enum ErrorBit : quint16 { BeamEmittingCircuit = 1 << 0, System = 1 << 2 };

// §8.2
constexpr quint16 userMemoryError = 131; ///< Needs Set value initialization.
constexpr quint16 beamEmittingCircuitError = 200;

quint16 flag(bool on, quint16 bit) { return on ? bit : 0; }

} // namespace

const QList<quint16>& SelfMonitoring::codes()
{
    static const QList<quint16> all{100, 110, 120, 130, userMemoryError, 140, 150, beamEmittingCircuitError};
    return all;
}

void SelfMonitoring::raise(ErrorState error)
{
    if (codes().contains(error.code) && !has(error.code))
        m_errors.append({error.code, quint8(error.internal % 100)});
}

void SelfMonitoring::clear(quint16 code)
{
    m_errors.removeIf([code](const ErrorState& error) { return error.code == code; });
}

void SelfMonitoring::clearByPowerCycle()
{
    m_errors.removeIf([](const ErrorState& error) {
        return error.code != userMemoryError && error.code != beamEmittingCircuitError;
    });
}

bool SelfMonitoring::has(quint16 code) const
{
    return std::any_of(m_errors.begin(), m_errors.end(),
                       [code](const ErrorState& error) { return error.code == code; });
}

quint16 SelfMonitoring::notificationBits(Light light, bool alarm, bool outside)
{
    return flag(alarm && light == Light::Excessive, ExcessiveLight) |
           flag(alarm && light == Light::Insufficient, InsufficientLight) |
           flag(alarm && light == Light::ExtraneousLight, ExtraneousLight) | flag(outside, OutsideRange);
}

quint16 SelfMonitoring::cautionBits() const
{
    return flag(life.operatingSeconds > mostOperatingSeconds, OperatingHoursExceeded) |
           flag(life.memoryWrites > mostMemoryWrites, MemoryWritesExceeded);
}

quint16 SelfMonitoring::errorBits() const
{
    const bool beam = has(beamEmittingCircuitError);
    return flag(beam, BeamEmittingCircuit) | flag(m_errors.size() > (beam ? 1 : 0), System);
}

} // namespace lds::emulator
