#pragma once

#include "reflection.h"

#include <QList>
#include <QtGlobal>

namespace lds::emulator {

/// An error as the display shows it, E100** and so on (§8.2).
struct ErrorState {
    quint16 code = 0;    ///< 100, 110, 120, 130, 131, 140, 150 or 200; 0: none.
    quint8 internal = 0; ///< The last two digits, 0 … 99: internal information.
    bool operator==(const ErrorState&) const = default;
};

/// What wears the sensor out; kept in its memory.
struct LifeCounters {
    qint64 operatingSeconds = 0;
    qint64 memoryWrites = 0; ///< Writes to non-volatile memory.
    bool operator==(const LifeCounters&) const = default;
};

/// Self-monitoring (§4.13): the detailed bits of notification, caution and error, and what brings them about.
class SelfMonitoring {
public:
    // The manual names no upper limits; these are chosen (a laser's usual life, a memory's usual endurance).
    static constexpr qint64 mostOperatingSeconds = 50'000LL * 3600;
    static constexpr qint64 mostMemoryWrites = 100'000;

    void raise(ErrorState error); ///< Once for each code; a code that is not in the table is ignored.
    void clear(quint16 code);
    void clearByPowerCycle(); ///< §8.2: what "turn the power OFF and then ON" helps against.
    /// The first of those present.
    ErrorState error() const { return m_errors.isEmpty() ? ErrorState{} : m_errors.first(); }
    bool has(quint16 code) const;
    static const QList<quint16>& codes();

    LifeCounters life;

    /// `outside`: the measured raw value is outside the measurement range. `alarm`: as in coil 1, whatever
    /// is held.
    static quint16 notificationBits(Light light, bool alarm, bool outside);
    quint16 cautionBits() const;
    quint16 errorBits() const;

private:
    QList<ErrorState> m_errors;
};

} // namespace lds::emulator
