#include "manual_clock.h"
#include "system_clock.h"

#include <QTest>

using namespace lds::emulator;

class EmulatorClockTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void manualClockRunsTimersInTheOrderOfTheirTime();
    void manualClockDropsTheTimersOfADeadOwner();
    void systemClockRunsATimerOnceAndNotACancelledOne();
    void systemClockDropsTheTimersOfADeadOwner();
};

void EmulatorClockTest::manualClockRunsTimersInTheOrderOfTheirTime()
{
    ManualClock clock;
    QStringList ran;
    clock.after(20, this, [&ran] { ran.append(QStringLiteral("late")); });
    clock.after(10, this, [this, &ran, &clock] {
        ran.append(QStringLiteral("early"));
        QCOMPARE(clock.nowNs(), 10'000'000);
        clock.after(5, this, [&ran] { ran.append(QStringLiteral("between")); });
    });
    const auto cancelled = clock.after(12, this, [&ran] { ran.append(QStringLiteral("never")); });
    clock.cancel(cancelled);
    clock.advanceMs(9);
    QVERIFY(ran.isEmpty());
    clock.advanceMs(11);
    QCOMPARE(ran.join(u' '), QStringLiteral("early between late"));
    QCOMPARE(clock.nowNs(), 20'000'000);
    QCOMPARE(clock.pending(), 0);
}

void EmulatorClockTest::manualClockDropsTheTimersOfADeadOwner()
{
    ManualClock clock;
    bool ran = false;
    {
        QObject owner;
        clock.after(1, &owner, [&ran] { ran = true; });
    }
    clock.advanceMs(2);
    QVERIFY(!ran);
}

void EmulatorClockTest::systemClockRunsATimerOnceAndNotACancelledOne()
{
    SystemClock clock;
    const qint64 before = clock.nowNs();
    int ran = 0;
    bool cancelledRan = false;
    const auto cancelled = clock.after(1, this, [&cancelledRan] { cancelledRan = true; });
    clock.after(5, this, [&ran] { ++ran; });
    clock.cancel(cancelled);
    clock.cancel(cancelled);
    clock.cancel(12345);
    QTRY_COMPARE(ran, 1);
    QVERIFY(!cancelledRan);
    QVERIFY(clock.nowNs() - before >= 5'000'000);
}

void EmulatorClockTest::systemClockDropsTheTimersOfADeadOwner()
{
    SystemClock clock;
    bool deadRan = false;
    bool ran = false;
    EmulatorClock::TimerId dead = 0;
    {
        QObject owner;
        dead = clock.after(1, &owner, [&deadRan] { deadRan = true; });
    }
    clock.after(5, this, [&ran] { ran = true; });
    QTRY_VERIFY(ran);
    QVERIFY(!deadRan);
    clock.cancel(dead); // harmless
}

QTEST_GUILESS_MAIN(EmulatorClockTest)
#include "tst_emulator_clock.moc"
