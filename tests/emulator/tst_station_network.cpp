// Communication reset and power cycle: connections and ports (§4.8.5, §5.1.1).
#include "station_fixture.h"

#include <QSignalSpy>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;
using namespace Qt::StringLiterals;

namespace {

/// A port at which nobody listens.
quint16 freePort()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

} // namespace

class StationNetworkTest : public StationFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void nothingChangedKeepsTheConnections();
    void aSerialSettingKeepsTheConnections();
    void aChangedSettingEndsAllConnectionsAfterTheAnswer();
    void aSlowAnswerStillGoesOut();
    void nothingAfterTheResetIsCarriedOut();
    void aResetByKeysEndsTheConnectionsToo();
    void aServerMovesToItsNewPort();
    void theAddressStays();
    void serversChangePlaces();
    void aServerTakesThePlaceOfTheOther();
    void aTakenPortIsToldAndTheServerStays();
    void aServerThatWasNotAskedForDoesNotStart();
    void aPowerCycleEndsAllConnectionsAtOnce();
    void aPowerCycleBringsTheSavedPortsIntoEffect();
    void unsavedPortsAreGoneAfterAPowerCycle();

private:
    ModbusTcpServer& modbus() { return m_station->modbusServer(); }
    ModbusTcpServer& tool() { return m_station->toolServer(); }
    bool answersAt(quint16 port);
};

/// Whether somebody answers there.
bool StationNetworkTest::answersAt(quint16 port)
{
    RawClient client(port);
    [&] { QTRY_VERIFY(client.isConnected() || client.isClosed()); }();
    if (!client.isConnected())
        return false;
    client.send(readSpan(9));
    [&] { QTRY_COMPARE(client.received(), spanAnswer(9)); }();
    return client.received() == spanAnswer(9);
}

void StationNetworkTest::nothingChangedKeepsTheConnections()
{
    const auto client = connectTo(modbus());
    const QByteArray reset = writeRegister(1, communicationReset, 0);
    client->send(reset);
    QTRY_COMPARE(client->received(), reset);
    client->send(readSpan(2));
    QTRY_COMPARE(client->received(), reset + spanAnswer(2));
}

void StationNetworkTest::aSerialSettingKeepsTheConnections()
{
    const auto client = connectTo(modbus());
    const QByteArray messages =
        writeRegister(1, 400169, 7) + writeRegister(2, communicationReset, 0); // device address
    client->send(messages);
    QTRY_COMPARE(client->received(), messages);
    QCOMPARE(sensor().activeValue(ItemId::DeviceAddress), 7);
    client->send(readSpan(3));
    QTRY_COMPARE(client->received(), messages + spanAnswer(3));
}

void StationNetworkTest::aChangedSettingEndsAllConnectionsAfterTheAnswer()
{
    const auto client = connectTo(modbus());
    const auto idle = connectTo(modbus());
    const auto other = connectTo(tool());
    const QByteArray write = writeRegister(1, 400155, 99); // the last octet of the address
    client->send(write);
    QTRY_COMPARE(client->received(), write);
    QVERIFY(other->isConnected()); // it counts after the reset
    const QByteArray reset = writeRegister(2, communicationReset, 0);
    client->send(reset);
    QTRY_VERIFY(client->isClosed() && idle->isClosed() && other->isClosed());
    QCOMPARE(client->received(), write + reset);
    QVERIFY(answersAt(modbus().port())); // the ports did not change
    QVERIFY(answersAt(tool().port()));
}

void StationNetworkTest::aSlowAnswerStillGoesOut()
{
    const auto client = connectTo(modbus());
    const auto other = connectTo(tool());
    client->send(writeRegister(1, 400155, 99));
    QTRY_COMPARE(client->received().size(), 12);
    faults().switchOn(NamedFault::SlowAnswers, FaultDesk::By::Person, 500);
    client->send(writeRegister(2, communicationReset, 0));
    QTRY_VERIFY(other->isClosed());
    QVERIFY(client->isConnected());
    m_clock->advanceMs(500);
    QTRY_VERIFY(client->isClosed());
    QCOMPARE(client->received().mid(12), writeRegister(2, communicationReset, 0));
}

void StationNetworkTest::nothingAfterTheResetIsCarriedOut()
{
    const auto client = connectTo(modbus());
    const QByteArray messages = writeRegister(1, 400155, 99) + writeRegister(2, communicationReset, 0);
    client->send(messages + writeRegister(3, ecoMode, 0)); // in one piece
    QTRY_VERIFY(client->isClosed());
    QCOMPARE(client->received(), messages);
    QCOMPARE(sensor().writeCount(ItemId::EcoMode), 0);
}

void StationNetworkTest::aResetByKeysEndsTheConnectionsToo()
{
    const auto client = connectTo(tool());
    const auto outcome =
        sensor().writeByKeys({{ItemId::IpAddress4thOctet, 99}, {ItemId::ResettingCommunicationSettings, 0}});
    QVERIFY2(!outcome.refusal, qPrintable(outcome.reason));
    QTRY_VERIFY(client->isClosed());
}

void StationNetworkTest::aServerMovesToItsNewPort()
{
    const quint16 before = modbus().port();
    const quint16 toolBefore = tool().port();
    const quint16 after = freePort();
    const QSignalSpy told(m_station.get(), &SensorStation::networkChanged);
    const auto client = connectTo(tool());
    client->send(writeRegister(1, portModbus, after) + writeRegister(2, communicationReset, 0));
    QTRY_VERIFY(client->isClosed());
    QTRY_COMPARE(modbus().port(), after);
    QCOMPARE(m_station->modbusPort(), after);
    QCOMPARE(tool().port(), toolBefore); // its setting did not change
    QVERIFY(answersAt(after));
    QVERIFY(!answersAt(before));
    QCOMPARE(told.size(), 1);
    QVERIFY(told.first().first().toString().contains(QString::number(after)));
}

void StationNetworkTest::theAddressStays()
{
    StationOptions options;
    options.address = QHostAddress(u"127.0.0.5"_s);
    setUp(options);
    const quint16 after = freePort();
    const auto client = connectTo(modbus());
    client->send(writeRegister(1, 400155, 77) + writeRegister(2, portModbus, after) +
                 writeRegister(3, communicationReset, 0));
    QTRY_VERIFY(client->isClosed());
    QTRY_COMPARE(modbus().port(), after);
    QCOMPARE(modbus().address(), options.address);
    const auto again = connectTo(modbus());
    again->send(readSpan(1));
    QTRY_COMPARE(again->received(), spanAnswer(1));
}

void StationNetworkTest::serversChangePlaces()
{
    const quint16 first = modbus().port();
    const quint16 second = tool().port();
    sensor().changeByKeypad(ItemId::PortModbus, second);
    sensor().changeByKeypad(ItemId::PortTool, first);
    QVERIFY(!sensor().write({{ItemId::ResettingCommunicationSettings, 0}}).refusal);
    QTRY_COMPARE(modbus().port(), second);
    QTRY_COMPARE(tool().port(), first);
    QVERIFY(answersAt(first) && answersAt(second));
}

void StationNetworkTest::aServerTakesThePlaceOfTheOther()
{
    const quint16 place = tool().port();
    const quint16 elsewhere = freePort();
    sensor().changeByKeypad(ItemId::PortModbus, place);
    sensor().changeByKeypad(ItemId::PortTool, elsewhere);
    QVERIFY(!sensor().write({{ItemId::ResettingCommunicationSettings, 0}}).refusal);
    QTRY_COMPARE(modbus().port(), place);
    QCOMPARE(tool().port(), elsewhere);
}

void StationNetworkTest::aTakenPortIsToldAndTheServerStays()
{
    QTcpServer taken;
    QVERIFY(taken.listen(QHostAddress::LocalHost));
    const quint16 before = modbus().port();
    const QSignalSpy told(m_station.get(), &SensorStation::networkChanged);
    const auto client = connectTo(modbus());
    client->send(writeRegister(1, portModbus, taken.serverPort()) + writeRegister(2, communicationReset, 0));
    QTRY_COMPARE(told.size(), 1);
    const QString message = told.first().first().toString();
    QVERIFY2(message.contains(QString::number(taken.serverPort())) &&
                 message.contains(u"it stays on port %1"_s.arg(before)),
             qPrintable(message));
    QCOMPARE(modbus().port(), before);
    QVERIFY(answersAt(before));
}

void StationNetworkTest::aServerThatWasNotAskedForDoesNotStart()
{
    auto station = SensorStation::start({}, *m_clock);
    QVERIFY(station.has_value());
    VirtualSensor& alone = (*station)->sensor();
    alone.changeByKeypad(ItemId::PortModbus, freePort());
    const QSignalSpy told(station->get(), &SensorStation::networkChanged);
    alone.powerCycle();
    QCoreApplication::processEvents();
    QCOMPARE((*station)->modbusPort(), std::nullopt);
    QCOMPARE(told.size(), 0);
}

void StationNetworkTest::aPowerCycleEndsAllConnectionsAtOnce()
{
    const auto client = connectTo(modbus());
    const auto other = connectTo(tool());
    faults().switchOn(NamedFault::SlowAnswers, FaultDesk::By::Person, 500);
    client->send(readSpan(1));
    QTRY_COMPARE(modbus().totalRequestCount(), 1);
    sensor().powerCycle();
    QTRY_VERIFY(client->isClosed() && other->isClosed());
    QCOMPARE(client->received(), QByteArray());
    faults().switchOff(NamedFault::SlowAnswers, FaultDesk::By::Person);
    QVERIFY(answersAt(modbus().port())); // and it is back
}

void StationNetworkTest::aPowerCycleBringsTheSavedPortsIntoEffect()
{
    const quint16 after = freePort();
    const auto client = connectTo(modbus());
    const QByteArray messages = writeRegister(1, portTool, after) + writeRegister(2, setValueSaving, 0);
    client->send(messages);
    QTRY_COMPARE(client->received(), messages);
    QVERIFY(tool().port() != after);
    sensor().powerCycle();
    QTRY_COMPARE(tool().port(), after);
}

void StationNetworkTest::unsavedPortsAreGoneAfterAPowerCycle()
{
    const quint16 before = modbus().port();
    const auto client = connectTo(modbus());
    const QByteArray write = writeRegister(1, portModbus, freePort());
    client->send(write);
    QTRY_COMPARE(client->received(), write);
    sensor().powerCycle();
    QTRY_VERIFY(client->isClosed());
    QCoreApplication::processEvents();
    QCOMPARE(modbus().port(), before);
}

QTEST_GUILESS_MAIN(StationNetworkTest)
#include "tst_station_network.moc"
