// A whole station on a line: named faults, scenes and the unit it starts as.
#include "line_fixture.h"
#include "sensor_station.h"

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;
using By = FaultDesk::By;

class RtuStationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { start({}); }
    void cleanup();

    void theUnitIsTheSensorsAddressUntilAPowerCycle();
    void answersAfterItsAnsweringTime();
    void slowAnswersComeLate();
    void lostAnswersWereCarriedOut();
    void cutAnswersLackTheirEnd();
    void aDroppedConnectionIsSilence();
    void savingSilencesTheSensor();
    void inItsMenuTheSensorIsNotReady();
    void settingsMadeOverTcpCountOnTheLine();

private:
    void start(const StationOptions& options);
    QByteArray ask(const QByteArray& bytes, qint64 patienceMs = 1000)
    {
        m_terminal->portions.clear();
        Q_EMIT m_terminal->received(bytes);
        m_clock->advanceMs(patienceMs);
        return m_terminal->taken();
    }
    FaultDesk& faults() { return m_station->faults(); }

    std::unique_ptr<ManualClock> m_clock;
    std::unique_ptr<FakeTerminal> m_terminal;
    std::unique_ptr<RtuLine> m_line;
    std::unique_ptr<SensorStation> m_station;
};

void RtuStationTest::start(const StationOptions& options)
{
    cleanup();
    m_clock = std::make_unique<ManualClock>();
    m_terminal = std::make_unique<FakeTerminal>(*m_clock);
    m_line = std::make_unique<RtuLine>(*m_terminal, *m_clock);
    auto station = SensorStation::prepare(options, *m_clock);
    QVERIFY2(station.has_value(), station ? "" : qPrintable(station.error().message));
    m_station = std::move(*station);
    m_line->attach(m_station->rtuUnit());
}

void RtuStationTest::cleanup()
{
    m_station.reset();
    m_line.reset();
    m_terminal.reset();
    m_clock.reset();
}

void RtuStationTest::theUnitIsTheSensorsAddressUntilAPowerCycle()
{
    StationOptions options;
    options.unit = 99;
    start(options);
    QCOMPARE(ask(readSpan(1)), QByteArray());
    QCOMPARE(ask(readRegisters(99, deviceAddress, 1)), frame(99, hex("03 02 0063")));
    QCOMPARE(m_station->sensor().savedMemory().value(ItemId::DeviceAddress), 1);
    m_station->sensor().powerCycle();
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuStationTest::answersAfterItsAnsweringTime()
{
    StationOptions options;
    options.answeringTimeMs = 40;
    start(options);
    QCOMPARE(ask(readSpan(1), 44), QByteArray()); // 4 ms of request and silence before
    QCOMPARE(ask({}, 10), spanAnswer(1));
}

void RtuStationTest::slowAnswersComeLate()
{
    faults().switchOn(NamedFault::SlowAnswers, By::Person, 80);
    QCOMPARE(ask(readSpan(1), 84), QByteArray());
    QCOMPARE(ask({}, 10), spanAnswer(1));
    faults().switchOff(NamedFault::SlowAnswers, By::Person);
    QCOMPARE(ask(readSpan(1), 10), spanAnswer(1));
}

void RtuStationTest::lostAnswersWereCarriedOut()
{
    faults().switchOn(NamedFault::AnswersLost, By::Scene);
    QCOMPARE(ask(writeRegister(1, ecoMode, 0)), QByteArray());
    QCOMPARE(m_station->sensor().writeCount(ItemId::EcoMode), 1);
    faults().switchOff(NamedFault::AnswersLost, By::Scene);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuStationTest::cutAnswersLackTheirEnd()
{
    faults().switchOn(NamedFault::AnswersCut, By::Person);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1).chopped(2));
}

void RtuStationTest::aDroppedConnectionIsSilence()
{
    faults().switchOn(NamedFault::ConnectionDropped, By::Person);
    QCOMPARE(ask(writeRegister(1, ecoMode, 0)), QByteArray());
    QCOMPARE(m_station->sensor().writeCount(ItemId::EcoMode), 0);
    faults().switchOff(NamedFault::ConnectionDropped, By::Person);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuStationTest::savingSilencesTheSensor()
{
    faults().switchOn(NamedFault::Saving, By::Person, 700);
    QCOMPARE(ask(readSpan(1), 700), QByteArray());
    QCOMPARE(ask({}, 10), spanAnswer(1));
}

void RtuStationTest::inItsMenuTheSensorIsNotReady()
{
    faults().switchOn(NamedFault::InMenu, By::Person);
    QCOMPARE(ask(readSpan(1)), frame(1, hex("83 04")));
}

void RtuStationTest::settingsMadeOverTcpCountOnTheLine()
{
    ModbusResponder& tcp = m_station->modbusServer().responder();
    tcp.answer(hex("06 00a8 0011")); // Device Address 17
    QCOMPARE(ask(readSpan(17)), QByteArray());
    tcp.answer(hex("06 00aa 0000")); // communication reset
    QCOMPARE(ask(readSpan(17)), spanAnswer(17));
}

QTEST_GUILESS_MAIN(RtuStationTest)
#include "tst_rtu_station.moc"
