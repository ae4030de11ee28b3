#include "trend_ticks.h"

#include <QtTest>

using namespace lds::ui;

namespace {

constexpr qint64 second = 1'000'000'000;

QStringList texts(const auto& ticks)
{
    QStringList result;
    for (const auto& tick : ticks)
        result.append(tick.text);
    return result;
}

qint64 wallNs(const QDateTime& time) { return time.toMSecsSinceEpoch() * 1'000'000; }

} // namespace

class TrendTicksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TZ", "Asia/Kolkata"); } // half an hour off every full hour

    void stepsAreOneTwoFive()
    {
        QCOMPARE(niceStep(0.3), 1);
        QCOMPARE(niceStep(1.1), 2);
        QCOMPARE(niceStep(2.1), 5);
        QCOMPARE(niceStep(5.1), 10);
        QCOMPARE(niceStep(4'999), 5'000);
    }

    void valuesAreRoundAndShareTheirDecimals()
    {
        QCOMPARE(texts(valueTicks({3'100, 21'900}, 5)),
                 QStringList({QStringLiteral("0.50"), QStringLiteral("1.00"), QStringLiteral("1.50"),
                              QStringLiteral("2.00")}));
        QCOMPARE(texts(valueTicks({12'340, 12'350}, 6)),
                 QStringList({QStringLiteral("1.2340"), QStringLiteral("1.2342"), QStringLiteral("1.2344"),
                              QStringLiteral("1.2346"), QStringLiteral("1.2348"), QStringLiteral("1.2350")}));
    }

    void negativeValuesHaveATrueMinus()
    {
        QCOMPARE(texts(valueTicks({-11'000, 11'000}, 3)),
                 QStringList({QStringLiteral("−1.00"), QStringLiteral("0.00"), QStringLiteral("1.00")}));
    }

    void thereAreNeverMoreTicksThanAskedFor()
    {
        for (double span = 20; span < 4e7; span *= 1.37) {
            for (const int most : {2, 5, 11})
                QVERIFY(valueTicks({-span / 3, span * 2 / 3}, most).size() <= most + 1);
        }
        for (qint64 length = TrendTimeWindow::shortestNs; length < 20 * 24 * 3600 * second;
             length = length * 17 / 11) {
            for (const int most : {3, 8})
                QVERIFY(timeTicks({12'345, 12'345 + length}, 1'700'000'000 * second, most).size() <=
                        most + 1);
        }
    }

    void timesAreRoundOnTheLocalClock()
    {
        const qint64 at = wallNs(QDateTime(QDate(2026, 3, 1), QTime(10, 21, 0, 300)));
        const qint64 offset = at - 5 * second;
        const QList<TimeTick> ticks = timeTicks({5 * second, 15 * second}, offset, 6);
        QCOMPARE(texts(ticks), QStringList({QStringLiteral("10:21:02"), QStringLiteral("10:21:04"),
                                            QStringLiteral("10:21:06"), QStringLiteral("10:21:08"),
                                            QStringLiteral("10:21:10")}));
        QCOMPARE(ticks.first().monotonicNs, 5 * second + 1'700'000'000);
    }

    void hoursAreRoundInTheLocalZoneAndMidnightCarriesTheDate()
    {
        const qint64 at = wallNs(QDateTime(QDate(2026, 3, 1), QTime(20, 0)));
        const QStringList found = texts(timeTicks({0, 9 * 3600 * second}, at, 4));
        QCOMPARE(found, QStringList({QStringLiteral("21:00"),
                                     QLocale().toString(QDate(2026, 3, 2), QLocale::ShortFormat),
                                     QStringLiteral("03:00")}));
    }

    void fineTicksShowFractionsOfASecond()
    {
        const qint64 at = wallNs(QDateTime(QDate(2026, 3, 1), QTime(10, 21, 0)));
        QCOMPARE(texts(timeTicks({0, second}, at, 3)).first(), QStringLiteral("10:21:00.0"));
        QCOMPARE(texts(timeTicks({0, 100'000'000}, at, 3)).last(), QStringLiteral("10:21:00.10"));
        QCOMPARE(texts(timeTicks({0, 10'000'000}, at, 6)).last(), QStringLiteral("10:21:00.010"));
    }

    void durationsUseAtMostTwoUnits()
    {
        QCOMPARE(durationText(250'000'000), QStringLiteral("250 ms"));
        QCOMPARE(durationText(second), QStringLiteral("1 s"));
        QCOMPARE(durationText(4'220'000'000), QStringLiteral("4.2 s"));
        QCOMPARE(durationText(10 * second), QStringLiteral("10 s"));
        QCOMPARE(durationText(60 * second), QStringLiteral("1 min"));
        QCOMPARE(durationText(95 * second), QStringLiteral("1 min 35 s"));
        QCOMPARE(durationText(3600 * second), QStringLiteral("1 h"));
        QCOMPARE(durationText(49 * 3600 * second), QStringLiteral("2 d 1 h"));
        QCOMPARE(durationText(59'990'000'000), QStringLiteral("1 min"));
    }
};

QTEST_GUILESS_MAIN(TrendTicksTest)
#include "tst_trend_ticks.moc"
