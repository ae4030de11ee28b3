#include "poll_ticker.h"

#include "manual_scheduler.h"

#include <QTest>

using namespace lds;
using scheduling::PollTicker;

namespace {

/// A clock whose timers run when the test says, however late that is.
class LateScheduler final : public ports::Scheduler {
public:
    qint64 nowNs() const override { return now; }
    qint64 wallMs() const override { return now / 1'000'000; }
    TimerId after(int delayMs, QObject*, std::function<void()> callback) override
    {
        delay = delayMs;
        m_callback = std::move(callback);
        return 1;
    }
    void cancel(TimerId timer) override
    {
        if (timer == 1)
            m_callback = {};
    }
    void runAt(qint64 ns)
    {
        now = ns;
        if (const auto callback = std::exchange(m_callback, {}))
            callback();
    }
    qint64 now = 0;
    int delay = -1;

private:
    std::function<void()> m_callback;
};

} // namespace

class PollTickerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ticksAtOnceAndThenAtTheInterval();
    void lateTickDoesNotMoveTheNext();
    void missedTicksAreToldOnceAndNotMadeUpFor();
    void fractionsOfAMillisecondDoNotAddUp();
    void stopsInsideItsOwnTick();
    void ownerTakesTheTickingAlong();
};

void PollTickerTest::ticksAtOnceAndThenAtTheInterval()
{
    ports::ManualScheduler clock;
    QObject owner;
    int ticks = 0;
    PollTicker ticker(clock, &owner, [&](quint64 missed) {
        QCOMPARE(missed, quint64(0));
        ++ticks;
    });
    ticker.start(10);
    clock.advanceMs(0);
    QCOMPARE(ticks, 1);
    clock.advanceMs(9);
    QCOMPARE(ticks, 1);
    clock.advanceMs(1);
    QCOMPARE(ticks, 2);
    clock.advanceMs(1000);
    QCOMPARE(ticks, 102);
    ticker.stop();
    clock.advanceMs(1000);
    QCOMPARE(ticks, 102);
    QCOMPARE(clock.pendingTimers(), 0);
}

void PollTickerTest::lateTickDoesNotMoveTheNext()
{
    LateScheduler clock;
    QObject owner;
    PollTicker ticker(clock, &owner, [](quint64) {});
    ticker.start(10);
    QCOMPARE(clock.delay, 0);
    clock.runAt(4'000'000);
    QCOMPARE(clock.delay, 6);
}

void PollTickerTest::missedTicksAreToldOnceAndNotMadeUpFor()
{
    LateScheduler clock;
    QObject owner;
    QList<quint64> missed;
    PollTicker ticker(clock, &owner, [&](quint64 count) { missed.append(count); });
    ticker.start(10);
    clock.runAt(0);
    clock.runAt(47'000'000); // Due at 10; those of 20, 30 and 40 have passed.
    QCOMPARE(missed, (QList<quint64>{0, 3}));
    QCOMPARE(clock.delay, 3);
    clock.runAt(50'000'000);
    QCOMPARE(missed, (QList<quint64>{0, 3, 0}));
}

void PollTickerTest::fractionsOfAMillisecondDoNotAddUp()
{
    LateScheduler clock;
    QObject owner;
    quint64 ticks = 0;
    quint64 lost = 0;
    PollTicker ticker(clock, &owner, [&](quint64 missed) {
        ++ticks;
        lost += missed;
    });
    ticker.start(1);
    // Every timer comes 80 µs late, as they do.
    while (clock.now < 1'000'000'000)
        clock.runAt(clock.now + clock.delay * 1'000'000 + 80'000);
    QVERIFY2(ticks >= 999 && ticks <= 1001, qPrintable(QString::number(ticks)));
    QCOMPARE(lost, quint64(0));
}

void PollTickerTest::stopsInsideItsOwnTick()
{
    ports::ManualScheduler clock;
    QObject owner;
    int ticks = 0;
    std::unique_ptr<PollTicker> ticker;
    ticker = std::make_unique<PollTicker>(clock, &owner, [&](quint64) {
        if (++ticks == 2)
            ticker->stop();
    });
    ticker->start(10);
    clock.advanceMs(100);
    QCOMPARE(ticks, 2);
    QVERIFY(!ticker->isRunning());
}

void PollTickerTest::ownerTakesTheTickingAlong()
{
    ports::ManualScheduler clock;
    auto owner = std::make_unique<QObject>();
    int ticks = 0;
    PollTicker ticker(clock, owner.get(), [&](quint64) { ++ticks; });
    ticker.start(10);
    owner.reset();
    clock.advanceMs(100);
    QCOMPARE(ticks, 0);
}

QTEST_GUILESS_MAIN(PollTickerTest)
#include "tst_poll_ticker.moc"
