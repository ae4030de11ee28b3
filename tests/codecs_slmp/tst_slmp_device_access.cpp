#include "golden_checks.h"
#include "slmp_batch_access.h"
#include "slmp_random_access.h"

#include <QTest>

using namespace lds::slmp;

namespace {

Device d(quint32 number) { return {DeviceCode::DataRegister, number}; }
Device y(quint32 number) { return {DeviceCode::Output, number}; }

QByteArray answerOf(const ReadRequest& request, const ReadResponse& response)
{
    return encodeResponse(request, response);
}

} // namespace

class SlmpDeviceAccessTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readWords_data() { golden::addRows({"read-words"}); }
    void readWords();
    void readBits_data() { golden::addRows({"read-bits"}); }
    void readBits();
    void readRandom_data() { golden::addRows({"read-random"}); }
    void readRandom();
    void writeWords_data() { golden::addRows({"write-words"}); }
    void writeWords();
    void writeBits_data() { golden::addRows({"write-bits"}); }
    void writeBits();
    void writeRandom_data() { golden::addRows({"write-random"}); }
    void writeRandom();
    void writeRandomBits_data() { golden::addRows({"write-random-bits"}); }
    void writeRandomBits();
    void cyclicWriteGoesToAnotherStation_data() { golden::addRows({"cyclic-write"}); }
    void cyclicWriteGoesToAnotherStation();

    void pointsEndAt144_data();
    void pointsEndAt144();
    void unitsAreTheDevicesOwn_data();
    void unitsAreTheDevicesOwn();
    void deviceNumbersEndAtThreeBytes_data();
    void deviceNumbersEndAtThreeBytes();
    void malformedRequestsGetTheirCode_data();
    void malformedRequestsGetTheirCode();
    void bitResponsesAreTakenOnlyAsZeroAndOne();
    void responsesOfAnotherSizeAreRefused();
    void aDoubleWordHasItsLowerBytesFirst();
};

void SlmpDeviceAccessTest::readWords()
{
    const ReadRequest request{AccessUnit::Word, d(100), 2};
    const ReadResponse response{{0xc350, 0x0000}, {}};
    golden::checkBothDirections(golden::fetched(), request, answerOf(request, response));
    QVERIFY(decodeReadResponse(request, golden::hex("50c30000")) == response);
}

void SlmpDeviceAccessTest::readBits()
{
    const ReadRequest request{AccessUnit::Bit, y(0), 11};
    QList<bool> bits(11, false);
    bits[3] = bits[6] = bits[10] = true;
    const ReadResponse response{{}, bits};
    golden::checkBothDirections(golden::fetched(), request, answerOf(request, response));
    QVERIFY(decodeReadResponse(request, golden::hex("000100100010")) == response);
}

void SlmpDeviceAccessTest::readRandom()
{
    const ReadRandomRequest request{{d(10), d(21)}, {d(19), d(100)}};
    const ReadRandomResponse response{{0x0408, 0x0200}, {quint32(-12345), 50'000}};
    golden::checkBothDirections(golden::fetched(), request, encodeResponse(response));
    QVERIFY(decodeReadRandomResponse(request, golden::hex("08040002 c7cfffff 50c30000")) == response);
}

void SlmpDeviceAccessTest::writeWords()
{
    const WriteRequest request{AccessUnit::Word, d(102), {0x3cb0, 0xffff}, {}};
    golden::checkBothDirections(golden::fetched(), request, {});
}

void SlmpDeviceAccessTest::writeBits()
{
    const WriteRequest request{AccessUnit::Bit, y(0), {}, {true, false, true}};
    golden::checkBothDirections(golden::fetched(), request, {});
}

void SlmpDeviceAccessTest::writeRandom()
{
    const WriteRandomRequest request{{{d(51), 1}}, {{d(100), 50'000}, {d(102), quint32(-50'000)}}, {}};
    golden::checkBothDirections(golden::fetched(), request, {});
}

void SlmpDeviceAccessTest::writeRandomBits()
{
    const WriteRandomRequest request{{}, {}, {{y(0), true}, {y(16), false}}};
    golden::checkBothDirections(golden::fetched(), request, {});
}

void SlmpDeviceAccessTest::cyclicWriteGoesToAnotherStation()
{
    const WriteRequest request{AccessUnit::Word, d(1000), {0xcfc7, 0xffff, 10'000, 0x0408, 1}, {}};
    golden::checkBothDirections(golden::fetched(), request, {}, {2, 5, 0x03ff});
}

// §5.4.3: "The upper limit of the number of device points shall be 144", words and double words together.
void SlmpDeviceAccessTest::pointsEndAt144_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<int>("code");
    const auto row = [](const char* name, const auto& request, int code) {
        QTest::newRow(name) << encodeRequest(request) << code;
    };
    const auto devices = [](int count) { return QList<Device>(count, d(100)); };
    const int many = int(CompleteCode::RequestTooLarge);
    const int wrong = int(CompleteCode::Request);

    row("read 0", ReadRequest{AccessUnit::Word, d(0), 0}, wrong);
    row("read 1", ReadRequest{AccessUnit::Word, d(0), 1}, golden::accepts);
    row("read 144", ReadRequest{AccessUnit::Word, d(0), 144}, golden::accepts);
    row("read 145", ReadRequest{AccessUnit::Word, d(0), 145}, many);
    row("read 65535", ReadRequest{AccessUnit::Word, d(0), 65'535}, many);
    row("read bits 144", ReadRequest{AccessUnit::Bit, y(0), 144}, golden::accepts);
    row("read bits 145", ReadRequest{AccessUnit::Bit, y(0), 145}, many);
    row("write 0", WriteRequest{AccessUnit::Word, d(0), {}, {}}, wrong);
    row("write 144", WriteRequest{AccessUnit::Word, d(0), QList<quint16>(144), {}}, golden::accepts);
    row("write 145", WriteRequest{AccessUnit::Word, d(0), QList<quint16>(145), {}}, many);
    row("write bits 144", WriteRequest{AccessUnit::Bit, y(0), {}, QList<bool>(144)}, golden::accepts);
    row("write bits 145", WriteRequest{AccessUnit::Bit, y(0), {}, QList<bool>(145)}, many);
    row("read random 0", ReadRandomRequest{}, wrong);
    row("read random 144 + 0", ReadRandomRequest{devices(144), {}}, golden::accepts);
    row("read random 0 + 144", ReadRandomRequest{{}, devices(144)}, golden::accepts);
    row("read random 100 + 44", ReadRandomRequest{devices(100), devices(44)}, golden::accepts);
    row("read random 100 + 45", ReadRandomRequest{devices(100), devices(45)}, many);
    row("read random 255 + 255", ReadRandomRequest{devices(255), devices(255)}, many);
    row("write random 0", WriteRandomRequest{}, wrong);
    row("write random 0 + 144", WriteRandomRequest{{}, QList<DoubleWordValue>(144), {}}, golden::accepts);
    row("write random 1 + 144", WriteRandomRequest{{{}}, QList<DoubleWordValue>(144), {}}, many);
    row("write random 145 + 0", WriteRandomRequest{QList<WordValue>(145), {}, {}}, many);
    row("write random bits 144", WriteRandomRequest{{}, {}, QList<BitValue>(144, {y(0), true})},
        golden::accepts);
    row("write random bits 145", WriteRandomRequest{{}, {}, QList<BitValue>(145, {y(0), true})}, many);
    QTest::newRow("write random bits 0")
        << Message{Command::WriteRandom, bitSubcommand, golden::hex("00")} << wrong;
}

void SlmpDeviceAccessTest::pointsEndAt144()
{
    QFETCH(Message, message);
    QFETCH(int, code);
    QCOMPARE(golden::judged(message), code);
}

// §5.4.3, "List of Supported Device Codes".
void SlmpDeviceAccessTest::unitsAreTheDevicesOwn_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<bool>("legal");
    const auto row = [](const char* name, const auto& request, bool legal) {
        QTest::newRow(name) << encodeRequest(request) << legal;
    };
    const Device other{DeviceCode(0xb4), 0}; // a link register
    row("D in words", ReadRequest{AccessUnit::Word, d(0), 1}, true);
    row("D in bits", ReadRequest{AccessUnit::Bit, d(0), 1}, false);
    row("Y in words", ReadRequest{AccessUnit::Word, y(0), 1}, false);
    row("Y in bits", ReadRequest{AccessUnit::Bit, y(0), 1}, true);
    row("another in words", ReadRequest{AccessUnit::Word, other, 1}, false);
    row("another in bits", ReadRequest{AccessUnit::Bit, other, 1}, false);
    row("D written in bits", WriteRequest{AccessUnit::Bit, d(0), {}, {true}}, false);
    row("Y written in words", WriteRequest{AccessUnit::Word, y(0), {1}, {}}, false);
    row("Y at random as a word", ReadRandomRequest{{d(0), y(0)}, {}}, false);
    row("Y at random as a double word", ReadRandomRequest{{d(0)}, {y(0)}}, false);
    row("Y written at random as a word", WriteRandomRequest{{{y(0), 1}}, {}, {}}, false);
    row("Y written at random as a double word", WriteRandomRequest{{}, {{y(0), 1}}, {}}, false);
    row("D written at random as a bit", WriteRandomRequest{{}, {}, {{y(0), true}, {d(0), true}}}, false);
    row("another written at random", WriteRandomRequest{{{other, 1}}, {}, {}}, false);
}

void SlmpDeviceAccessTest::unitsAreTheDevicesOwn()
{
    QFETCH(Message, message);
    QFETCH(bool, legal);
    QCOMPARE(golden::judged(message), legal ? golden::accepts : int(CompleteCode::Request));
}

void SlmpDeviceAccessTest::deviceNumbersEndAtThreeBytes_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<bool>("legal");
    const auto row = [](const char* name, const auto& request, bool legal) {
        QTest::newRow(name) << encodeRequest(request) << legal;
    };
    const quint32 last = 0xffffff;
    row("the last word", ReadRequest{AccessUnit::Word, d(last), 1}, true);
    row("one beyond the last word", ReadRequest{AccessUnit::Word, d(last), 2}, false);
    row("up to the last word", ReadRequest{AccessUnit::Word, d(last - 143), 144}, true);
    row("beyond the last word", ReadRequest{AccessUnit::Word, d(last - 142), 144}, false);
    row("beyond the last bit", WriteRequest{AccessUnit::Bit, y(last), {}, {true, true}}, false);
    row("the last word at random", ReadRandomRequest{{d(last)}, {}}, true);
    row("the last double word", ReadRandomRequest{{}, {d(last - 1)}}, true);
    row("half a double word", ReadRandomRequest{{}, {d(last)}}, false);
    row("half a double word written", WriteRandomRequest{{}, {{d(last), 1}}, {}}, false);
    row("the last bit at random", WriteRandomRequest{{}, {}, {{y(last), true}}}, true);
}

void SlmpDeviceAccessTest::deviceNumbersEndAtThreeBytes()
{
    QFETCH(Message, message);
    QFETCH(bool, legal);
    QCOMPARE(golden::judged(message), legal ? golden::accepts : int(CompleteCode::Request));
}

void SlmpDeviceAccessTest::malformedRequestsGetTheirCode_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<int>("code");
    const auto row = [](const char* name, Command command, quint16 subcommand, const char* data,
                        CompleteCode code) {
        QTest::newRow(name) << Message{command, subcommand, golden::hex(data)} << int(code);
    };
    row("read: extended subcommand", Command::Read, 0x0080, "640000a8 0100", CompleteCode::Command);
    row("read: 32-bit device numbers", Command::Read, 0x0002, "64000000a800 0100", CompleteCode::Command);
    row("write: unknown subcommand", Command::Write, 0x0100, "640000a8 0100 0100", CompleteCode::Command);
    row("read random: no bit form", Command::ReadRandom, 1, "01 00 0000009d", CompleteCode::Command);
    row("write random: unknown subcommand", Command::WriteRandom, 2, "01 00", CompleteCode::Command);
    row("read: a byte more", Command::Read, 0, "640000a8 0100 00", CompleteCode::RequestDataSize);
    row("write: a word less", Command::Write, 0, "640000a8 0200 0100", CompleteCode::RequestDataSize);
    row("write: a word more", Command::Write, 0, "640000a8 0100 0100 0200", CompleteCode::RequestDataSize);
    row("write bits: a byte more", Command::Write, 1, "0000009d 0200 11 00", CompleteCode::RequestDataSize);
    row("read random: a device less", Command::ReadRandom, 0, "02 00 640000a8",
        CompleteCode::RequestDataSize);
    row("read random: a device more", Command::ReadRandom, 0, "00 01 640000a8 660000a8",
        CompleteCode::RequestDataSize);
    row("write random: double word cut", Command::WriteRandom, 0, "00 01 640000a8 0100",
        CompleteCode::RequestDataSize);
    row("write random bits: state missing", Command::WriteRandom, 1, "01 0000009d",
        CompleteCode::RequestDataSize);
    row("write bits: 2 is no state", Command::Write, 1, "0000009d 0200 12", CompleteCode::Request);
    row("write bits: unused half set", Command::Write, 1, "0000009d 0100 11", CompleteCode::Request);
    row("write random bits: 2 is no state", Command::WriteRandom, 1, "01 0000009d 02", CompleteCode::Request);
    // What a count names is judged before what follows it: 145 points are too many however few come.
    row("write: 145 points, no data", Command::Write, 0, "640000a8 9100", CompleteCode::RequestTooLarge);
    row("read random: 145 points, no devices", Command::ReadRandom, 0, "9100", CompleteCode::RequestTooLarge);
}

void SlmpDeviceAccessTest::malformedRequestsGetTheirCode()
{
    QFETCH(Message, message);
    QFETCH(int, code);
    QCOMPARE(golden::judged(message), code);
}

void SlmpDeviceAccessTest::bitResponsesAreTakenOnlyAsZeroAndOne()
{
    const ReadRequest request{AccessUnit::Bit, y(0), 3};
    QVERIFY(decodeReadResponse(request, golden::hex("1010")).has_value());
    for (const char* data : {"2010", "1210", "10f0", "1011"})
        QCOMPARE(decodeReadResponse(request, golden::hex(data)).error().error, ResponseError::Data);
}

void SlmpDeviceAccessTest::responsesOfAnotherSizeAreRefused()
{
    const auto isData = [](const auto& decoded) {
        return !decoded && decoded.error().error == ResponseError::Data;
    };
    const ReadRequest words{AccessUnit::Word, d(100), 2};
    const ReadRandomRequest random{{d(10)}, {d(19)}};
    for (const char* data : {"", "50c3", "50c300", "50c3000000", "50c300000000"})
        QVERIFY2(isData(decodeReadResponse(words, golden::hex(data))), data);
    for (const char* data : {"", "0804", "0804c7cfffff00", "0804c7cfff"})
        QVERIFY2(isData(decodeReadRandomResponse(random, golden::hex(data))), data);
    QVERIFY(isData(decodeEmptyResponse(golden::hex("00"))));
    QVERIFY(decodeEmptyResponse({}).has_value());
}

// §5.4.3: "the specified device number to the lower bytes and the specified device number + 1 to the
// higher bytes".
void SlmpDeviceAccessTest::aDoubleWordHasItsLowerBytesFirst()
{
    const auto value = quint32(-9'999'999);
    QCOMPARE(lowerWord(value), quint16(0x6981));
    QCOMPARE(higherWord(value), quint16(0xff67));
    QCOMPARE(toDoubleWord(0x6981, 0xff67), value);
    const ReadRandomRequest request{{}, {d(19)}};
    const auto pair = unpackWords(encodeResponse(ReadRandomResponse{{}, {value}}));
    QCOMPARE(pair, (QList<quint16>{0x6981, 0xff67})); // as a batch read of the two registers has them
    QCOMPARE(decodeReadRandomResponse(request, packWords(pair))->doubleWords, QList<quint32>{value});
}

QTEST_APPLESS_MAIN(SlmpDeviceAccessTest)
#include "tst_slmp_device_access.moc"
