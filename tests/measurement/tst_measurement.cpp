#include "measurement.h"

#include <QtTest>

using namespace lds::measurement;

class MeasurementTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sentinelsAreKnownExactly_data();
    void sentinelsAreKnownExactly();
    void aValueUnderAnAlarmIsFrozen();
};

/// §5.2.4 notes
void MeasurementTest::sentinelsAreKnownExactly_data()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<ValueKind>("kind");
    QTest::newRow("zero") << 0 << ValueKind::Valid;
    QTest::newRow("largest display value") << 9'500'000 << ValueKind::Valid;
    QTest::newRow("smallest display value") << -9'500'000 << ValueKind::Valid;
    QTest::newRow("over") << 9'600'000 << ValueKind::Over;
    QTest::newRow("under") << -9'600'000 << ValueKind::Under;
    QTest::newRow("indeterminate") << -9'999'999 << ValueKind::Indeterminate;
    QTest::newRow("alarm") << 9'999'999 << ValueKind::Alarm;
    QTest::newRow("next to over") << 9'599'999 << ValueKind::Valid;
    QTest::newRow("next to indeterminate") << -9'999'998 << ValueKind::Valid;
}

void MeasurementTest::sentinelsAreKnownExactly()
{
    QFETCH(int, value);
    QTEST(kindOf(value), "kind");
}

/// §4.7.2: with the alarm output on Hold the sensor reports an alarm and the last value.
void MeasurementTest::aValueUnderAnAlarmIsFrozen()
{
    Measurement measurement;
    measurement.kind = ValueKind::Valid;
    QVERIFY(measurement.hasValue() && !measurement.isFrozen());
    measurement.state = AlarmBit | GoBit;
    QVERIFY(measurement.hasValue() && measurement.isFrozen());
    measurement.kind = ValueKind::Alarm;
    QVERIFY(!measurement.hasValue() && !measurement.isFrozen());
}

QTEST_APPLESS_MAIN(MeasurementTest)
#include "tst_measurement.moc"
