#include "rtu_answer.h"

#include "scripted_line.h"

#include <QTest>

#include <random>

using namespace lds;
using namespace lds::tests;
using modbus::judgeCoils;
using modbus::judgeData;
using Kind = modbus::RtuVerdict::Kind;

namespace {

QByteArray data(int unit = 1)
{
    return ScriptedLine::frame(quint8(unit), QByteArray::fromHex("030427100000"));
}
QByteArray coils(int unit = 1) { return ScriptedLine::frame(quint8(unit), QByteArray::fromHex("010155")); }
QByteArray refusal(int function)
{
    return ScriptedLine::frame(1, QByteArray(1, char(function | 0x80)) + char(4));
}

} // namespace

/// What bytes say is judged without a line.
class RtuAnswerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oneMessageIsTheAnswer();
    void messagesOfOthersAreLeftAside();
    void twoAnswersAreNone();
    void bytesAroundAnAnswerSpoilIt();
    void anyAnswerAboutCoilsProvesTheOrder();
    void garbageIsNeverAnAnswer();
};

void RtuAnswerTest::oneMessageIsTheAnswer()
{
    QCOMPARE(judgeData(data(), 1).kind, Kind::Answer);
    QCOMPARE(judgeData(data(), 1).pdu(), QByteArray::fromHex("030427100000"));
    QCOMPARE(judgeData(refusal(3), 1).kind, Kind::Answer);
    QCOMPARE(judgeData(QByteArray(), 1).kind, Kind::Silent);
}

void RtuAnswerTest::messagesOfOthersAreLeftAside()
{
    const auto verdict = judgeData(data(2) + coils() + data() + data(3), 1);
    QCOMPARE(verdict.kind, Kind::Answer);
    QCOMPARE(verdict.frame, data());
    QCOMPARE(verdict.strays.size(), 3);
    QCOMPARE(judgeData(data(2) + coils(), 1).kind, Kind::Silent);
}

void RtuAnswerTest::twoAnswersAreNone()
{
    QCOMPARE(judgeData(data() + data(), 1).kind, Kind::Spoiled);
    QCOMPARE(judgeData(data() + refusal(3), 1).kind, Kind::Spoiled);
    QVERIFY(judgeData(data() + data(), 1).frame.isEmpty());
}

void RtuAnswerTest::bytesAroundAnAnswerSpoilIt()
{
    for (const QByteArray& noise : {QByteArray(1, '\0'), QByteArray("\x01\x03"), QByteArray(20, '\xff')}) {
        QCOMPARE(judgeData(noise + data(), 1).kind, Kind::Spoiled);
        QCOMPARE(judgeData(data() + noise, 1).kind, Kind::Spoiled);
    }
    for (qsizetype length = 1; length < data().size(); ++length) {
        QCOMPARE(judgeData(data().first(length), 1).kind, Kind::Spoiled);
        QCOMPARE(judgeData(data().sliced(length), 1).kind, Kind::Spoiled);
    }
}

void RtuAnswerTest::anyAnswerAboutCoilsProvesTheOrder()
{
    QCOMPARE(judgeCoils(coils(), 1).kind, Kind::Answer);
    QCOMPARE(judgeCoils(refusal(1), 1).kind, Kind::Answer);
    QCOMPARE(judgeCoils(data() + data() + coils(), 1).kind, Kind::Answer);
    QCOMPARE(judgeCoils(data(), 1).kind, Kind::Silent); // Late, and no proof.
    QCOMPARE(judgeCoils(coils(2), 1).kind, Kind::Silent);
}

void RtuAnswerTest::garbageIsNeverAnAnswer()
{
    std::mt19937 random(485);
    const QByteArray good = data(2) + data();
    for (int i = 0; i < 50'000; ++i) {
        QByteArray bytes = good;
        const qsizetype at = qsizetype(random() % quint32(bytes.size()));
        bytes[at] = char(bytes.at(at) ^ (1 << random() % 8));
        if (random() % 2)
            bytes = bytes.first(qsizetype(random() % quint32(bytes.size())));
        const auto verdict = judgeData(bytes, 1);
        if (verdict.kind == Kind::Answer)
            QVERIFY2(verdict.frame == data(), bytes.toHex().constData());
        QByteArray noise(qsizetype(random() % 300), '\0');
        for (char& byte : noise)
            byte = char(random());
        (void)judgeCoils(noise, quint8(random()));
    }
}

QTEST_APPLESS_MAIN(RtuAnswerTest)
#include "tst_rtu_answer.moc"
