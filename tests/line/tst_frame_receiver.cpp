// Where a frame begins and ends, in the line's time.
#include "frame_receiver.h"

#include <QTest>

using namespace lds::emulator;
using lds::modbus::RtuRate;

class FrameReceiverTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aFrameIsCompleteAfterItsBytesTimeAndTheSilence_data();
    void aFrameIsCompleteAfterItsBytesTimeAndTheSilence();
    void bytesThatFollowInTimeBelongToTheFrame();
    void aPauseOfMoreThanOneAndAHalfCharactersSpoilsIt();
    void bytesThatComeFasterThanTheLineQueue();
    void moreThan256BytesAreNoFrame();
    void bytesAtAnotherSpeedSpoilIt();
    void aSpoiledFrameEndsWithTheNextSilence();
    void aQuietLineHasNothing();
};

namespace {
constexpr RtuRate slow{9600};
constexpr qint64 character = 1'145'834; // at 9,600 bps
constexpr qint64 silence = 4'010'417;
constexpr qint64 gap = 1'718'750;
} // namespace

void FrameReceiverTest::aFrameIsCompleteAfterItsBytesTimeAndTheSilence_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<qint64>("dueNs"); // 8 characters and 3.5, or 1.75 ms
    QTest::newRow("9600") << 9600 << 9'166'667 + 4'010'417LL;
    QTest::newRow("19200") << 19200 << 4'583'334 + 2'005'209LL;
    QTest::newRow("38400") << 38400 << 2'291'667 + 1'750'000LL;
    QTest::newRow("115200") << 115200 << 763'889 + 1'750'000LL;
    QTest::newRow("230400") << 230400 << 381'945 + 1'750'000LL;
}

void FrameReceiverTest::aFrameIsCompleteAfterItsBytesTimeAndTheSilence()
{
    QFETCH(int, speed);
    QFETCH(qint64, dueNs);
    FrameReceiver receiver;
    receiver.feed("12345678", {speed}, 1'000'000'000);
    QCOMPARE(receiver.frameDueNs(), std::optional(1'000'000'000 + dueNs));
    QCOMPARE(receiver.take(), std::optional<QByteArray>("12345678"));
    QCOMPARE(receiver.frameDueNs(), std::nullopt);
}

void FrameReceiverTest::bytesThatFollowInTimeBelongToTheFrame()
{
    FrameReceiver receiver;
    receiver.feed("a", slow, 0);
    receiver.feed("b", slow, character + gap);
    QCOMPARE(receiver.frameDueNs(), std::optional(2 * character + gap + silence));
    QCOMPARE(receiver.take(), std::optional<QByteArray>("ab"));
}

void FrameReceiverTest::aPauseOfMoreThanOneAndAHalfCharactersSpoilsIt()
{
    FrameReceiver receiver;
    receiver.feed("a", slow, 0);
    receiver.feed("b", slow, character + gap + 1);
    QCOMPARE(receiver.frameDueNs(), std::optional(2 * character + gap + 1 + silence));
    QCOMPARE(receiver.take(), std::nullopt);
}

void FrameReceiverTest::bytesThatComeFasterThanTheLineQueue()
{
    FrameReceiver receiver;
    for (int i = 0; i < 8; ++i)
        receiver.feed("x", slow, i); // a nanosecond apart
    const qint64 due = *receiver.frameDueNs();
    QVERIFY(due >= 8 * character - 8 + silence && due <= 8 * character + silence);
    QCOMPARE(receiver.take(), std::optional<QByteArray>("xxxxxxxx"));
}

void FrameReceiverTest::moreThan256BytesAreNoFrame()
{
    FrameReceiver receiver;
    receiver.feed(QByteArray(256, 'x'), slow, 0);
    QCOMPARE(receiver.take()->size(), 256);
    receiver.feed(QByteArray(256, 'x'), slow, 0);
    receiver.feed("y", slow, 0);
    QCOMPARE(receiver.take(), std::nullopt);
    receiver.feed(QByteArray(100'000, 'x'), slow, 0);
    QCOMPARE(receiver.take(), std::nullopt);
}

void FrameReceiverTest::bytesAtAnotherSpeedSpoilIt()
{
    FrameReceiver receiver;
    receiver.feed("a", slow, 0);
    receiver.feed("b", {19200}, 0);
    QCOMPARE(receiver.take(), std::nullopt);
}

void FrameReceiverTest::aSpoiledFrameEndsWithTheNextSilence()
{
    FrameReceiver receiver;
    receiver.feed("a", slow, 0);
    receiver.spoil();
    receiver.feed("bcd", slow, character); // still the same: no silence came between
    QCOMPARE(receiver.take(), std::nullopt);
    receiver.feed("next", slow, 1'000'000'000);
    QCOMPARE(receiver.take(), std::optional<QByteArray>("next"));
}

void FrameReceiverTest::aQuietLineHasNothing()
{
    FrameReceiver receiver;
    receiver.spoil();
    receiver.feed({}, slow, 0);
    QCOMPARE(receiver.frameDueNs(), std::nullopt);
    receiver.feed("next", slow, 5);
    QCOMPARE(receiver.take(), std::optional<QByteArray>("next"));
}

QTEST_APPLESS_MAIN(FrameReceiverTest)
#include "tst_frame_receiver.moc"
