#pragma once

#include "manual_clock.h"
#include "virtual_sensor.h"

#include <memory>
#include <QObject>

namespace lds::test {

// Coils of §5.2.5 by their number.
enum CoilNumber {
    Alarm = 1,
    Indeterminate = 2,
    High = 3,
    Go = 4,
    Low = 5,
    TimerOffHigh = 6,
    TimerOffGo = 7,
    TimerOffLow = 8,
    Hold = 9,
    Zero = 10,
    Laser = 11,
    Error = 12,
    Caution = 13,
    Notification = 14,
    ExcessiveLight = 17,
    InsufficientLight = 18,
    OutsideRange = 19,
    ExtraneousLight = 20,
    WritesExceeded = 34,
    BeamError = 49,
    SystemError = 51,
};

inline constexpr int averageFullMs = 600; ///< Longer than the default average of 512 samples of 1 ms.

/// A fresh HL-G203 with a clock of its own for each test.
class SensorFixture : public QObject {
    Q_OBJECT

protected:
    void setUp()
    {
        m_sensor.reset();
        m_clock = std::make_unique<emulator::ManualClock>();
        make(catalog::SensorModel::HlG203);
    }
    emulator::VirtualSensor& make(catalog::SensorModel model)
    {
        m_sensor = std::make_unique<emulator::VirtualSensor>(model, *m_clock);
        return *m_sensor;
    }
    bool write(catalog::ItemId id, catalog::Value value)
    {
        const emulator::WriteOutcome outcome = m_sensor->write({{id, value}});
        return !outcome.refusal && outcome.written == 1;
    }
    catalog::Value readNow(catalog::ItemId id)
    {
        m_sensor->catchUp();
        return m_sensor->read(id);
    }
    catalog::Value value() { return readNow(catalog::ItemId::MeasuredValue); }

    std::unique_ptr<emulator::ManualClock> m_clock;
    std::unique_ptr<emulator::VirtualSensor> m_sensor;
};

} // namespace lds::test
