#include "modbus_pdu.h"
#include "modbus_rtu_framing.h"

#include <QRandomGenerator>
#include <QTest>

using namespace lds::modbus;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// Step by step as §6.3.2 "CRC calculation method" has it.
quint16 crcOfTheManual(const QByteArray& message)
{
    quint16 crcTmp = 0xFFFF; // 1
    for (const char byte : message) {
        crcTmp = quint16(crcTmp ^ quint8(byte)); // 2: with the lower byte
        for (int time = 0; time < 8; ++time) {   // 4
            const bool leastSignificantBit = crcTmp & 1;
            crcTmp = quint16(crcTmp >> 1); // 3
            if (leastSignificantBit)
                crcTmp = quint16(crcTmp ^ 0xA001);
        }
    }              // 5
    return crcTmp; // 6
}

QList<bool> coils(int count, const QList<int>& on)
{
    QList<bool> list(count, false);
    for (const int number : on)
        list[number - 1] = true;
    return list;
}

} // namespace

class ModbusRtuFramingTest : public QObject {
    Q_OBJECT

    void goldenFrames();

private Q_SLOTS:
    void crcHasThePublishedCheckValues();
    void crcIsTheOneTheManualCalculates();

    void framesEncodeToTheirGoldenBytes_data() { goldenFrames(); }
    void framesEncodeToTheirGoldenBytes();
    void framesDecodeFromTheirGoldenBytes_data() { goldenFrames(); }
    void framesDecodeFromTheirGoldenBytes();

    void theCrcsLowByteComesFirst();
    void framesHaveFourTo256Bytes();
    void everyFlippedBitIsFound();
    void everyLostByteIsFound();
    void randomBytesAreNoFrames();

    void charactersTakeElevenBits_data();
    void charactersTakeElevenBits();
    void silencesAreFixedAbove19200();
};

void ModbusRtuFramingTest::crcHasThePublishedCheckValues()
{
    QCOMPARE(crc16("123456789"), quint16(0x4B37)); // the catalogue of CRCs' check value of CRC-16/MODBUS
    QCOMPARE(crc16({}), quint16(0xFFFF));
    QCOMPARE(crc16(hex("02 07")), quint16(0x1241)); // "Modbus over serial line" V1.02, appendix B
}

void ModbusRtuFramingTest::crcIsTheOneTheManualCalculates()
{
    QRandomGenerator random(485);
    for (int length = 0; length <= longestRtuFrame; ++length) {
        QByteArray bytes(length, Qt::Uninitialized);
        for (char& byte : bytes)
            byte = char(random.bounded(256));
        QCOMPARE(crc16(bytes), crcOfTheManual(bytes));
    }
}

void ModbusRtuFramingTest::goldenFrames()
{
    QTest::addColumn<int>("unit");
    QTest::addColumn<QByteArray>("pdu");
    QTest::addColumn<QByteArray>("frame");

    const auto request = [](const char* name, int unit, const Request& what, const char* frame) {
        QTest::newRow(name) << unit << encodeRequest(what) << hex(frame);
    };
    const auto response = [](const char* name, int unit, const Response& what, const char* frame) {
        QTest::newRow(name) << unit << encodeResponse(what) << hex(frame);
    };
    const auto exception = [](const char* name, int unit, quint8 function, Exception code,
                              const char* frame) {
        QTest::newRow(name) << unit << encodeException(function, code) << hex(frame);
    };
    request("01 asks all coils", 1, {Function::ReadCoils, 0, 64, {}}, "01 01 0000 0040 3dfa");
    response("01 answers", 1, {Function::ReadCoils, 0, 64, {}, coils(64, {4, 7, 11})},
             "01 01 08 48 04 00 00 00 00 00 00 744b");
    exception("01 refuses", 1, 0x01, Exception::Address, "01 81 02 c191");
    request("03 asks HIGH", 247, {Function::ReadHoldingRegisters, 100, 2, {}}, "f7 03 0064 0002 9142");
    response("03 answers", 247, {Function::ReadHoldingRegisters, 100, 2, {0xc350, 0}, {}},
             "f7 03 04 c350 0000 5069");
    exception("03 refuses", 247, 0x03, Exception::Other, "f7 83 04 a0c1");
    request("06 writes eco mode", 1, {Function::WriteSingleRegister, 108, 1, {0}}, "01 06 006c 0000 49d7");
    response("06 answers", 1, {Function::WriteSingleRegister, 108, 1, {0}, {}}, "01 06 006c 0000 49d7");
    exception("06 refuses", 1, 0x06, Exception::Data, "01 86 03 0261");
    request("10 writes a window", 17,
            {Function::WriteMultipleRegisters, 100, 4, {0x1111, 0x0001, 0xeeef, 0xfffe}},
            "11 10 0064 0004 08 1111 0001 eeef fffe ef95");
    response("10 answers", 17, {Function::WriteMultipleRegisters, 100, 4, {}, {}}, "11 10 0064 0004 8285");
    exception("10 refuses", 17, 0x10, Exception::Data, "11 90 03 0dc4");
    exception("04 is no function", 1, 0x04, Exception::FunctionCode, "01 84 01 82c0");
    request("to all", broadcastUnit, {Function::WriteSingleRegister, 51, 1, {1}}, "00 06 0033 0001 b9d4");
}

void ModbusRtuFramingTest::framesEncodeToTheirGoldenBytes()
{
    QFETCH(int, unit);
    QFETCH(QByteArray, pdu);
    QFETCH(QByteArray, frame);
    QCOMPARE(encodeRtuFrame(quint8(unit), pdu), frame);
}

void ModbusRtuFramingTest::framesDecodeFromTheirGoldenBytes()
{
    QFETCH(int, unit);
    QFETCH(QByteArray, pdu);
    QFETCH(QByteArray, frame);
    const auto decoded = decodeRtuFrame(frame);
    QVERIFY(decoded.has_value());
    QCOMPARE(int(decoded->unit), unit);
    QCOMPARE(decoded->pdu, pdu);
}

void ModbusRtuFramingTest::theCrcsLowByteComesFirst()
{
    QByteArray frame = encodeRtuFrame(1, hex("0300000001"));
    const quint16 crc = crcOfTheManual(frame.chopped(2));
    QCOMPARE(quint8(frame.at(6)), quint8(crc & 0xff));
    QCOMPARE(quint8(frame.at(7)), quint8(crc >> 8));
    std::swap(frame[6], frame[7]);
    QCOMPARE(decodeRtuFrame(frame).error(), RtuFrameError::Crc);
}

void ModbusRtuFramingTest::framesHaveFourTo256Bytes()
{
    const QByteArray longest = encodeRtuFrame(1, QByteArray(253, 'x'));
    QCOMPARE(longest.size(), longestRtuFrame);
    QVERIFY(decodeRtuFrame(longest).has_value());
    QCOMPARE(decodeRtuFrame(encodeRtuFrame(1, "x"))->pdu, QByteArray("x"));
    for (int length = 0; length < shortestRtuFrame; ++length)
        QCOMPARE(decodeRtuFrame(QByteArray(length, '\xff')).error(), RtuFrameError::TooShort);
    QByteArray tooLong = longest.chopped(2) + "x";
    const quint16 crc = crc16(tooLong);
    tooLong.append(char(crc & 0xff)).append(char(crc >> 8)); // the CRC is right, the length is not
    QCOMPARE(decodeRtuFrame(tooLong).error(), RtuFrameError::TooLong);
}

void ModbusRtuFramingTest::everyFlippedBitIsFound()
{
    const QByteArray frame = hex("11 10 0064 0004 08 1111 0001 eeef fffe ef95");
    for (qsizetype byte = 0; byte < frame.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            QByteArray flipped = frame;
            flipped[byte] = char(flipped.at(byte) ^ 1 << bit);
            QCOMPARE(decodeRtuFrame(flipped).error(), RtuFrameError::Crc);
        }
    }
}

void ModbusRtuFramingTest::everyLostByteIsFound()
{
    const QByteArray frame = hex("f7 03 04 c350 0000 5069");
    for (qsizetype byte = 0; byte < frame.size(); ++byte)
        QCOMPARE(decodeRtuFrame(QByteArray(frame).remove(byte, 1)).error(), RtuFrameError::Crc);
}

void ModbusRtuFramingTest::randomBytesAreNoFrames()
{
    QRandomGenerator random(20241123);
    int accepted = 0;
    constexpr int rounds = 200'000;
    for (int round = 0; round < rounds; ++round) {
        QByteArray bytes(random.bounded(0, 300), Qt::Uninitialized);
        for (char& byte : bytes)
            byte = char(random.bounded(256));
        const auto frame = decodeRtuFrame(bytes);
        if (!frame)
            continue;
        ++accepted;
        QCOMPARE(encodeRtuFrame(frame->unit, frame->pdu), bytes);
    }
    QVERIFY(accepted < rounds / 10'000); // one in 65,536 is to be expected
}

void ModbusRtuFramingTest::charactersTakeElevenBits_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<qint64>("oneNs");
    QTest::addColumn<qint64>("frameNs"); // of 256 characters
    QTest::addColumn<qint64>("silenceNs");
    QTest::addColumn<qint64>("gapNs");
    QTest::newRow("9600") << 9600 << 1'145'834LL << 293'333'334LL << 4'010'417LL << 1'718'750LL;
    QTest::newRow("19200") << 19200 << 572'917LL << 146'666'667LL << 2'005'209LL << 859'375LL;
    QTest::newRow("38400") << 38400 << 286'459LL << 73'333'334LL << 1'750'000LL << 750'000LL;
    QTest::newRow("115200") << 115200 << 95'487LL << 24'444'445LL << 1'750'000LL << 750'000LL;
    QTest::newRow("230400") << 230400 << 47'744LL << 12'222'223LL << 1'750'000LL << 750'000LL;
}

void ModbusRtuFramingTest::charactersTakeElevenBits()
{
    QFETCH(int, speed);
    QFETCH(qint64, oneNs);
    QFETCH(qint64, frameNs);
    QFETCH(qint64, silenceNs);
    QFETCH(qint64, gapNs);
    const RtuRate rate{speed};
    QCOMPARE(charactersNs(rate, 1), oneNs);
    QCOMPARE(charactersNs(rate, longestRtuFrame), frameNs);
    QCOMPARE(charactersNs(rate, 0), 0LL);
    QCOMPARE(frameSilenceNs(rate), silenceNs);
    QCOMPARE(longestGapNs(rate), gapNs);
}

void ModbusRtuFramingTest::silencesAreFixedAbove19200()
{
    QCOMPARE(frameSilenceNs({19'201}), 1'750'000LL);
    QCOMPARE(longestGapNs({19'201}), 750'000LL);
    QCOMPARE(frameSilenceNs({1200}), 32'083'334LL);
    QCOMPARE(frameSilenceNs({1200, 10}), 29'166'667LL);
}

QTEST_APPLESS_MAIN(ModbusRtuFramingTest)
#include "tst_modbus_rtu_framing.moc"
