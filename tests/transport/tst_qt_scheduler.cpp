#include "qt_scheduler.h"

#include <memory>
#include <QSemaphore>
#include <QTest>
#include <QThread>

using lds::ports::QtScheduler;
using lds::ports::Scheduler;

class QtSchedulerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void runsOnceInTheThreadThatAsked();
    void shorterDelaysComeFirst();
    void cancelledTimerNeverRuns();
    void timerOfADeadOwnerNeverRuns();
    void callbackMayCancelAndStartOthers();
    void ownerMayOutliveTheScheduler();
    void unknownTimersAreIgnored();
    void monotonicClockDoesNotGoBack();
};

void QtSchedulerTest::runsOnceInTheThreadThatAsked()
{
    QThread thread;
    thread.start();
    auto* owner = new QObject;
    owner->moveToThread(&thread);
    auto scheduler = std::make_unique<QtScheduler>(); // Made here, used there.
    QThread* ranIn = nullptr;
    int runs = 0;
    QSemaphore done;
    QMetaObject::invokeMethod(owner, [&] {
        scheduler->after(1, owner, [&] {
            ranIn = QThread::currentThread();
            ++runs;
            scheduler->after(20, owner, [&] { done.release(); });
        });
    });
    QVERIFY(done.tryAcquire(1, 5000));
    QCOMPARE(ranIn, &thread);
    QCOMPARE(runs, 1);
    QMetaObject::invokeMethod(
        owner, [&] { scheduler.reset(); }, Qt::BlockingQueuedConnection);
    owner->deleteLater();
    thread.quit();
    QVERIFY(thread.wait(5000));
}

void QtSchedulerTest::shorterDelaysComeFirst()
{
    QtScheduler scheduler;
    QList<int> order;
    scheduler.after(30, this, [&] { order.append(30); });
    scheduler.after(0, this, [&] { order.append(0); });
    scheduler.after(10, this, [&] { order.append(10); });
    QTRY_COMPARE(order, (QList<int>{0, 10, 30}));
}

void QtSchedulerTest::cancelledTimerNeverRuns()
{
    QtScheduler scheduler;
    bool ran = false;
    bool later = false;
    const Scheduler::TimerId timer = scheduler.after(5, this, [&] { ran = true; });
    scheduler.after(30, this, [&] { later = true; });
    scheduler.cancel(timer);
    QTRY_VERIFY(later);
    QVERIFY(!ran);
}

void QtSchedulerTest::timerOfADeadOwnerNeverRuns()
{
    QtScheduler scheduler;
    auto owner = std::make_unique<QObject>();
    bool ran = false;
    bool later = false;
    scheduler.after(5, owner.get(), [&] { ran = true; });
    scheduler.after(30, this, [&] { later = true; });
    owner.reset();
    QTRY_VERIFY(later);
    QVERIFY(!ran);
}

void QtSchedulerTest::callbackMayCancelAndStartOthers()
{
    QtScheduler scheduler;
    bool cancelledRan = false;
    bool startedRan = false;
    Scheduler::TimerId own = 0;
    const Scheduler::TimerId other = scheduler.after(20, this, [&] { cancelledRan = true; });
    own = scheduler.after(1, this, [&] {
        scheduler.cancel(own);
        scheduler.cancel(other);
        scheduler.after(40, this, [&] { startedRan = true; });
    });
    QTRY_VERIFY(startedRan);
    QVERIFY(!cancelledRan);
}

void QtSchedulerTest::ownerMayOutliveTheScheduler()
{
    auto owner = std::make_unique<QObject>();
    auto scheduler = std::make_unique<QtScheduler>();
    bool ran = false;
    const Scheduler::TimerId cancelled = scheduler->after(1, owner.get(), [&] { ran = true; });
    scheduler->after(1, owner.get(), [&] { ran = true; });
    scheduler->cancel(cancelled);
    scheduler.reset();
    owner.reset(); // Nothing of the scheduler may hang on this object any more.
    QTest::qWait(20);
    QVERIFY(!ran);
}

void QtSchedulerTest::unknownTimersAreIgnored()
{
    QtScheduler scheduler;
    scheduler.cancel(0);
    scheduler.cancel(77);
    bool ran = false;
    const Scheduler::TimerId timer = scheduler.after(1, this, [&] { ran = true; });
    QVERIFY(timer != 0);
    QTRY_VERIFY(ran);
    scheduler.cancel(timer);
}

void QtSchedulerTest::monotonicClockDoesNotGoBack()
{
    const QtScheduler scheduler;
    qint64 last = scheduler.nowNs();
    for (int i = 0; i < 1000; ++i) {
        const qint64 now = scheduler.nowNs();
        QVERIFY(now >= last);
        last = now;
    }
}

QTEST_GUILESS_MAIN(QtSchedulerTest)
#include "tst_qt_scheduler.moc"
