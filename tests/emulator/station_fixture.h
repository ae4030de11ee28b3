#pragma once

#include "manual_clock.h"
#include "raw_client.h"
#include "sensor_station.h"

#include <memory>
#include <QTest>

namespace lds::test {

inline QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// Reads the span (400116), so that every answer tells which request it belongs to.
inline QByteArray readSpan(quint8 transaction)
{
    return hex("aa") + char(transaction) + hex("0000 0006 07 03 0073 0002");
}
inline QByteArray spanAnswer(quint8 transaction)
{
    return hex("aa") + char(transaction) + hex("0000 0007 07 03 04 2710 0000");
}
/// Writes one register; the answer is the same.
inline QByteArray writeRegister(quint8 transaction, int number, quint16 value)
{
    const auto address = quint16(number - 400001);
    QByteArray message = hex("bb") + char(transaction) + hex("0000 0006 01 06");
    for (const quint16 word : {address, value})
        message += QByteArray{} + char(word >> 8) + char(word & 0xff);
    return message;
}
inline constexpr int ecoMode = 400109;
inline constexpr int portModbus = 400153;
inline constexpr int portTool = 400154;
inline constexpr int setValueSaving = 400054;
inline constexpr int communicationReset = 400171;

/// A station with both servers at free ports of loopback, on a clock that stands still.
class StationFixture : public QObject {
    Q_OBJECT

protected:
    void setUp(const emulator::StationOptions& wanted = {})
    {
        tearDown();
        m_clock = std::make_unique<emulator::ManualClock>();
        emulator::StationOptions options = wanted;
        options.modbusPort = 0;
        options.toolPort = 0;
        auto station = emulator::SensorStation::start(options, *m_clock);
        QVERIFY2(station.has_value(), station ? "" : qPrintable(station.error().message));
        m_station = std::move(*station);
    }
    void tearDown()
    {
        m_station.reset();
        m_clock.reset();
    }
    emulator::VirtualSensor& sensor() { return m_station->sensor(); }
    emulator::FaultDesk& faults() { return m_station->faults(); }
    emulator::ScenePlayer& player() { return m_station->player(); }
    bool coil(int number)
    {
        sensor().catchUp();
        return sensor().coil(number);
    }
    /// Connected, and taken by the server.
    std::unique_ptr<RawClient> connectTo(emulator::ModbusTcpServer& server)
    {
        const int before = server.clientCount();
        auto client = std::make_unique<RawClient>(server.port(), server.address());
        [&] { QTRY_VERIFY(client->isConnected() && server.clientCount() == before + 1); }();
        return client;
    }

    std::unique_ptr<emulator::ManualClock> m_clock;
    std::unique_ptr<emulator::SensorStation> m_station;
};

} // namespace lds::test
