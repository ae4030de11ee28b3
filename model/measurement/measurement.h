#pragma once

#include "setting_item.h"

#include <QList>
#include <QtGlobal>

namespace lds::measurement {

using catalog::Value;

/// What the number in a measurement is. Value and state are separate: with the alarm digital output on
/// Hold the sensor reports an alarm *and* a frozen value (§4.7.2).
enum class ValueKind : quint8 {
    Valid,         ///< A length.
    Over,          ///< Above the display range: +9,600,000 (§5.2.4).
    Under,         ///< Below the display range: −9,600,000.
    Indeterminate, ///< −9,999,999.
    Alarm,         ///< +9,999,999.
};

/// Sensor state bits as the sensor reports them (§5.2.5), bit 0 being coil 1; reserved bits masked.
enum StateBit : quint16 {
    AlarmBit = 1 << 0,
    IndeterminateBit = 1 << 1,
    HighBit = 1 << 2, ///< Judgment output HI, after the output delay timer.
    GoBit = 1 << 3,
    LowBit = 1 << 4,
    HighNoTimerBit = 1 << 5, ///< Judgment at timer OFF.
    GoNoTimerBit = 1 << 6,
    LowNoTimerBit = 1 << 7,
    HoldBit = 1 << 8,
    ZeroBit = 1 << 9,
    LaserBit = 1 << 10,
    ErrorBit = 1 << 11,
    CautionBit = 1 << 12,
    NotificationBit = 1 << 13,
    ReservedStateBits = 0xc000,
};

/// One sample as it was received.
struct Measurement {
    qint64 monotonicNs = 0; ///< When the reply arrived, on the scheduler's monotonic clock.
    qint64 wallMs = 0;      ///< The same instant as milliseconds since the epoch, UTC.
    Value value = 0;        ///< 0.1 µm; a sentinel where kind is not Valid.
    ValueKind kind = ValueKind::Indeterminate;
    quint16 state = 0;        ///< StateBit
    quint16 notification = 0; ///< Self-monitoring details (§4.13), reserved bits masked.
    quint16 caution = 0;
    quint16 error = 0;
    quint16 errorCode = 0;     ///< 0x0100 stands for E100**.
    quint16 intensity = 65535; ///< 0 … 1023; 65535 when there is none.

    bool hasValue() const { return kind == ValueKind::Valid; }
    /// A frozen value under an alarm: on screen marked, out of statistics (§4.7.2 Hold).
    bool isFrozen() const { return hasValue() && (state & AlarmBit); }
};

using MeasurementBatch = QList<Measurement>;

/// The kind of a value as it came over the wire (sentinels of §5.2.4).
ValueKind kindOf(Value wireValue);

} // namespace lds::measurement
