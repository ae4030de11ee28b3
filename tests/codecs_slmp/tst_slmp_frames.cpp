#include "golden_checks.h"

#include <QSet>
#include <QTest>

using namespace lds::slmp;
using golden::hex;

namespace {

const Message readWords{Command::Read, 0, hex("640000a80200")};

/// The code that a request frame is refused with; -1 when it is taken, -2 for silence.
int refusal(const QByteArray& datagram)
{
    const auto frame = decodeRequestFrame(datagram);
    if (frame)
        return -1;
    return frame.error().answer ? int(*frame.error().answer) : golden::silent;
}

/// What decodeAnswer fails with; -1 when it gives data.
int failureOf(const RequestFrame& request, const QByteArray& datagram)
{
    const auto data = decodeAnswer(request, datagram);
    return data ? -1 : int(data.error().error);
}

QByteArray with(QByteArray bytes, qsizetype index, int value)
{
    bytes[index] = char(value);
    return bytes;
}

QByteArray goldenRequest(FrameType type)
{
    return encodeRequestFrame(golden::around(type, readWords)); // held to its bytes by the device tests
}

const QList<FrameType> allTypes{FrameType::St, FrameType::Mt, FrameType::Lmt};

} // namespace

class SlmpFramesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyFieldOfARequestHasItsPlace();
    void otherSubheadersAreNoRequests_data();
    void otherSubheadersAreNoRequests();
    void reservedFieldsMustBeZero_data();
    void reservedFieldsMustBeZero();
    void dividedMessagesGetCf44();
    void aWrongLengthGetsC061();
    void aRequestAbove1472BytesGetsCee1();
    void refusalsRepeatTheirRequest();
    void anAnswerAbove1472BytesBecomesCee2();
    void errorResponsesHaveTheirGoldenBytes();
    void everyCompleteCodeOfTheTableHasAMeaning();
    void unknownCompleteCodesKeepTheirNumber();
    void answersToOtherRequestsAreNotTaken_data();
    void answersToOtherRequestsAreNotTaken();
    void malformedResponsesAreNamed_data();
    void malformedResponsesAreNamed();
};

void SlmpFramesTest::everyFieldOfARequestHasItsPlace()
{
    const Message message{Command(0x0e0f), 0x1011, hex("1213")};
    RequestFrame frame{FrameType::St, 0, {0x03, 0x04, 0x0605}, 0x0a09, 0, message};
    QCOMPARE(encodeRequestFrame(frame), hex("5000 03 04 0506 00 0800 090a 0f0e 1110 1213"));
    frame.type = FrameType::Mt;
    frame.serial = 0x0201;
    QCOMPARE(encodeRequestFrame(frame), hex("5400 0102 0000 03 04 0506 00 0800 090a 0f0e 1110 1213"));
    QVERIFY(decodeRequestFrame(encodeRequestFrame(frame)) == frame);
    frame.type = FrameType::Lmt;
    frame.dataId = 0x07;
    QCOMPARE(encodeRequestFrame(frame),
             hex("6800 0102 0000 03 04 0506 00 00 0000 0e00 090a 0f0e 1110 00 07 0000 0000 1213"));
    QVERIFY(decodeRequestFrame(encodeRequestFrame(frame)) == frame);
}

void SlmpFramesTest::otherSubheadersAreNoRequests_data()
{
    QTest::addColumn<QByteArray>("subheader");
    for (const char* text : {"d000", "d400", "e800", "0050", "5001", "5401", "6900", "0000", "ffff", "3530"})
        QTest::newRow(text) << hex(text);
}

void SlmpFramesTest::otherSubheadersAreNoRequests()
{
    QFETCH(QByteArray, subheader);
    for (const FrameType type : allTypes)
        QCOMPARE(refusal(subheader + goldenRequest(type).mid(2)), golden::silent);
}

void SlmpFramesTest::reservedFieldsMustBeZero_data()
{
    QTest::addColumn<FrameType>("type");
    QTest::addColumn<int>("index");
    QTest::newRow("ST 6") << FrameType::St << 6;
    for (const int index : {4, 5, 10})
        QTest::addRow("MT %d", index) << FrameType::Mt << index;
    for (const int index : {4, 5, 10, 11, 12, 13, 22})
        QTest::addRow("LMT %d", index) << FrameType::Lmt << index;
}

void SlmpFramesTest::reservedFieldsMustBeZero()
{
    QFETCH(FrameType, type);
    QFETCH(int, index);
    QCOMPARE(refusal(goldenRequest(type)), -1);
    QCOMPARE(refusal(with(goldenRequest(type), index, 1)), int(CompleteCode::Request));
    const RequestFrame request = golden::around(type, readWords);
    const QByteArray response = encodeAnswer(request, hex("01000200"));
    QCOMPARE(failureOf(request, response), -1);
    QCOMPARE(failureOf(request, with(response, index, 1)), int(ResponseError::Reserved));
}

// §5.4.3, complete code 9: total number of divisions and division number other than 0.
void SlmpFramesTest::dividedMessagesGetCf44()
{
    const RequestFrame request = golden::around(FrameType::Lmt, readWords);
    const QByteArray response = encodeAnswer(request, hex("01000200"));
    for (const int index : {24, 25, 26, 27}) {
        QCOMPARE(refusal(with(goldenRequest(FrameType::Lmt), index, 1)), int(CompleteCode::Divided));
        QCOMPARE(failureOf(request, with(response, index, 1)), int(ResponseError::Divided));
    }
    QCOMPARE(refusal(with(goldenRequest(FrameType::Lmt), 23, 1)), -1); // the data id may be any
}

// §5.4.3, complete code 4.
void SlmpFramesTest::aWrongLengthGetsC061()
{
    const QList<int> lengthAt{7, 11, 14};
    for (const FrameType type : allTypes) {
        const QByteArray good = goldenRequest(type);
        const int index = lengthAt.at(int(type));
        for (const int difference : {-1, 1}) {
            const QByteArray wrong = with(good, index, good.at(index) + difference);
            QCOMPARE(refusal(wrong), int(CompleteCode::RequestDataSize));
        }
        QCOMPARE(refusal(with(good, index + 1, 1)), int(CompleteCode::RequestDataSize));
        QCOMPARE(refusal(good + '\0'), int(CompleteCode::RequestDataSize));
        QCOMPARE(refusal(good.chopped(1)), int(CompleteCode::RequestDataSize));
    }
}

// §5.4.3, complete code 6 and the note below the table.
void SlmpFramesTest::aRequestAbove1472BytesGetsCee1()
{
    for (const FrameType type : allTypes) {
        Message message = readWords;
        const auto head = goldenRequest(type).size() - message.data.size();
        message.data = QByteArray(1472 - head, 'x');
        const QByteArray longest = encodeRequestFrame(golden::around(type, message));
        QCOMPARE(longest.size(), 1472);
        QCOMPARE(refusal(longest), -1);
        message.data += 'x';
        const QByteArray tooLong = encodeRequestFrame(golden::around(type, message));
        QCOMPARE(refusal(tooLong), int(CompleteCode::RequestTooLarge));
        QCOMPARE(refusal(longest + 'x'), int(CompleteCode::RequestTooLarge)); // before its wrong length
    }
}

void SlmpFramesTest::refusalsRepeatTheirRequest()
{
    for (const FrameType type : allTypes) {
        const RequestFrame request = golden::around(type, readWords);
        const auto frame = decodeRequestFrame(goldenRequest(type) + '\0');
        QVERIFY(!frame);
        const QByteArray answer = encodeErrorAnswer(frame.error().request, *frame.error().answer);
        const auto failure = decodeAnswer(request, answer);
        QVERIFY(!failure);
        QCOMPARE(failure.error().error, ResponseError::Refused);
        QCOMPARE(failure.error().completeCode, CompleteCode::RequestDataSize);
    }
}

// §5.4.3, complete code 7.
void SlmpFramesTest::anAnswerAbove1472BytesBecomesCee2()
{
    const QList<int> headSizes{11, 15, 28};
    for (const FrameType type : allTypes) {
        const RequestFrame request = golden::around(type, readWords);
        const QByteArray most(1472 - headSizes.at(int(type)), 'x');
        QCOMPARE(encodeAnswer(request, most).size(), 1472);
        QCOMPARE(*decodeAnswer(request, encodeAnswer(request, most)), most);
        const auto failure = decodeAnswer(request, encodeAnswer(request, most + 'x'));
        QVERIFY(!failure);
        QCOMPARE(failure.error().completeCode, CompleteCode::ResponseTooLarge);
    }
}

void SlmpFramesTest::errorResponsesHaveTheirGoldenBytes()
{
    for (const golden::Refusal& refused : golden::refusals) {
        const RequestFrame request = golden::around(refused.type, readWords);
        QCOMPARE(encodeErrorAnswer(request, CompleteCode::Request).toHex(' '),
                 hex(refused.response).toHex(' '));
        const auto response = decodeResponseFrame(hex(refused.response));
        QVERIFY(response.has_value());
        QCOMPARE(response->completeCode, CompleteCode::Request);
        QCOMPARE(response->errorInformation.has_value(), refused.type != FrameType::Lmt);
        if (response->errorInformation)
            QVERIFY((*response->errorInformation == ErrorInformation{localStation, Command::Read, 0}));
        const auto data = decodeAnswer(request, hex(refused.response));
        QVERIFY(!data);
        QCOMPARE(data.error().error, ResponseError::Refused);
        QCOMPARE(data.error().completeCode, CompleteCode::Request);
    }
    // No table shows whether LMT adds the error information, so it may.
    const RequestFrame lmt = golden::around(FrameType::Lmt, readWords);
    const QByteArray added = hex("e800 3412 0000 00 ff ff03 00 00 0000 1500 5cc0 0104 0000 00 00 0000 0000"
                                 "00 ff ff03 00 0104 0000");
    QCOMPARE(failureOf(lmt, added), int(ResponseError::Refused));
}

void SlmpFramesTest::everyCompleteCodeOfTheTableHasAMeaning()
{
    const QList<int> table{0x0000, 0xc059, 0xc05c, 0xc061, 0xcee0, 0xcee1, 0xcee2, 0xcf20, 0xcf44};
    QCOMPARE(qsizetype(std::size(allCompleteCodes)), table.size());
    QSet<QByteArray> meanings;
    for (qsizetype i = 0; i < table.size(); ++i) {
        QCOMPARE(int(allCompleteCodes[i]), table.at(i));
        QVERIFY(meaning(allCompleteCodes[i]));
        meanings.insert(meaning(allCompleteCodes[i]));
    }
    QCOMPARE(meanings.size(), table.size());
    QVERIFY(!meaning(CompleteCode(0xc051)));
}

void SlmpFramesTest::unknownCompleteCodesKeepTheirNumber()
{
    const RequestFrame request = golden::around(FrameType::Mt, readWords);
    const auto data = decodeAnswer(request, encodeErrorAnswer(request, CompleteCode(0x4031)));
    QVERIFY(!data);
    QCOMPARE(data.error().error, ResponseError::Refused);
    QCOMPARE(int(data.error().completeCode), 0x4031);
}

void SlmpFramesTest::answersToOtherRequestsAreNotTaken_data()
{
    QTest::addColumn<FrameType>("type");
    QTest::addColumn<RequestFrame>("other");
    const auto row = [](FrameType type, const char* name, auto change) {
        RequestFrame other = golden::around(type, readWords);
        change(other);
        QTest::addRow("%s %s", golden::nameOf(type), name) << type << other;
    };
    for (const FrameType type : allTypes) {
        row(type, "network", [](RequestFrame& other) { other.route.network = 1; });
        row(type, "node", [](RequestFrame& other) { other.route.node = 1; });
        row(type, "processor", [](RequestFrame& other) { other.route.processor = 0x03e0; });
        const bool st = type == FrameType::St;
        row(type, "type", [st](RequestFrame& other) { other.type = st ? FrameType::Mt : FrameType::St; });
        if (!st)
            row(type, "serial", [](RequestFrame& other) { other.serial = 0x1235; });
    }
    row(FrameType::Lmt, "command", [](RequestFrame& other) { other.message.command = Command::Write; });
    row(FrameType::Lmt, "subcommand", [](RequestFrame& other) { other.message.subcommand = 1; });
}

void SlmpFramesTest::answersToOtherRequestsAreNotTaken()
{
    QFETCH(FrameType, type);
    QFETCH(RequestFrame, other);
    const RequestFrame request = golden::around(type, readWords);
    const int another = int(ResponseError::AnotherAnswer);
    QCOMPARE(failureOf(request, encodeAnswer(request, hex("01000200"))), -1);
    QCOMPARE(failureOf(request, encodeAnswer(other, hex("01000200"))), another);
    QCOMPARE(failureOf(request, encodeErrorAnswer(other, CompleteCode::Busy)), another);
}

void SlmpFramesTest::malformedResponsesAreNamed_data()
{
    QTest::addColumn<QByteArray>("datagram");
    QTest::addColumn<ResponseError>("error");
    const auto row = [](const char* name, const char* text, ResponseError error) {
        QTest::newRow(name) << hex(text) << error;
    };
    const char* mt = "d400 3412 0000 00 ff ff03 00";
    const auto mtRow = [&row, mt](const char* name, const char* rest, ResponseError error) {
        row(name, (QByteArray(mt) + rest).constData(), error);
    };
    row("nothing", "", ResponseError::NoResponse);
    row("a request", golden::frames[1].request, ResponseError::NoResponse);
    mtRow("no complete code", "0200 00", ResponseError::NoResponse);
    mtRow("length too small", "0500 0000 01000200", ResponseError::Length);
    mtRow("length too large", "0700 0000 01000200", ResponseError::Length);
    mtRow("error without information", "0200 5cc0", ResponseError::Length);
    mtRow("error information cut", "0a00 5cc0 00ffff03 00 0104 00", ResponseError::Length);
    mtRow("error information and more", "0c00 5cc0 00ffff03 00 0104 0000 00", ResponseError::Length);
    mtRow("error information reserved", "0b00 5cc0 00ffff03 01 0104 0000", ResponseError::Reserved);
    mtRow("another command's error", "0b00 5cc0 00ffff03 00 0114 0000", ResponseError::AnotherAnswer);
    mtRow("another subcommand's error", "0b00 5cc0 00ffff03 00 0104 0100", ResponseError::AnotherAnswer);
    QTest::newRow("above 1472 bytes")
        << hex(mt) + hex("b405 0000") + QByteArray(1458, 'x') << ResponseError::Length;
}

void SlmpFramesTest::malformedResponsesAreNamed()
{
    QFETCH(QByteArray, datagram);
    QFETCH(ResponseError, error);
    QCOMPARE(failureOf(golden::around(FrameType::Mt, readWords), datagram), int(error));
}

QTEST_APPLESS_MAIN(SlmpFramesTest)
#include "tst_slmp_frames.moc"
