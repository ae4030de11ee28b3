#include "golden_checks.h"
#include "slmp_remote_control.h"
#include "slmp_self_test.h"

#include <QTest>

using namespace lds::slmp;
using golden::hex;

class SlmpRemoteControlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void remoteRun_data() { golden::addRows({"remote-run"}); }
    void remoteRun();
    void remoteStop_data() { golden::addRows({"remote-stop"}); }
    void remoteStop();
    void readTypeName_data() { golden::addRows({"read-type-name"}); }
    void readTypeName();
    void selfTest_data() { golden::addRows({"self-test"}); }
    void selfTest();

    void remoteRunIgnoresModeAndClearMode();
    void malformedRequestsGetTheirCode_data();
    void malformedRequestsGetTheirCode();
    void typeNamesFillSixteenCharacters();
    void typeNamesThatAreNoneAreRefused_data();
    void typeNamesThatAreNoneAreRefused();
    void selfTestTakesUpTo960Bytes();
    void selfTestDataMustComeBackUnchanged();
};

void SlmpRemoteControlTest::remoteRun()
{
    golden::checkBothDirections(golden::fetched(), RemoteRunRequest{0x0003, 0x00}, {});
}

void SlmpRemoteControlTest::remoteStop()
{
    golden::checkBothDirections(golden::fetched(), RemoteStopRequest{}, {});
}

void SlmpRemoteControlTest::readTypeName()
{
    const ReadTypeNameResponse response{QStringLiteral("HL-G203B-S-MK"), hlg2TypeNameCode};
    golden::checkBothDirections(golden::fetched(), ReadTypeNameRequest{}, encodeResponse(response));
    QVERIFY(decodeReadTypeNameResponse(encodeResponse(response)) == response);
}

void SlmpRemoteControlTest::selfTest()
{
    const SelfTestRequest request{QByteArrayLiteral("ABCDE")};
    golden::checkBothDirections(golden::fetched(), request, encodeResponse(request));
    QVERIFY(decodeSelfTestResponse(request, encodeResponse(request)).has_value());
}

// §5.4.3 notes: not supported, always forcibly, nothing cleared; so no value of them is an error.
void SlmpRemoteControlTest::remoteRunIgnoresModeAndClearMode()
{
    for (const int mode : {0x0000, 0x0001, 0x0003, 0xffff}) {
        for (const int clearMode : {0, 1, 2, 255}) {
            const RemoteRunRequest request{quint16(mode), quint8(clearMode)};
            QVERIFY(decodeRemoteRunRequest(encodeRequest(request)) == request);
        }
    }
}

void SlmpRemoteControlTest::malformedRequestsGetTheirCode_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<int>("code");
    const auto row = [](const char* name, Command command, quint16 subcommand, const char* data,
                        CompleteCode code) {
        QTest::newRow(name) << Message{command, subcommand, hex(data)} << int(code);
    };
    row("run: subcommand", Command::RemoteRun, 1, "03000000", CompleteCode::Command);
    row("run: cut", Command::RemoteRun, 0, "030000", CompleteCode::RequestDataSize);
    row("run: long", Command::RemoteRun, 0, "0300000000", CompleteCode::RequestDataSize);
    row("run: fixed byte", Command::RemoteRun, 0, "03000001", CompleteCode::Request);
    row("stop: subcommand", Command::RemoteStop, 1, "0100", CompleteCode::Command);
    row("stop: nothing", Command::RemoteStop, 0, "", CompleteCode::RequestDataSize);
    row("stop: long", Command::RemoteStop, 0, "010000", CompleteCode::RequestDataSize);
    row("stop: not the fixed value", Command::RemoteStop, 0, "0300", CompleteCode::Request);
    row("type name: subcommand", Command::ReadTypeName, 1, "", CompleteCode::Command);
    row("type name: data", Command::ReadTypeName, 0, "00", CompleteCode::RequestDataSize);
    row("self test: subcommand", Command::SelfTest, 1, "010041", CompleteCode::Command);
    row("self test: no length", Command::SelfTest, 0, "01", CompleteCode::RequestDataSize);
    row("self test: cut", Command::SelfTest, 0, "020041", CompleteCode::RequestDataSize);
    row("self test: long", Command::SelfTest, 0, "01004142", CompleteCode::RequestDataSize);
    row("self test: nothing to return", Command::SelfTest, 0, "0000", CompleteCode::Request);
}

void SlmpRemoteControlTest::malformedRequestsGetTheirCode()
{
    QFETCH(Message, message);
    QFETCH(int, code);
    QCOMPARE(golden::judged(message), code);
}

void SlmpRemoteControlTest::typeNamesFillSixteenCharacters()
{
    const auto nameIn = [](const char* sixteen) {
        return decodeReadTypeNameResponse(QByteArray(sixteen, 16) + hex("0100"))->name;
    };
    QCOMPARE(nameIn("HL-G225B-S-MK   "), QStringLiteral("HL-G225B-S-MK"));
    QCOMPARE(nameIn("0123456789ABCDEF"), QStringLiteral("0123456789ABCDEF"));
    QCOMPARE(nameIn("A B             "), QStringLiteral("A B"));
    QCOMPARE(nameIn("A\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"), QStringLiteral("A")); // filled with 00H by some
    const QString tooLong = QStringLiteral("0123456789ABCDEFG");
    QCOMPARE(encodeResponse(ReadTypeNameResponse{tooLong, 1}), QByteArray("0123456789ABCDEF\x01\x00", 18));
}

void SlmpRemoteControlTest::typeNamesThatAreNoneAreRefused_data()
{
    QTest::addColumn<QByteArray>("data");
    const QByteArray code = hex("0901");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no code") << QByteArray(16, 'A');
    QTest::newRow("half a code") << QByteArray(17, 'A');
    QTest::newRow("one byte more") << QByteArray(17, 'A') + code;
    QTest::newRow("only filling") << QByteArray(16, ' ') + code;
    QTest::newRow("control character") << QByteArray("HL\n").leftJustified(16, ' ') + code;
    QTest::newRow("beyond ASCII") << QByteArray("HL\xe9").leftJustified(16, ' ') + code;
    QTest::newRow("zero inside") << QByteArray("HL\0G2", 5).leftJustified(16, ' ') + code;
}

void SlmpRemoteControlTest::typeNamesThatAreNoneAreRefused()
{
    QFETCH(QByteArray, data);
    const auto response = decodeReadTypeNameResponse(data);
    QVERIFY(!response);
    QCOMPARE(response.error().error, ResponseError::Data);
}

// §5.4.3, complete code 3: more than 960 bytes to return.
void SlmpRemoteControlTest::selfTestTakesUpTo960Bytes()
{
    const auto judged = [](int size) {
        return golden::judged(encodeRequest(SelfTestRequest{QByteArray(size, 'x')}));
    };
    QCOMPARE(judged(1), golden::accepts);
    QCOMPARE(judged(960), golden::accepts);
    QCOMPARE(judged(961), int(CompleteCode::Request));
    QCOMPARE(judged(1400), int(CompleteCode::Request));
    const Message lies{Command::SelfTest, 0, hex("ffff41")};
    QCOMPARE(golden::judged(lies), int(CompleteCode::Request)); // what it asks for is judged first
}

void SlmpRemoteControlTest::selfTestDataMustComeBackUnchanged()
{
    const SelfTestRequest request{QByteArrayLiteral("ABC")};
    for (const char* data : {"", "0300", "0300414244", "04004142434400", "030041424300", "020041 42 43"}) {
        const auto response = decodeSelfTestResponse(request, hex(data));
        QVERIFY2(!response, data);
        QCOMPARE(response.error().error, ResponseError::Data);
    }
}

QTEST_APPLESS_MAIN(SlmpRemoteControlTest)
#include "tst_slmp_remote_control.moc"
