#pragma once

#include "manual_clock.h"
#include "modbus_rtu_framing.h"
#include "rtu_line.h"
#include "virtual_sensor.h"

#include <memory>
#include <QTest>
#include <vector>

namespace lds::test {

inline QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

inline constexpr int ecoMode = 400109;
inline constexpr int setValueSaving = 400054;
inline constexpr int communicationSpeed = 400167;
inline constexpr int deviceAddress = 400169;
inline constexpr int communicationReset = 400171;

inline QByteArray word(int value) { return QByteArray{} + char(value >> 8) + char(value & 0xff); }
inline QByteArray frame(int unit, const QByteArray& pdu) { return modbus::encodeRtuFrame(quint8(unit), pdu); }
/// Writes one register; the answer is the same.
inline QByteArray writeRegister(int unit, int number, int value)
{
    return frame(unit, hex("06") + word(number - 400001) + word(value));
}
inline QByteArray readRegisters(int unit, int number, int count)
{
    return frame(unit, hex("03") + word(number - 400001) + word(count));
}
/// Reads the span (400116), 1.0000.
inline QByteArray readSpan(int unit) { return readRegisters(unit, 400116, 2); }
inline QByteArray spanAnswer(int unit) { return frame(unit, hex("03 04 2710 0000")); }

/// A client's end of the line that keeps what arrives and when.
class FakeTerminal final : public emulator::LineTerminal {
    Q_OBJECT

public:
    struct Portion {
        qint64 timeNs;
        QByteArray bytes;
    };

    explicit FakeTerminal(emulator::EmulatorClock& clock)
        : m_clock(clock)
    {}
    std::optional<emulator::LineSettings> clientSettings() const override { return settings; }
    void send(const QByteArray& bytes) override { portions.push_back({m_clock.nowNs(), bytes}); }

    QByteArray taken() const
    {
        QByteArray all;
        for (const Portion& portion : portions)
            all += portion.bytes;
        return all;
    }

    std::optional<emulator::LineSettings> settings = emulator::LineSettings{};
    std::vector<Portion> portions;

private:
    emulator::EmulatorClock& m_clock;
};

/// A line on a clock that stands still, with as many units as a test adds.
class LineFixture : public QObject {
    Q_OBJECT

protected:
    struct Station {
        std::unique_ptr<emulator::VirtualSensor> sensor;
        std::unique_ptr<emulator::RtuUnit> unit;
    };

    void setUp()
    {
        tearDown();
        m_clock = std::make_unique<emulator::ManualClock>();
        m_terminal = std::make_unique<FakeTerminal>(*m_clock);
        m_line = std::make_unique<emulator::RtuLine>(*m_terminal, *m_clock);
    }
    void tearDown()
    {
        m_line.reset();
        m_stations.clear();
        m_terminal.reset();
        m_clock.reset();
    }
    /// A sensor at this address and these settings, from its saved memory.
    emulator::RtuUnit& add(int address, emulator::LineSettings settings = {})
    {
        emulator::SettingsMemory memory(catalog::SensorModel::HlG203);
        memory.setValue(catalog::ItemId::DeviceAddress, address);
        memory.setValue(catalog::ItemId::CommunicationSpeed, *catalog::lineSpeedCode(settings.speed));
        memory.setValue(catalog::ItemId::ParityStopBit, catalog::lineParityCode(settings.parity));
        auto sensor = std::make_unique<emulator::VirtualSensor>(memory, *m_clock);
        auto unit = std::make_unique<emulator::RtuUnit>(*sensor);
        m_line->attach(*unit);
        m_stations.push_back({std::move(sensor), std::move(unit)});
        return *m_stations.back().unit;
    }
    emulator::VirtualSensor& sensor(std::size_t index = 0) { return *m_stations.at(index).sensor; }
    emulator::RtuUnit& unit(std::size_t index = 0) { return *m_stations.at(index).unit; }

    void send(const QByteArray& bytes) { Q_EMIT m_terminal->received(bytes); }
    /// What came back within a second.
    QByteArray ask(const QByteArray& bytes)
    {
        m_terminal->portions.clear();
        send(bytes);
        m_clock->advanceMs(1000);
        return m_terminal->taken();
    }
    qint64 now() const { return m_clock->nowNs(); }

    std::unique_ptr<emulator::ManualClock> m_clock;
    std::unique_ptr<FakeTerminal> m_terminal;
    std::unique_ptr<emulator::RtuLine> m_line;
    std::vector<Station> m_stations;
};

} // namespace lds::test
