#include "precise_clock.h"
#include "system_clock.h"

#include <QTest>

using namespace lds::emulator;

class PreciseClockTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingComesBeforeItsTime();
    void mostComeWithinAFractionOfAMillisecond();
    void timersRunInTheOrderOfTheirTimes();
    void aTimeThatHasPassedComesAtOnce();
    void aCancelledTimerNeverComes();
    void aTimerDiesWithItsOwner();
    void theOtherClocksTimersGoOn();
    void aTimerMayStartTheNext();

private:
    SystemClock m_system;
    PreciseClock m_clock{m_system};
};

void PreciseClockTest::nothingComesBeforeItsTime()
{
    for (const qint64 delayNs : {1'000, 50'000, 300'000, 999'999, 2'500'000}) {
        const qint64 due = m_clock.nowNs() + delayNs;
        qint64 came = 0;
        m_clock.at(due, this, [&] { came = m_clock.nowNs(); });
        QTRY_VERIFY(came != 0);
        QVERIFY(came >= due);
    }
}

/// A busy machine delays some; timers of whole milliseconds would delay half of these by 0.5 ms or more.
void PreciseClockTest::mostComeWithinAFractionOfAMillisecond()
{
    QList<qint64> late;
    for (int time = 0; time < 41; ++time) {
        const qint64 due = m_clock.nowNs() + 1'050'000; // whole milliseconds would come at two
        qint64 came = 0;
        QEventLoop loop;
        m_clock.at(due, &loop, [&] {
            came = m_clock.nowNs();
            loop.quit();
        });
        loop.exec();
        late.append(came - due);
    }
    std::sort(late.begin(), late.end());
    qDebug("late by %lld ns in the middle, %lld at most", late.at(20), late.last());
    QVERIFY(late.at(20) < 500'000);
}

void PreciseClockTest::timersRunInTheOrderOfTheirTimes()
{
    QString order;
    const qint64 now = m_clock.nowNs();
    m_clock.at(now + 300'000, this, [&] { order += u'c'; });
    m_clock.at(now + 100'000, this, [&] { order += u'a'; });
    m_clock.at(now + 200'000, this, [&] { order += u'b'; });
    m_clock.at(now + 300'000, this, [&] { order += u'd'; });
    QTRY_COMPARE(order, QStringLiteral("abcd"));
}

void PreciseClockTest::aTimeThatHasPassedComesAtOnce()
{
    bool came = false;
    m_clock.at(m_clock.nowNs() - 1'000'000'000, this, [&] { came = true; });
    QVERIFY(!came); // but from the event loop
    QTRY_VERIFY(came);
}

void PreciseClockTest::aCancelledTimerNeverComes()
{
    bool first = false;
    bool second = false;
    const auto timer = m_clock.at(m_clock.nowNs() + 100'000, this, [&] { first = true; });
    m_clock.at(m_clock.nowNs() + 200'000, this, [&] { second = true; });
    m_clock.cancel(timer);
    m_clock.cancel(timer);
    m_clock.cancel(0);
    QTRY_VERIFY(second);
    QVERIFY(!first);
}

void PreciseClockTest::aTimerDiesWithItsOwner()
{
    bool first = false;
    bool second = false;
    auto owner = std::make_unique<QObject>();
    m_clock.at(m_clock.nowNs() + 100'000, owner.get(), [&] { first = true; });
    m_clock.at(m_clock.nowNs() + 200'000, this, [&] { second = true; });
    owner.reset();
    QTRY_VERIFY(second);
    QVERIFY(!first);
}

void PreciseClockTest::theOtherClocksTimersGoOn()
{
    bool first = false;
    bool second = false;
    const auto timer = m_clock.after(1, this, [&] { first = true; });
    m_clock.after(2, this, [&] { second = true; });
    m_clock.cancel(timer);
    QTRY_VERIFY(second);
    QVERIFY(!first);
}

void PreciseClockTest::aTimerMayStartTheNext()
{
    int count = 0;
    std::function<void()> next = [&] {
        if (++count < 20)
            m_clock.at(m_clock.nowNs() + 50'000, this, next);
    };
    next();
    QTRY_COMPARE(count, 20);
}

QTEST_GUILESS_MAIN(PreciseClockTest)
#include "tst_precise_clock.moc"
