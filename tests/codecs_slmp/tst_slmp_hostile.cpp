#include "golden_checks.h"

#include <QDir>
#include <QTest>

using namespace lds::slmp;
using golden::hex;

namespace {

/// Up to here a datagram cannot say what it asks for or answers: timer, command and subcommand end a
/// request's head, the complete code a response's; LMT has command and division in both.
qsizetype headSize(FrameType type, bool request)
{
    switch (type) {
    case FrameType::St:
        return request ? 15 : 11;
    case FrameType::Mt:
        return request ? 19 : 15;
    case FrameType::Lmt:
        return 28;
    }
    return 0;
}

int judged(const QByteArray& datagram)
{
    const auto accepted = decodeServerRequest(datagram, golden::sensor);
    if (accepted)
        return golden::accepts;
    return accepted.error().answer ? int(*accepted.error().answer) : golden::silent;
}

QByteArray corpusFile(const QString& name)
{
    QFile file(qEnvironmentVariable("LDS_SOURCE") + QStringLiteral("/tests/fuzz/corpus/slmp/") + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString corpusName(const char* name, FrameType type, const char* kind)
{
    const QString typeName = QString::fromLatin1(golden::nameOf(type)).toLower();
    return QStringLiteral("%1-%2-%3").arg(QLatin1String(name), typeName, QLatin1String(kind));
}

/// Whether the data of a golden response is taken as an answer to its request.
bool isTaken(const ServerRequest& request, const QByteArray& data)
{
    struct Visitor {
        const QByteArray& data;
        bool operator()(const ReadRequest& read) const { return decodeReadResponse(read, data).has_value(); }
        bool operator()(const ReadRandomRequest& read) const
        {
            return decodeReadRandomResponse(read, data).has_value();
        }
        bool operator()(const WriteRequest&) const { return decodeEmptyResponse(data).has_value(); }
        bool operator()(const WriteRandomRequest&) const { return decodeEmptyResponse(data).has_value(); }
        bool operator()(const RemoteRunRequest&) const { return decodeEmptyResponse(data).has_value(); }
        bool operator()(const RemoteStopRequest&) const { return decodeEmptyResponse(data).has_value(); }
        bool operator()(const ReadTypeNameRequest&) const
        {
            return decodeReadTypeNameResponse(data).has_value();
        }
        bool operator()(const SelfTestRequest& test) const
        {
            return decodeSelfTestResponse(test, data).has_value();
        }
        bool operator()(const NodeSearchRequest& search) const
        {
            return decodeNodeSearchResponse(search, data).has_value();
        }
        bool operator()(const IpAddressSetRequest& set) const
        {
            return decodeIpAddressSetResponse(set, data).has_value();
        }
        bool operator()(const DeviceInfoCompareRequest& compared) const
        {
            return decodeDeviceInfoCompareResponse(compared, data).has_value();
        }
    };
    return std::visit(Visitor{data}, request);
}

} // namespace

class SlmpHostileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void requestsCutAnywhereAreNeverAccepted();
    void requestsWhoseDataIsCutAreNeverAccepted();
    void responsesCutAnywhereAreNeverTaken();
    void responsesWhoseDataIsCutOrLongerAreNeverTaken();
    void theSeedCorpusHasEveryGoldenFrame();
};

void SlmpHostileTest::requestsCutAnywhereAreNeverAccepted()
{
    for (const golden::Frame& frame : golden::frames) {
        const QByteArray whole = hex(frame.request);
        for (qsizetype size = 0; size < whole.size(); ++size) {
            const bool named = size >= headSize(frame.type, true);
            QCOMPARE(judged(whole.left(size)), named ? int(CompleteCode::RequestDataSize) : golden::silent);
        }
        QCOMPARE(judged(whole + '\0'), int(CompleteCode::RequestDataSize));
    }
}

/// The same with a length that fits, so that it is the data's decoder that has to notice.
void SlmpHostileTest::requestsWhoseDataIsCutAreNeverAccepted()
{
    for (const golden::Frame& frame : golden::frames) {
        const auto whole = decodeRequestFrame(hex(frame.request));
        const Station station{whole->route.network, whole->route.node, golden::sensor.mac};
        const auto codeOf = [&station](const RequestFrame& request) {
            const auto accepted = decodeServerRequest(encodeRequestFrame(request), station);
            return accepted ? CompleteCode::Success : accepted.error().answer.value_or(CompleteCode::Success);
        };
        for (qsizetype size = 0; size < whole->message.data.size(); ++size) {
            RequestFrame cut = *whole;
            cut.message.data.truncate(size);
            QCOMPARE(codeOf(cut), CompleteCode::RequestDataSize);
        }
        RequestFrame longer = *whole;
        longer.message.data += '\0';
        QCOMPARE(codeOf(longer), CompleteCode::RequestDataSize);
    }
}

void SlmpHostileTest::responsesCutAnywhereAreNeverTaken()
{
    for (const golden::Frame& frame : golden::frames) {
        const RequestFrame request = *decodeRequestFrame(hex(frame.request));
        const QByteArray whole = hex(frame.response);
        QVERIFY(decodeAnswer(request, whole).has_value());
        for (qsizetype size = 0; size < whole.size(); ++size) {
            const auto data = decodeAnswer(request, whole.left(size));
            QVERIFY(!data);
            QCOMPARE(data.error().error,
                     size < headSize(frame.type, false) ? ResponseError::NoResponse : ResponseError::Length);
        }
        QCOMPARE(decodeAnswer(request, whole + '\0').error().error, ResponseError::Length);
    }
    for (const golden::Refusal& refusal : golden::refusals) {
        const RequestFrame request = golden::around(refusal.type, {Command::Read, 0, {}});
        const QByteArray whole = hex(refusal.response);
        for (qsizetype size = 0; size < whole.size(); ++size)
            QVERIFY(decodeAnswer(request, whole.left(size)).error().error != ResponseError::Refused);
    }
}

void SlmpHostileTest::responsesWhoseDataIsCutOrLongerAreNeverTaken()
{
    for (const golden::Frame& frame : golden::frames) {
        const RequestFrame asked = *decodeRequestFrame(hex(frame.request));
        const Station station{asked.route.network, asked.route.node, golden::sensor.mac};
        const auto request = decodeServerRequest(hex(frame.request), station)->request;
        const QByteArray whole = *decodeAnswer(asked, hex(frame.response));
        QVERIFY(isTaken(request, whole));
        for (qsizetype size = 0; size < whole.size(); ++size)
            QVERIFY(!isTaken(request, whole.left(size)));
        QVERIFY(!isTaken(request, whole + '\0'));
    }
}

void SlmpHostileTest::theSeedCorpusHasEveryGoldenFrame()
{
    for (const golden::Frame& frame : golden::frames) {
        QCOMPARE(corpusFile(corpusName(frame.name, frame.type, "request")), hex(frame.request));
        QCOMPARE(corpusFile(corpusName(frame.name, frame.type, "response")), hex(frame.response));
    }
    for (const golden::Refusal& refusal : golden::refusals)
        QCOMPARE(corpusFile(corpusName("read-words", refusal.type, "refused")), hex(refusal.response));
}

QTEST_APPLESS_MAIN(SlmpHostileTest)
#include "tst_slmp_hostile.moc"
