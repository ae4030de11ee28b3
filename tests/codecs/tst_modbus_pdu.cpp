#include "modbus_pdu.h"

#include <QRandomGenerator>
#include <QTest>

using namespace lds::modbus;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// Exception code of a refused request; 0 when it was accepted.
int refusal(const QByteArray& pdu)
{
    const auto request = decodeRequest(pdu);
    return request ? 0 : int(request.error());
}

/// What decoding `pdu` as the answer to `request` failed with; -1 when it succeeded.
int failureOf(const Request& request, const QByteArray& pdu)
{
    const auto response = decodeResponse(request, pdu);
    return response ? -1 : int(response.error().error);
}

} // namespace

class ModbusPduTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void requestsEncodeToTheirGoldenBytes_data() { goldenRequests(); }
    void requestsEncodeToTheirGoldenBytes();
    void requestsDecodeFromTheirGoldenBytes_data() { goldenRequests(); }
    void requestsDecodeFromTheirGoldenBytes();
    void illegalRequestsAreRefusedWithTheManualsErrorCode_data();
    void illegalRequestsAreRefusedWithTheManualsErrorCode();
    void responsesEncodeToTheirGoldenBytes_data() { goldenResponses(); }
    void responsesEncodeToTheirGoldenBytes();
    void responsesDecodeFromTheirGoldenBytes_data() { goldenResponses(); }
    void responsesDecodeFromTheirGoldenBytes();
    void exceptionsCarryTheFunctionCodePlus80h();
    void exceptionsDecodeWithTheirCodeEvenAnUnknownOne();
    void wrongResponsesAreNamed_data();
    void wrongResponsesAreNamed();
    void signed32BitValuesTakeBothWordOrders();
    void randomBytesAreEitherLegalOrRefused();
    void damagedResponsesAreNeverTakenForAnotherMessage();

private:
    static void goldenRequests();
    static void goldenResponses();
};

void ModbusPduTest::goldenRequests()
{
    QTest::addColumn<int>("function");
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("count");
    QTest::addColumn<QList<quint16>>("registers");
    QTest::addColumn<QByteArray>("pdu");

    QTest::newRow("coils 1-64") << 0x01 << 0 << 64 << QList<quint16>{} << hex("01 0000 0040");
    QTest::newRow("2000 coils") << 0x01 << 0xff00 << 2000 << QList<quint16>{} << hex("01 ff00 07d0");
    QTest::newRow("HIGH set value") << 0x03 << 100 << 2 << QList<quint16>{} << hex("03 0064 0002");
    QTest::newRow("125 registers") << 0x03 << 0 << 125 << QList<quint16>{} << hex("03 0000 007d");
    QTest::newRow("zero setting on") << 0x06 << 51 << 1 << QList<quint16>{1} << hex("06 0033 0001");
    QTest::newRow("HIGH and LOW") << 0x10 << 100 << 4 << QList<quint16>{0xc350, 0, 0x3cb0, 0xffff}
                                  << hex("10 0064 0004 08 c350 0000 3cb0 ffff");
}

void ModbusPduTest::requestsEncodeToTheirGoldenBytes()
{
    QFETCH(int, function);
    QFETCH(int, address);
    QFETCH(int, count);
    QFETCH(QList<quint16>, registers);
    QFETCH(QByteArray, pdu);
    QCOMPARE(encodeRequest({Function(function), quint16(address), quint16(count), registers}), pdu);
}

void ModbusPduTest::requestsDecodeFromTheirGoldenBytes()
{
    QFETCH(int, function);
    QFETCH(int, address);
    QFETCH(int, count);
    QFETCH(QList<quint16>, registers);
    QFETCH(QByteArray, pdu);
    const auto request = decodeRequest(pdu);
    QVERIFY(request.has_value());
    QCOMPARE(int(request->function), function);
    QCOMPARE(int(request->address), address);
    QCOMPARE(int(request->count), count);
    QCOMPARE(request->registers, registers);
}

void ModbusPduTest::illegalRequestsAreRefusedWithTheManualsErrorCode_data()
{
    QTest::addColumn<QByteArray>("pdu");
    QTest::addColumn<int>("code");

    QTest::newRow("nothing") << QByteArray() << 1;
    for (const int function : {0x00, 0x02, 0x04, 0x05, 0x0f, 0x17, 0x2b, 0x81, 0x83, 0xff})
        QTest::addRow("function %02x", function) << QByteArray(1, char(function)) + hex("00000001") << 1;
    QTest::newRow("function before length") << hex("02") << 1;
    QTest::newRow("coils: no count") << hex("01 0000") << 3;
    QTest::newRow("coils: one byte more") << hex("01 0000 0001 00") << 3;
    QTest::newRow("coils: none") << hex("01 0000 0000") << 3;
    QTest::newRow("coils: 2001") << hex("01 0000 07d1") << 3;
    QTest::newRow("registers: cut") << hex("03 0064 00") << 3;
    QTest::newRow("registers: none") << hex("03 0064 0000") << 3;
    QTest::newRow("registers: 126") << hex("03 0064 007e") << 3;
    QTest::newRow("write one: cut") << hex("06 0064 00") << 3;
    QTest::newRow("write one: long") << hex("06 0064 0001 00") << 3;
    QTest::newRow("write: only a function") << hex("10") << 3;
    QTest::newRow("write: none") << hex("10 0064 0000 00") << 3;
    QTest::newRow("write: 124") << hex("10 0064 007c f8") + QByteArray(248, '\0') << 3;
    QTest::newRow("write: bytes do not match the count") << hex("10 0064 0002 02 0001") << 3;
    QTest::newRow("write: odd bytes") << hex("10 0064 0001 03 000102") << 3;
    QTest::newRow("write: data missing") << hex("10 0064 0002 04 0001") << 3;
    QTest::newRow("write: data left over") << hex("10 0064 0001 02 0001 00") << 3;
    // 128 registers are 256 bytes, which a byte count of 0 would match modulo 256.
    QTest::newRow("write: count beyond a byte") << hex("10 0064 0080 00") << 3;
}

void ModbusPduTest::illegalRequestsAreRefusedWithTheManualsErrorCode()
{
    QFETCH(QByteArray, pdu);
    QFETCH(int, code);
    QCOMPARE(refusal(pdu), code);
}

void ModbusPduTest::goldenResponses()
{
    QTest::addColumn<int>("function");
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("count");
    QTest::addColumn<QList<quint16>>("registers");
    QTest::addColumn<QList<bool>>("coils");
    QTest::addColumn<QByteArray>("pdu");

    const QList<bool> ten{true, false, false, true, false, false, false, false, false, true};
    QTest::newRow("ten coils") << 0x01 << 0 << 10 << QList<quint16>{} << ten << hex("01 02 09 02");
    QTest::newRow("eight coils") << 0x01 << 8 << 8 << QList<quint16>{} << QList<bool>(8, true)
                                 << hex("01 01 ff");
    QTest::newRow("registers") << 0x03 << 100 << 2 << QList<quint16>{0xc350, 0x0000} << QList<bool>{}
                               << hex("03 04 c350 0000");
    QTest::newRow("write one") << 0x06 << 51 << 1 << QList<quint16>{1} << QList<bool>{}
                               << hex("06 0033 0001");
    QTest::newRow("write many") << 0x10 << 100 << 3 << QList<quint16>{} << QList<bool>{}
                                << hex("10 0064 0003");
}

void ModbusPduTest::responsesEncodeToTheirGoldenBytes()
{
    QFETCH(int, function);
    QFETCH(int, address);
    QFETCH(int, count);
    QFETCH(QList<quint16>, registers);
    QFETCH(QList<bool>, coils);
    QFETCH(QByteArray, pdu);
    QCOMPARE(encodeResponse({Function(function), quint16(address), quint16(count), registers, coils}), pdu);
}

void ModbusPduTest::responsesDecodeFromTheirGoldenBytes()
{
    QFETCH(int, function);
    QFETCH(int, address);
    QFETCH(int, count);
    QFETCH(QList<quint16>, registers);
    QFETCH(QList<bool>, coils);
    QFETCH(QByteArray, pdu);
    Request request{Function(function), quint16(address), quint16(count), registers};
    if (request.function == Function::WriteMultipleRegisters)
        request.registers = {1, 2, 3};
    const auto response = decodeResponse(request, pdu);
    QVERIFY(response.has_value());
    QCOMPARE(int(response->function), function);
    QCOMPARE(int(response->address), address);
    QCOMPARE(int(response->count), count);
    QCOMPARE(response->registers, registers);
    QCOMPARE(response->coils, coils);
}

void ModbusPduTest::exceptionsCarryTheFunctionCodePlus80h()
{
    QCOMPARE(encodeException(0x01, Exception::FunctionCode), hex("81 01"));
    QCOMPARE(encodeException(0x03, Exception::Address), hex("83 02"));
    QCOMPARE(encodeException(0x06, Exception::Data), hex("86 03"));
    QCOMPARE(encodeException(0x10, Exception::Other), hex("90 04"));
    QCOMPARE(encodeException(0x2b, Exception::FunctionCode), hex("ab 01"));
}

void ModbusPduTest::exceptionsDecodeWithTheirCodeEvenAnUnknownOne()
{
    const Request request{Function::ReadHoldingRegisters, 10, 1, {}};
    for (const int code : {0, 1, 2, 3, 4, 5, 11, 255}) {
        const auto response = decodeResponse(request, hex("83") + QByteArray(1, char(code)));
        QVERIFY(!response.has_value());
        QCOMPARE(response.error().error, ResponseError::Refused);
        QCOMPARE(int(response.error().exceptionCode), code);
    }
}

void ModbusPduTest::wrongResponsesAreNamed_data()
{
    QTest::addColumn<int>("function");
    QTest::addColumn<QByteArray>("pdu");
    QTest::addColumn<int>("error");

    const auto row = [](const char* name, int function, const char* pdu, ResponseError error) {
        QTest::newRow(name) << function << hex(pdu) << int(error);
    };
    row("nothing", 0x03, "", ResponseError::Empty);
    row("another function", 0x03, "01 01 00", ResponseError::Function);
    row("another function's exception", 0x03, "86 02", ResponseError::Function);
    row("exception without a code", 0x03, "83", ResponseError::Length);
    row("exception with a byte more", 0x03, "83 0200", ResponseError::Length);
    row("registers: only the function", 0x03, "03", ResponseError::Length);
    row("registers: cut", 0x03, "03 04 000100", ResponseError::Length);
    row("registers: too many", 0x03, "03 06 000100020003", ResponseError::Length);
    row("registers: byte count lies", 0x03, "03 06 00010002", ResponseError::Length);
    row("coils: too few", 0x01, "01 00", ResponseError::Length);
    row("coils: too many", 0x01, "01 02 0000", ResponseError::Length);
    row("write one: cut", 0x06, "06 0064 00", ResponseError::Length);
    row("write one: another address", 0x06, "06 0065 0007", ResponseError::Echo);
    row("write one: another value", 0x06, "06 0064 0008", ResponseError::Echo);
    row("write: another address", 0x10, "10 0063 0002", ResponseError::Echo);
    row("write: another count", 0x10, "10 0064 0001", ResponseError::Echo);
    row("write: long", 0x10, "10 0064 000200", ResponseError::Length);
}

void ModbusPduTest::wrongResponsesAreNamed()
{
    QFETCH(int, function);
    QFETCH(QByteArray, pdu);
    QFETCH(int, error);
    Request request{Function(function), 0x64, 2, {}};
    if (request.function == Function::WriteSingleRegister)
        request.registers = {7};
    else if (request.function == Function::WriteMultipleRegisters)
        request.registers = {7, 8};
    QCOMPARE(failureOf(request, pdu), error);
}

void ModbusPduTest::signed32BitValuesTakeBothWordOrders()
{
    QCOMPARE(toInt32(0x7ffe, 0xff6d, true), -9'601'026);
    for (const qint32 value : {0, 1, -1, 50'000, 95'000, -950'000, 9'999'999, -9'999'999, INT_MAX, INT_MIN}) {
        const QList<quint16> low = fromInt32(value, true);
        const QList<quint16> high = fromInt32(value, false);
        QCOMPARE(low.size(), 2);
        QCOMPARE(low.first(), quint16(value & 0xffff));
        QCOMPARE(high, (QList<quint16>{low.last(), low.first()}));
        QCOMPARE(toInt32(low.first(), low.last(), true), value);
        QCOMPARE(toInt32(high.first(), high.last(), false), value);
    }
}

void ModbusPduTest::randomBytesAreEitherLegalOrRefused()
{
    QRandomGenerator random(20240501);
    const QList<quint8> functions{0x01, 0x03, 0x06, 0x10};
    int accepted = 0;
    for (int round = 0; round < 200'000; ++round) {
        QByteArray pdu(random.bounded(0, 300), Qt::Uninitialized);
        for (char& byte : pdu)
            byte = char(random.bounded(256));
        if (!pdu.isEmpty() && round % 2)
            pdu[0] = char(functions.at(random.bounded(int(functions.size()))));
        if (pdu.size() > 4 && round % 3)
            pdu.truncate(5);
        const auto request = decodeRequest(pdu);
        if (!request)
            continue;
        ++accepted;
        QCOMPARE(encodeRequest(*request), pdu); // what was accepted says exactly what the bytes say
        QVERIFY(request->count >= 1 && request->count <= maximumCoils);
    }
    QVERIFY(accepted > 1000);
}

void ModbusPduTest::damagedResponsesAreNeverTakenForAnotherMessage()
{
    QRandomGenerator random(7);
    const Request request{Function::ReadHoldingRegisters, 10, 13, {}};
    const QByteArray good = encodeResponse({request.function, 10, 13, QList<quint16>(13, 0x1234), {}});
    QVERIFY(decodeResponse(request, good).has_value());
    for (int round = 0; round < 50'000; ++round) {
        QByteArray bytes = good;
        bytes.resize(random.bounded(int(good.size()) + 20), char(random.bounded(256)));
        for (int change = random.bounded(4); change > 0 && !bytes.isEmpty(); --change)
            bytes[random.bounded(int(bytes.size()))] = char(random.bounded(256));
        const auto response = decodeResponse(request, bytes);
        if (response) {
            QCOMPARE(bytes.size(), good.size());
            QCOMPARE(bytes.left(2), good.left(2));
            QCOMPARE(int(response->registers.size()), 13);
        }
    }
}

QTEST_APPLESS_MAIN(ModbusPduTest)
#include "tst_modbus_pdu.moc"
