#include "manual_scheduler.h"

#include <QtTest>

#include <memory>

using namespace lds::ports;

class ManualSchedulerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void timersRunInOrderEachAtItsOwnTime();
    void timersSetByTimersRunInTheSameAdvance();
    void aCancelledTimerNeverRuns();
    void aTimerDiesWithItsOwner();
    void bothClocksMoveTogether();
};

void ManualSchedulerTest::timersRunInOrderEachAtItsOwnTime()
{
    ManualScheduler scheduler;
    const qint64 start = scheduler.nowNs();
    QList<QPair<int, qint64>> ran;
    for (const int delay : {30, 10, 20, 10}) // equal ones in the order they were set
        scheduler.after(delay, this,
                        [&, delay] { ran << qMakePair(delay, (scheduler.nowNs() - start) / 1'000'000); });
    scheduler.advanceMs(9);
    QVERIFY(ran.isEmpty());
    scheduler.advanceMs(1);
    QCOMPARE(ran.size(), 2);
    scheduler.advanceMs(100);
    QCOMPARE(ran, (QList<QPair<int, qint64>>{{10, 10}, {10, 10}, {20, 20}, {30, 30}}));
    QCOMPARE(scheduler.nowNs() - start, 110'000'000);
}

void ManualSchedulerTest::timersSetByTimersRunInTheSameAdvance()
{
    ManualScheduler scheduler;
    int ticks = 0;
    std::function<void()> tick = [&] {
        ++ticks;
        scheduler.after(10, this, tick);
    };
    scheduler.after(10, this, tick);
    scheduler.advanceMs(55);
    QCOMPARE(ticks, 5);
    QCOMPARE(scheduler.pendingTimers(), 1);
}

void ManualSchedulerTest::aCancelledTimerNeverRuns()
{
    ManualScheduler scheduler;
    bool ran = false;
    const Scheduler::TimerId timer = scheduler.after(10, this, [&] { ran = true; });
    QVERIFY(timer != 0);
    scheduler.cancel(timer);
    scheduler.cancel(timer);
    scheduler.cancel(0);
    scheduler.advanceMs(100);
    QVERIFY(!ran);
}

void ManualSchedulerTest::aTimerDiesWithItsOwner()
{
    ManualScheduler scheduler;
    bool ran = false;
    auto owner = std::make_unique<QObject>();
    scheduler.after(10, owner.get(), [&] { ran = true; });
    owner.reset();
    scheduler.advanceMs(100);
    QVERIFY(!ran);
}

void ManualSchedulerTest::bothClocksMoveTogether()
{
    ManualScheduler scheduler;
    const qint64 wall = scheduler.wallMs();
    const qint64 now = scheduler.nowNs();
    scheduler.advanceMs(1'234);
    QCOMPARE(scheduler.wallMs() - wall, 1'234);
    QCOMPARE(scheduler.nowNs() - now, 1'234'000'000);
}

QTEST_APPLESS_MAIN(ManualSchedulerTest)
#include "tst_manual_scheduler.moc"
