// What each named fault does to a sensor and its servers, and who has it on.
#include "station_fixture.h"

#include <QSignalSpy>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;
using By = FaultDesk::By;

class FaultDeskTest : public StationFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { tearDown(); }

    void aFaultOfTheSensorShowsInItsState_data();
    void aFaultOfTheSensorShowsInItsState();
    void inItsMenuTheSensorIsNotReady();
    void slowAnswersComeLateFromEveryServer();
    void lostAnswersWereCarriedOut();
    void cutAnswersLackTheirEnd();
    void aDroppedConnectionEndsAndNobodyGetsANewOne();
    void savingSilencesTheSensorAndGoesOffByItself();
    void savingCannotBeCutShort();
    void aPowerCycleEndsSavingOnly();
    void aFaultIsOnWhileThePersonOrTheSceneHasItOn();
    void theLongestDelayCounts();
    void millisecondsAreBounded();
    void tellsWhenSomethingChanged();
};

void FaultDeskTest::init()
{
    setUp();
    sensor().placeWorkpiece(0);
}

void FaultDeskTest::aFaultOfTheSensorShowsInItsState_data()
{
    QTest::addColumn<NamedFault>("fault");
    QTest::addColumn<int>("coil");
    QTest::newRow("noLight") << NamedFault::NoLight << 18;
    QTest::newRow("saturated") << NamedFault::Saturated << 17;
    QTest::newRow("ambientLight") << NamedFault::AmbientLight << 20;
    QTest::newRow("outOfRange") << NamedFault::OutOfRange << 19;
    QTest::newRow("laserCircuitError") << NamedFault::LaserCircuitError << 49;
    QTest::newRow("systemError") << NamedFault::SystemError << 51;
}

void FaultDeskTest::aFaultOfTheSensorShowsInItsState()
{
    QFETCH(NamedFault, fault);
    QFETCH(int, coil);
    m_clock->advanceMs(1000);
    QVERIFY(!StationFixture::coil(coil));
    faults().switchOn(fault, By::Person);
    m_clock->advanceMs(1000);
    for (const int other : {17, 18, 19, 20, 49, 51})
        QCOMPARE(StationFixture::coil(other), other == coil);
    faults().switchOff(fault, By::Person);
    m_clock->advanceMs(2000);
    QVERIFY(!StationFixture::coil(coil));
}

void FaultDeskTest::inItsMenuTheSensorIsNotReady()
{
    const auto client = connectTo(m_station->toolServer());
    faults().switchOn(NamedFault::InMenu, By::Person);
    client->send(readSpan(1));
    QTRY_COMPARE(client->received(), hex("aa01 0000 0003 07 83 04"));
    faults().switchOff(NamedFault::InMenu, By::Person);
    client->send(readSpan(2));
    QTRY_COMPARE(client->received().mid(9), spanAnswer(2));
}

void FaultDeskTest::slowAnswersComeLateFromEveryServer()
{
    faults().switchOn(NamedFault::SlowAnswers, By::Person, 80);
    for (ModbusTcpServer* server : {&m_station->modbusServer(), &m_station->toolServer()}) {
        const auto client = connectTo(*server);
        for (quint8 time = 1; time <= 2; ++time) { // not once: as long as it is on
            const QByteArray before = client->received();
            const int count = server->totalRequestCount();
            client->send(readSpan(time));
            QTRY_COMPARE(server->totalRequestCount(), count + 1);
            m_clock->advanceMs(79);
            QCOMPARE(client->received(), before);
            m_clock->advanceMs(1);
            QTRY_COMPARE(client->received(), before + spanAnswer(time));
        }
    }
    faults().switchOff(NamedFault::SlowAnswers, By::Person);
    const auto client = connectTo(m_station->modbusServer());
    client->send(readSpan(3));
    QTRY_COMPARE(client->received(), spanAnswer(3));
}

void FaultDeskTest::lostAnswersWereCarriedOut()
{
    faults().switchOn(NamedFault::AnswersLost, By::Person);
    const auto client = connectTo(m_station->modbusServer());
    client->send(writeRegister(1, ecoMode, 0));
    QTRY_COMPARE(sensor().writeCount(ItemId::EcoMode), 1);
    client->send(writeRegister(2, ecoMode, 1));
    QTRY_COMPARE(sensor().writeCount(ItemId::EcoMode), 2);
    faults().switchOff(NamedFault::AnswersLost, By::Person);
    client->send(readSpan(3));
    QTRY_COMPARE(client->received(), spanAnswer(3)); // and nothing before it
}

void FaultDeskTest::cutAnswersLackTheirEnd()
{
    faults().switchOn(NamedFault::AnswersCut, By::Person);
    const auto client = connectTo(m_station->toolServer());
    client->send(readSpan(1) + readSpan(2));
    QTRY_COMPARE(client->received(), spanAnswer(1).chopped(2) + spanAnswer(2).chopped(2));
}

void FaultDeskTest::aDroppedConnectionEndsAndNobodyGetsANewOne()
{
    const auto modbus = connectTo(m_station->modbusServer());
    const auto tool = connectTo(m_station->toolServer());
    faults().switchOn(NamedFault::ConnectionDropped, By::Person);
    QTRY_VERIFY(modbus->isClosed() && tool->isClosed());
    for (ModbusTcpServer* server : {&m_station->modbusServer(), &m_station->toolServer()}) {
        RawClient late(server->port());
        const QSignalSpy closed(&late.socket(), &QTcpSocket::disconnected);
        QTRY_VERIFY(!closed.isEmpty() || late.socket().error() == QAbstractSocket::RemoteHostClosedError);
        QCOMPARE(server->clientCount(), 0);
    }
    faults().switchOff(NamedFault::ConnectionDropped, By::Person);
    const auto again = connectTo(m_station->modbusServer());
    again->send(readSpan(1));
    QTRY_COMPARE(again->received(), spanAnswer(1));
}

void FaultDeskTest::savingSilencesTheSensorAndGoesOffByItself()
{
    const auto client = connectTo(m_station->modbusServer());
    faults().switchOn(NamedFault::Saving, By::Person, 700);
    QVERIFY(faults().isOn(NamedFault::Saving));
    client->send(readSpan(1));
    QTRY_COMPARE(m_station->modbusServer().totalRequestCount(), 1);
    m_clock->advanceMs(699);
    QVERIFY(faults().isOn(NamedFault::Saving));
    QCOMPARE(client->received(), QByteArray());
    m_clock->advanceMs(1);
    QVERIFY(!faults().isOn(NamedFault::Saving));
    QTRY_COMPARE(client->received(), spanAnswer(1));
}

void FaultDeskTest::savingCannotBeCutShort()
{
    faults().switchOn(NamedFault::Saving, By::Person, 700);
    faults().switchOff(NamedFault::Saving, By::Person);
    QVERIFY(faults().isOn(NamedFault::Saving));
    faults().switchOn(NamedFault::Saving, By::Person, 100); // does not shorten it either
    m_clock->advanceMs(699);
    QVERIFY(faults().isOn(NamedFault::Saving));
    QCOMPARE(sensor().silentForMs(), 1);
    m_clock->advanceMs(1);
    QVERIFY(!faults().isOn(NamedFault::Saving));
}

void FaultDeskTest::aPowerCycleEndsSavingOnly()
{
    faults().switchOn(NamedFault::Saving, By::Person, 700);
    faults().switchOn(NamedFault::NoLight, By::Person);
    sensor().powerCycle();
    QVERIFY(!faults().isOn(NamedFault::Saving));
    QCOMPARE(sensor().silentForMs(), 0);
    QVERIFY(faults().isOn(NamedFault::NoLight));
    m_clock->advanceMs(1000);
    QVERIFY(coil(18));
}

void FaultDeskTest::aFaultIsOnWhileThePersonOrTheSceneHasItOn()
{
    faults().switchOn(NamedFault::InMenu, By::Person);
    faults().switchOn(NamedFault::InMenu, By::Scene);
    faults().switchOff(NamedFault::InMenu, By::Person);
    QVERIFY(!sensor().isReady());
    QVERIFY(!faults().isOn(NamedFault::InMenu, By::Person));
    QVERIFY(faults().isOn(NamedFault::InMenu, By::Scene));
    faults().switchAllOff(By::Person); // not the scene's
    QVERIFY(!sensor().isReady());
    faults().switchAllOff(By::Scene);
    QVERIFY(sensor().isReady());
    faults().switchOff(NamedFault::InMenu, By::Scene); // off already
    QVERIFY(sensor().isReady());
}

void FaultDeskTest::theLongestDelayCounts()
{
    faults().switchOn(NamedFault::SlowAnswers, By::Person, 50);
    faults().switchOn(NamedFault::SlowAnswers, By::Scene, 200);
    QCOMPARE(faults().milliseconds(NamedFault::SlowAnswers), 200);
    faults().switchOff(NamedFault::SlowAnswers, By::Scene);
    QCOMPARE(faults().milliseconds(NamedFault::SlowAnswers), 50);
    faults().switchOn(NamedFault::SlowAnswers, By::Person);
    QCOMPARE(faults().milliseconds(NamedFault::SlowAnswers), defaultMilliseconds(NamedFault::SlowAnswers));
    QCOMPARE(faults().milliseconds(NamedFault::NoLight), 0);
}

void FaultDeskTest::millisecondsAreBounded()
{
    faults().switchOn(NamedFault::SlowAnswers, By::Person, std::numeric_limits<int>::max());
    QCOMPARE(faults().milliseconds(NamedFault::SlowAnswers), FaultDesk::longestMs);
    faults().switchOn(NamedFault::SlowAnswers, By::Person, -5);
    QCOMPARE(faults().milliseconds(NamedFault::SlowAnswers), 0);
}

void FaultDeskTest::tellsWhenSomethingChanged()
{
    const QSignalSpy changed(m_station.get(), &SensorStation::stateChanged);
    faults().switchOn(NamedFault::NoLight, By::Person);
    QCOMPARE(changed.size(), 1);
    const StationState state = m_station->state();
    QCOMPARE(state.faults.size(), allFaults().size());
    QVERIFY(state.faults.at(0).fault == NamedFault::NoLight && state.faults.at(0).byPerson);
    QVERIFY(!state.faults.at(0).byScene && !state.faults.at(1).byPerson);
    faults().switchOff(NamedFault::NoLight, By::Person);
    faults().switchOff(NamedFault::NoLight, By::Person);
    QCOMPARE(changed.size(), 2);
}

QTEST_GUILESS_MAIN(FaultDeskTest)
#include "tst_fault_desk.moc"
