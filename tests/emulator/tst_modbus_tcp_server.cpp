#include "manual_clock.h"
#include "modbus_tcp_server.h"
#include "raw_client.h"
#include "sensor_station.h"

#include <QSignalSpy>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;
using lds::test::RawClient;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// Reads the span (400116), so that every answer tells which request it belongs to.
QByteArray readSpan(quint8 transaction)
{
    return hex("aa") + char(transaction) + hex("0000 0006 07 03 0073 0002");
}
QByteArray spanAnswer(quint8 transaction)
{
    return hex("aa") + char(transaction) + hex("0000 0007 07 03 04 2710 0000");
}
QByteArray writeEco(quint8 transaction, quint8 value)
{
    return hex("bb") + char(transaction) + hex("0000 0006 01 06 006c 00") + char(value);
}

} // namespace

class ModbusTcpServerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void answersWithTheTransactionAndUnitOfTheRequest();
    void illegalRequestsAreAnsweredWithTheirErrorCode();
    void answersARequestThatArrivesByteByByte();
    void answersPipelinedRequestsInOrder();
    void discardsForeignProtocolsAndShortMessagesSilently();
    void discardsAMessageLongerThanItsLengthField();
    void discardsAMessageThatStopsHalfWay();
    void aByteInTimeKeepsTheMessageAlive();
    void closesTheConnectionOverMoreThan270Bytes_data();
    void closesTheConnectionOverMoreThan270Bytes();
    void servesSeveralClientsOnBothPorts();
    void closesTheSeventeenthClient();
    void aClientThatLeavesMakesRoom();
    void aClientThatNeverReadsIsCutOff();

    void aDroppedAnswerToAWriteWasCarriedOut();
    void anIgnoredRequestWasNotCarriedOut();
    void faultsWaitForTheKindOfRequestTheyAreMeantFor();
    void aCutAnswerLacksItsEnd();
    void aWrongTransactionIsNotTheRequests();
    void closingBeforeAndAfterCarryingOut();
    void delayedAnswersComeLaterAndInOrder();
    void silenceKeepsTheConnectionAndAnswersNothing();
    void savingSilencesTheSensor();
    void countsRequestsByFunctionCode();
    void aTakenPortIsToldByNumber();

private:
    std::unique_ptr<RawClient> connectTo(ModbusTcpServer& server);
    ModbusTcpServer& server() { return m_station->modbusServer(); }
    /// Beside the one by which the sensor follows the clock.
    int serverTimers() const { return m_clock->pending() - m_sensorTimers; }

    int m_sensorTimers = 0;
    std::unique_ptr<ManualClock> m_clock;
    std::unique_ptr<SensorStation> m_station;
    std::unique_ptr<RawClient> m_client;
};

void ModbusTcpServerTest::init()
{
    m_clock = std::make_unique<ManualClock>();
    StationOptions options;
    options.modbusPort = 0;
    options.toolPort = 0;
    auto station = SensorStation::start(options, *m_clock);
    QVERIFY(station.has_value());
    m_station = std::move(*station);
    m_sensorTimers = m_clock->pending();
    m_client = connectTo(server());
    QTRY_VERIFY(m_client->isConnected() && server().clientCount() == 1);
}

void ModbusTcpServerTest::cleanup()
{
    m_client.reset();
    m_station.reset();
}

std::unique_ptr<RawClient> ModbusTcpServerTest::connectTo(ModbusTcpServer& target)
{
    return std::make_unique<RawClient>(target.port());
}

void ModbusTcpServerTest::answersWithTheTransactionAndUnitOfTheRequest()
{
    m_client->send(hex("1234 0000 0006 f7 03 0073 0002"));
    QTRY_COMPARE(m_client->received(), hex("1234 0000 0007 f7 03 04 2710 0000"));
}

void ModbusTcpServerTest::illegalRequestsAreAnsweredWithTheirErrorCode()
{
    m_client->send(hex("0001 0000 0006 01 04 0000 0001"));
    QTRY_COMPARE(m_client->received(), hex("0001 0000 0003 01 84 01"));
    m_client->send(hex("0002 0000 0006 01 03 0380 0001"));
    QTRY_COMPARE(m_client->received().mid(9), hex("0002 0000 0003 01 83 02"));
    m_client->send(hex("0003 0000 0006 01 06 006c 0002"));
    QTRY_COMPARE(m_client->received().mid(18), hex("0003 0000 0003 01 86 03"));
    m_station->sensor().setInMenu(true);
    m_client->send(readSpan(4));
    QTRY_COMPARE(m_client->received().mid(27), hex("aa04 0000 0003 07 83 04"));
}

void ModbusTcpServerTest::answersARequestThatArrivesByteByByte()
{
    const QByteArray request = readSpan(1);
    for (qsizetype i = 0; i < request.size(); ++i) {
        m_clock->advanceMs(99); // each byte just before the pause would end the message
        m_client->send(request.mid(i, 1));
        QTRY_COMPARE(server().receivedBytes(), i + 1);
    }
    QTRY_COMPARE(m_client->received(), spanAnswer(1));
}

void ModbusTcpServerTest::answersPipelinedRequestsInOrder()
{
    m_client->send(readSpan(1) + readSpan(2) + readSpan(3));
    QTRY_COMPARE(m_client->received(), spanAnswer(1) + spanAnswer(2) + spanAnswer(3));
}

void ModbusTcpServerTest::discardsForeignProtocolsAndShortMessagesSilently()
{
    m_client->send(hex("0001 0001 0006 01 03 0064 0002"));
    m_client->send(hex("0002 0000 0005 01 03 0064 00"));
    m_client->send(readSpan(3)); // answered, so the ones before were passed by
    QTRY_COMPARE(m_client->received(), spanAnswer(3));
    QCOMPARE(server().totalRequestCount(), 1);
}

void ModbusTcpServerTest::discardsAMessageLongerThanItsLengthField()
{
    m_client->send(readSpan(1) + "xx");
    QTRY_COMPARE(serverTimers(), 1);
    m_clock->advanceMs(100);
    m_client->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(2));
    QCOMPARE(server().totalRequestCount(), 1);
}

void ModbusTcpServerTest::discardsAMessageThatStopsHalfWay()
{
    m_client->send(readSpan(1).left(9));
    QTRY_COMPARE(serverTimers(), 1);
    m_clock->advanceMs(100);
    QCOMPARE(serverTimers(), 0);
    m_client->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(2));
}

void ModbusTcpServerTest::aByteInTimeKeepsTheMessageAlive()
{
    m_client->send(readSpan(1).left(9));
    QTRY_COMPARE(serverTimers(), 1);
    m_clock->advanceMs(99);
    m_client->send(readSpan(1).mid(9));
    QTRY_COMPARE(m_client->received(), spanAnswer(1));
    QCOMPARE(serverTimers(), 0);
}

void ModbusTcpServerTest::closesTheConnectionOverMoreThan270Bytes_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("by its length field") << hex("0001 0000 0109 01");
    QTest::newRow("by what arrives") << QByteArray(271, '\0') + 'x';
    QTest::newRow("another protocol altogether") << QByteArray("GET / HTTP/1.1\r\n\r\n");
}

void ModbusTcpServerTest::closesTheConnectionOverMoreThan270Bytes()
{
    QFETCH(QByteArray, bytes);
    m_client->send(bytes);
    QTRY_VERIFY(m_client->isClosed());
    QCOMPARE(m_client->received(), QByteArray());
    QTRY_COMPARE(server().clientCount(), 0);
}

void ModbusTcpServerTest::servesSeveralClientsOnBothPorts()
{
    const auto another = connectTo(server());
    const auto tool = connectTo(m_station->toolServer());
    QTRY_VERIFY(another->isConnected() && tool->isConnected());
    m_client->send(writeEco(1, 0));
    QTRY_VERIFY(!m_client->received().isEmpty());
    const QByteArray readEco = hex("0009 0000 0006 01 03 006c 0001");
    const QByteArray ecoOff = hex("0009 0000 0005 01 03 02 0000");
    another->send(readEco);
    tool->send(readEco);
    QTRY_COMPARE(another->received(), ecoOff);
    QTRY_COMPARE(tool->received(), ecoOff);
    QVERIFY(*m_station->modbusPort() != *m_station->toolPort());
    QCOMPARE(server().totalRequestCount(), 2);
    QCOMPARE(m_station->toolServer().totalRequestCount(), 1);
}

void ModbusTcpServerTest::closesTheSeventeenthClient()
{
    std::vector<std::unique_ptr<RawClient>> clients;
    for (int i = 1; i < ModbusTcpServer::mostClients; ++i)
        clients.push_back(connectTo(server()));
    QTRY_COMPARE(server().clientCount(), 16);
    const auto tooMany = connectTo(server());
    const QSignalSpy closed(&tooMany->socket(), &QTcpSocket::disconnected);
    QTRY_COMPARE(closed.size(), 1);
    QCOMPARE(server().clientCount(), 16);
    m_client->send(readSpan(1));
    clients.back()->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(1));
    QTRY_COMPARE(clients.back()->received(), spanAnswer(2));
}

void ModbusTcpServerTest::aClientThatLeavesMakesRoom()
{
    m_client.reset();
    QTRY_COMPARE(server().clientCount(), 0);
}

void ModbusTcpServerTest::aClientThatNeverReadsIsCutOff()
{
    server().setAnswerDelay(1'000'000); // as good as never taken
    const QByteArray longRead = hex("0001 0000 0006 01 03 000a 007d");
    for (int i = 0; i < 300; ++i)
        m_client->send(longRead);
    QTRY_VERIFY(m_client->isClosed());
}

void ModbusTcpServerTest::aDroppedAnswerToAWriteWasCarriedOut()
{
    server().injectFault(Fault::DropAnswer);
    m_client->send(writeEco(1, 0));
    m_client->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(2));
    QCOMPARE(m_station->sensor().writeCount(ItemId::EcoMode), 1);
    QCOMPARE(m_station->sensor().read(ItemId::EcoMode), 0);
}

void ModbusTcpServerTest::anIgnoredRequestWasNotCarriedOut()
{
    server().injectFault(Fault::IgnoreRequest);
    m_client->send(writeEco(1, 0));
    m_client->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(2));
    QCOMPARE(m_station->sensor().writeCount(ItemId::EcoMode), 0);
    QCOMPARE(m_station->sensor().read(ItemId::EcoMode), 1);
}

void ModbusTcpServerTest::faultsWaitForTheKindOfRequestTheyAreMeantFor()
{
    server().injectFault(Fault::DropAnswer, FaultOn::Writes, 2);
    m_client->send(readSpan(1));
    QTRY_COMPARE(m_client->received(), spanAnswer(1));
    QCOMPARE(server().faultsWaiting(), 2);
    m_client->send(writeEco(2, 0));
    m_client->send(readSpan(3));
    m_client->send(writeEco(4, 1));
    m_client->send(writeEco(5, 0));
    QTRY_COMPARE(m_client->received(), spanAnswer(1) + spanAnswer(3) + writeEco(5, 0));
    QCOMPARE(server().faultsWaiting(), 0);
}

void ModbusTcpServerTest::aCutAnswerLacksItsEnd()
{
    server().injectFault(Fault::CutAnswer);
    m_client->send(readSpan(1));
    QTRY_COMPARE(m_client->received(), spanAnswer(1).chopped(2));
}

void ModbusTcpServerTest::aWrongTransactionIsNotTheRequests()
{
    server().injectFault(Fault::WrongTransaction);
    m_client->send(readSpan(1));
    QTRY_COMPARE(m_client->received().size(), spanAnswer(1).size());
    QVERIFY(m_client->received().left(2) != spanAnswer(1).left(2));
    QCOMPARE(m_client->received().mid(2), spanAnswer(1).mid(2));
}

void ModbusTcpServerTest::closingBeforeAndAfterCarryingOut()
{
    server().injectFault(Fault::CloseBeforeCarryOut);
    m_client->send(writeEco(1, 0));
    QTRY_VERIFY(m_client->isClosed());
    QCOMPARE(m_station->sensor().read(ItemId::EcoMode), 1);
    m_client = connectTo(server());
    server().injectFault(Fault::CloseAfterCarryOut);
    QTRY_VERIFY(m_client->isConnected());
    m_client->send(writeEco(2, 0));
    QTRY_VERIFY(m_client->isClosed());
    QCOMPARE(m_client->received(), QByteArray());
    QCOMPARE(m_station->sensor().read(ItemId::EcoMode), 0);
}

void ModbusTcpServerTest::delayedAnswersComeLaterAndInOrder()
{
    server().setAnswerDelay(50);
    m_client->send(readSpan(1));
    QTRY_COMPARE(serverTimers(), 1);
    m_clock->advanceMs(20);
    server().setAnswerDelay(0);
    m_client->send(readSpan(2)); // does not overtake
    QTRY_COMPARE(server().totalRequestCount(), 2);
    QCOMPARE(m_client->received(), QByteArray());
    m_clock->advanceMs(29);
    QCOMPARE(serverTimers(), 1);
    m_clock->advanceMs(1);
    QTRY_COMPARE(m_client->received(), spanAnswer(1) + spanAnswer(2));
}

void ModbusTcpServerTest::silenceKeepsTheConnectionAndAnswersNothing()
{
    server().setSilent(true);
    m_client->send(writeEco(1, 0));
    QTRY_COMPARE(server().totalRequestCount(), 1);
    server().setSilent(false);
    m_client->send(readSpan(2));
    QTRY_COMPARE(m_client->received(), spanAnswer(2));
    QCOMPARE(m_station->sensor().totalWriteCount(), 0);
}

void ModbusTcpServerTest::savingSilencesTheSensor()
{
    m_station->sensor().setSavingDuration(700);
    const QByteArray save = hex("0001 0000 0006 01 06 0035 0000");
    m_client->send(save);
    QTRY_COMPARE(serverTimers(), 1);
    m_clock->advanceMs(699);
    QCOMPARE(serverTimers(), 1);
    m_clock->advanceMs(1);
    QTRY_COMPARE(m_client->received(), save); // the echo
}

void ModbusTcpServerTest::countsRequestsByFunctionCode()
{
    m_client->send(readSpan(1) + readSpan(2) + writeEco(3, 1) + hex("0004 0000 0006 01 07 0000 0000"));
    QTRY_COMPARE(server().totalRequestCount(), 4);
    QCOMPARE(server().requestCount(0x03), 2);
    QCOMPARE(server().requestCount(0x06), 1);
    QCOMPARE(server().requestCount(0x07), 1);
    QCOMPARE(server().requestCount(0x10), 0);
    server().resetCounts();
    QCOMPARE(server().totalRequestCount(), 0);
}

void ModbusTcpServerTest::aTakenPortIsToldByNumber()
{
    StationOptions options;
    options.toolPort = m_station->toolPort();
    const auto second = SensorStation::start(options, *m_clock);
    QVERIFY(!second.has_value());
    QCOMPARE(second.error().kind, StationProblem::Kind::Listen);
    QVERIFY2(second.error().message.contains(QString::number(*options.toolPort)),
             qPrintable(second.error().message));
}

QTEST_GUILESS_MAIN(ModbusTcpServerTest)
#include "tst_modbus_tcp_server.moc"
