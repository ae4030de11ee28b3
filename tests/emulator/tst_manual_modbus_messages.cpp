// §5.2.2 and §5.2.3: every kind of message, byte by byte as the manual's tables have them, over a socket.
#include "manual_clock.h"
#include "modbus_tcp_server.h"
#include "virtual_sensor.h"

#include <QTcpSocket>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

} // namespace

class ManualModbusMessagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void requestAndResponse_data();
    void requestAndResponse();
    void notReadyIsOtherErrorForEveryFunction_data();
    void notReadyIsOtherErrorForEveryFunction();
    void aWriteThatFailsIsOtherError_data();
    void aWriteThatFailsIsOtherError();
    void transactionAndUnitComeBackWhateverTheyAre_data();
    void transactionAndUnitComeBackWhateverTheyAre();
    void lengthCountsFromTheUnitIdentifier();

private:
    std::unique_ptr<ManualClock> m_clock;
    std::unique_ptr<VirtualSensor> m_sensor;
    std::unique_ptr<ModbusTcpServer> m_server;
    std::unique_ptr<QTcpSocket> m_socket;
    QByteArray m_received;
};

void ManualModbusMessagesTest::init()
{
    m_clock = std::make_unique<ManualClock>();
    m_sensor = std::make_unique<VirtualSensor>(SensorModel::HlG203, *m_clock);
    m_sensor->placeWorkpiece(12'345);
    m_server = std::make_unique<ModbusTcpServer>(*m_sensor, *m_clock);
    QVERIFY(m_server->listen(QHostAddress::LocalHost, 0).has_value());
    m_received.clear();
    m_socket = std::make_unique<QTcpSocket>();
    connect(m_socket.get(), &QTcpSocket::readyRead, this, [this] { m_received += m_socket->readAll(); });
    m_socket->connectToHost(QHostAddress::LocalHost, m_server->port());
    QTRY_COMPARE(m_server->clientCount(), 1);
}

void ManualModbusMessagesTest::cleanup()
{
    m_socket.reset();
    m_server.reset();
    m_sensor.reset();
}

void ManualModbusMessagesTest::requestAndResponse_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("response");
    const auto row = [](const char* name, const char* request, const char* response) {
        QTest::newRow(name) << hex(request) << hex(response);
    };
    // transaction, protocol, length, unit, function, …
    row("01 one coil: GO", "0102 0000 0006 11 01 0003 0001", "0102 0000 0004 11 01 01 01");
    row("01 coils 1 to 16: GO, GO at timer OFF, laser", "0102 0000 0006 11 01 0000 0010",
        "0102 0000 0005 11 01 02 48 04");
    row("01 nine coils fill two bytes", "0102 0000 0006 11 01 0002 0009", "0102 0000 0005 11 01 02 12 01");
    row("01 coils beyond the list read as 0", "0102 0000 0006 11 01 003e 0004", "0102 0000 0004 11 01 01 00");
    row("01 the last coil", "0102 0000 0006 11 01 003f 0001", "0102 0000 0004 11 01 01 00");
    row("81 02 no such coil", "0102 0000 0006 11 01 0040 0001", "0102 0000 0003 11 81 02");
    row("81 03 no coil", "0102 0000 0006 11 01 0000 0000", "0102 0000 0003 11 81 03");
    row("81 03 more than 2000 coils", "0102 0000 0006 11 01 0000 07d1", "0102 0000 0003 11 81 03");
    row("81 03 message too long", "0102 0000 0007 11 01 0000 0001 00", "0102 0000 0003 11 81 03");

    row("03 measured value", "0203 0000 0006 22 03 0013 0002", "0203 0000 0007 22 03 04 3039 0000");
    row("03 one register", "0203 0000 0006 22 03 0071 0001", "0203 0000 0005 22 03 02 0005");
    row("03 a 1-byte register takes 2 bytes", "0203 0000 0006 22 03 0039 0001",
        "0203 0000 0005 22 03 02 0001");
    row("03 addresses that do not exist read as 0", "0203 0000 0006 22 03 006a 0003",
        "0203 0000 0009 22 03 06 0000 0000 0001");
    row("83 02 no such register", "0203 0000 0006 22 03 0384 0001", "0203 0000 0003 22 83 02");
    row("83 02 write only", "0203 0000 0006 22 03 0035 0001", "0203 0000 0003 22 83 02");
    row("83 02 usage prohibited", "0203 0000 0006 22 03 0034 0001", "0203 0000 0003 22 83 02");
    row("83 03 no register", "0203 0000 0006 22 03 0064 0000", "0203 0000 0003 22 83 03");
    row("83 03 more than 125 registers", "0203 0000 0006 22 03 0064 007e", "0203 0000 0003 22 83 03");

    row("06 alarm delay count", "0306 0000 0006 33 06 006d 0020", "0306 0000 0006 33 06 006d 0020");
    row("06 a command", "0306 0000 0006 33 06 0037 0000", "0306 0000 0006 33 06 0037 0000");
    row("86 02 no such register", "0306 0000 0006 33 06 006a 0000", "0306 0000 0003 33 86 02");
    row("86 02 read only", "0306 0000 0006 33 06 0080 0000", "0306 0000 0003 33 86 02");
    row("86 02 usage prohibited", "0306 0000 0006 33 06 0032 0000", "0306 0000 0003 33 86 02");
    row("86 03 out of range", "0306 0000 0006 33 06 0072 0004", "0306 0000 0003 33 86 03");
    row("86 03 inconsistent", "0306 0000 0006 33 06 0098 c000", "0306 0000 0003 33 86 03");
    row("86 03 half of 4 bytes", "0306 0000 0006 33 06 0064 0001", "0306 0000 0003 33 86 03");

    row("10 HIGH and LOW", "0410 0000 000f 44 10 0064 0004 08 9c40 0000 63c0 ffff",
        "0410 0000 0006 44 10 0064 0004");
    row("10 addresses that do not exist are ignored", "0410 0000 000b 44 10 006a 0002 04 ffff 0001",
        "0410 0000 0006 44 10 006a 0002");
    row("10 read-only addresses are ignored", "0410 0000 000d 44 10 0080 0003 06 0000 0000 0001",
        "0410 0000 0006 44 10 0080 0003");
    row("90 03 more data than registers", "0410 0000 000b 44 10 006c 0001 02 0001 0000",
        "0410 0000 0003 44 90 03");
    row("90 02 no such register", "0410 0000 0009 44 10 006a 0001 02 0001", "0410 0000 0003 44 90 02");
    row("90 02 read only", "0410 0000 0009 44 10 000a 0001 02 0001", "0410 0000 0003 44 90 02");
    row("90 02 usage prohibited among others", "0410 0000 000b 44 10 0033 0002 04 0001 0000",
        "0410 0000 0003 44 90 02");
    row("90 03 out of range", "0410 0000 0009 44 10 006c 0001 02 0002", "0410 0000 0003 44 90 03");
    row("90 03 inconsistent: HIGH below LOW", "0410 0000 000f 44 10 0064 0004 08 63c0 ffff 9c40 0000",
        "0410 0000 0003 44 90 03");
    row("90 03 half of 4 bytes", "0410 0000 0009 44 10 0064 0001 02 0001", "0410 0000 0003 44 90 03");
    row("90 03 no register", "0410 0000 0007 44 10 0064 0000 00", "0410 0000 0003 44 90 03");
    row("90 03 bytes do not match the registers", "0410 0000 0009 44 10 006c 0002 02 0001",
        "0410 0000 0003 44 90 03");
    QTest::newRow("90 02 123 registers, one of them prohibited")
        << hex("0410 0000 00fd 44 10 0000 007b f6") + QByteArray(246, '\0') << hex("0410 0000 0003 44 90 02");
    QTest::newRow("90 03 more than 123 registers")
        << hex("0410 0000 00ff 44 10 0000 007c f8") + QByteArray(248, '\0') << hex("0410 0000 0003 44 90 03");

    row("82 01 another function", "0504 0000 0006 55 02 0000 0001", "0504 0000 0003 55 82 01");
    row("84 01 another function", "0504 0000 0006 55 04 0000 0001", "0504 0000 0003 55 84 01");
    row("85 01 another function", "0504 0000 0006 55 05 0000 ff00", "0504 0000 0003 55 85 01");
    row("8f 01 another function", "0504 0000 0008 55 0f 0000 0001 01 01", "0504 0000 0003 55 8f 01");
}

void ManualModbusMessagesTest::requestAndResponse()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, response);
    m_socket->write(request);
    QTRY_COMPARE(m_received.toHex(' '), response.toHex(' '));
}

void ManualModbusMessagesTest::notReadyIsOtherErrorForEveryFunction_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("response");
    QTest::newRow("01") << hex("0001 0000 0006 01 01 0000 0001") << hex("0001 0000 0003 01 81 04");
    QTest::newRow("03") << hex("0001 0000 0006 01 03 0064 0002") << hex("0001 0000 0003 01 83 04");
    QTest::newRow("06") << hex("0001 0000 0006 01 06 006c 0000") << hex("0001 0000 0003 01 86 04");
    QTest::newRow("10") << hex("0001 0000 0009 01 10 006c 0001 02 0000") << hex("0001 0000 0003 01 90 04");
}

void ManualModbusMessagesTest::notReadyIsOtherErrorForEveryFunction()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, response);
    m_sensor->setInMenu(true); // not on the measurement display
    m_socket->write(request);
    QTRY_COMPARE(m_received.toHex(' '), response.toHex(' '));
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ManualModbusMessagesTest::aWriteThatFailsIsOtherError_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("response");
    QTest::newRow("06") << hex("0001 0000 0006 01 06 006d 0000") << hex("0001 0000 0003 01 86 04");
    QTest::newRow("10") << hex("0001 0000 000d 01 10 006c 0003 06 0000 0000 0001")
                        << hex("0001 0000 0003 01 90 04");
}

void ManualModbusMessagesTest::aWriteThatFailsIsOtherError()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, response);
    m_sensor->setWriteFailure(ItemId::AlarmDelayCount, true);
    m_socket->write(request);
    QTRY_COMPARE(m_received.toHex(' '), response.toHex(' '));
    QCOMPARE(m_sensor->read(ItemId::AlarmDelayCount), 8);
    QCOMPARE(m_sensor->read(ItemId::DisplayDigit), 0); // interrupted there
}

void ManualModbusMessagesTest::transactionAndUnitComeBackWhateverTheyAre_data()
{
    QTest::addColumn<QByteArray>("transaction");
    QTest::addColumn<QByteArray>("unit");
    for (const char* transaction : {"0000", "ffff", "8001"}) {
        for (const char* unit : {"00", "01", "f8", "ff"})
            QTest::addRow("%s, unit %s", transaction, unit) << hex(transaction) << hex(unit);
    }
}

void ManualModbusMessagesTest::transactionAndUnitComeBackWhateverTheyAre()
{
    QFETCH(QByteArray, transaction);
    QFETCH(QByteArray, unit);
    m_socket->write(transaction + hex("0000 0006") + unit + hex("03 0013 0002"));
    QTRY_COMPARE(m_received.toHex(' '),
                 (transaction + hex("0000 0007") + unit + hex("03 04 3039 0000")).toHex(' '));
}

void ManualModbusMessagesTest::lengthCountsFromTheUnitIdentifier()
{
    m_socket->write(hex("0001 0000 0006 01 03 000a 007d")); // 125 registers
    QTRY_COMPARE(m_received.size(), 6 + 253);
    QCOMPARE(m_received.left(9).toHex(' '), hex("0001 0000 00fd 01 03 fa").toHex(' '));
}

QTEST_GUILESS_MAIN(ManualModbusMessagesTest)
#include "tst_manual_modbus_messages.moc"
