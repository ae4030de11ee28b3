#include "teaching.h"

#include <algorithm>
#include <QTest>

using namespace lds::catalog;
using namespace lds::emulator;

namespace {

/// The 30 mm type as it comes: tolerance 2 mm, hysteresis 0.01 mm.
constexpr TeachingConditions conditions{20'000, 100, -95'000, 95'000, 1};

TeachingTarget at(Value wireUnits) { return {wireUnits * nanometresPerWireUnit, false, false, false}; }

} // namespace

/// §4.9, without a sensor around it.
class TeachingTest : public QObject {
    Q_OBJECT

    static std::optional<TaughtWindow> taught(const QList<Value>& values,
                                              const TeachingConditions& with = conditions)
    {
        Teaching teaching;
        teaching.start(int(values.size()), Operator::Communication);
        std::optional<TaughtWindow> window;
        for (const Value value : values)
            window = teaching.take(at(value), with);
        return window;
    }

private Q_SLOTS:
    void onePointIsTheValuePlusAndMinusTheTolerance();
    void onePointStaysWithinTheSettingRange();
    void twoPointsAreTheHigherAndTheLowerValue();
    void threePointsAreHalfWayToTheMedian_data();
    void threePointsAreHalfWayToTheMedian();
    void valuesFinerThanTheResolutionBecomeZero();
    void theSameValueTwiceFails();
    void aWindowNotWiderThanTwiceTheHysteresisFails();
    void aTargetThatCannotBeMeasuredFails_data();
    void aTargetThatCannotBeMeasuredFails();
    void statesGoAsTheManualHasThem();
    void interruptingAndStartingAgainForget();
};

void TeachingTest::onePointIsTheValuePlusAndMinusTheTolerance() // §4.9.1
{
    QCOMPARE(taught({1'234}), (TaughtWindow{21'234, -18'766}));
}

void TeachingTest::onePointStaysWithinTheSettingRange() // §4.9.1 note
{
    QCOMPARE(taught({90'000}), (TaughtWindow{95'000, 70'000}));
    QCOMPARE(taught({-90'000}), (TaughtWindow{-70'000, -95'000}));
}

void TeachingTest::twoPointsAreTheHigherAndTheLowerValue() // §4.9.2
{
    QCOMPARE(taught({-500, 700}), (TaughtWindow{700, -500}));
    QCOMPARE(taught({700, -500}), (TaughtWindow{700, -500}));
}

void TeachingTest::threePointsAreHalfWayToTheMedian_data()
{
    QTest::addColumn<QList<Value>>("values");
    const QList<Value> values{100, 200, 1'000};
    QList<int> order{0, 1, 2};
    do {
        QTest::addRow("%d%d%d", order[0], order[1], order[2])
            << QList<Value>{values[order[0]], values[order[1]], values[order[2]]};
    } while (std::next_permutation(order.begin(), order.end()));
}

void TeachingTest::threePointsAreHalfWayToTheMedian() // §4.9.3, in whatever order
{
    QFETCH(QList<Value>, values);
    QCOMPARE(taught(values), (TaughtWindow{600, 150}));
}

void TeachingTest::valuesFinerThanTheResolutionBecomeZero() // §4.9 note
{
    TeachingConditions coarse = conditions;
    coarse.resolution = 10;
    QCOMPARE(taught({1'239, -1'239}, coarse), (TaughtWindow{1'230, -1'230}));
    QCOMPARE(taught({1'239}, coarse), (TaughtWindow{21'230, -18'760}));
}

void TeachingTest::theSameValueTwiceFails() // §4.9.2 step 7, §4.9.3 step 8
{
    QVERIFY(!taught({500, 500}));
    QVERIFY(!taught({500, 500, 900}));
    QVERIFY(!taught({500, 900, 500}));
    QVERIFY(!taught({900, 500, 500}));
}

void TeachingTest::aWindowNotWiderThanTwiceTheHysteresisFails() // §4.9 note
{
    QVERIFY(!taught({0, 200}));
    QCOMPARE(taught({0, 201}), (TaughtWindow{201, 0}));
    TeachingConditions narrow = conditions;
    narrow.tolerance = 100;
    QVERIFY(!taught({0}, narrow));
    narrow.tolerance = 101;
    QVERIFY(taught({0}, narrow));
}

void TeachingTest::aTargetThatCannotBeMeasuredFails_data()
{
    QTest::addColumn<TeachingTarget>("target");
    QTest::newRow("alarm") << TeachingTarget{0, true, false, false};
    QTest::newRow("indeterminate") << TeachingTarget{std::nullopt, false, false, false};
    QTest::newRow("+OVER or -OVER") << TeachingTarget{9'600'000, false, true, false};
    QTest::newRow("hold") << TeachingTarget{0, false, false, true};
}

void TeachingTest::aTargetThatCannotBeMeasuredFails() // §4.9 note
{
    QFETCH(TeachingTarget, target);
    Teaching teaching;
    teaching.start(3, Operator::Communication);
    QVERIFY(!teaching.take(at(1), conditions));
    QVERIFY(!teaching.take(target, conditions));
    QCOMPARE(teaching.state(), TeachingState::Failed);
    QCOMPARE(teaching.nextPoint(), 0);
    QVERIFY(!teaching.take(at(5), conditions)); // over until it is started again
    QCOMPARE(teaching.state(), TeachingState::Failed);
}

void TeachingTest::statesGoAsTheManualHasThem()
{
    Teaching teaching;
    QCOMPARE(teaching.state(), TeachingState::NotExecuted);
    QVERIFY(!teaching.take(at(1), conditions));
    teaching.start(2, Operator::Keys);
    QCOMPARE(teaching.state(), TeachingState::Executing);
    QCOMPARE(teaching.operatedBy(), Operator::Keys);
    QCOMPARE(teaching.nextPoint(), 1);
    QVERIFY(!teaching.take(at(1), conditions));
    QCOMPARE(teaching.state(), TeachingState::Executing);
    QCOMPARE(teaching.nextPoint(), 2);
    QVERIFY(teaching.take(at(1'000), conditions));
    QCOMPARE(teaching.state(), TeachingState::Success);
    QCOMPARE(teaching.nextPoint(), 0);
}

void TeachingTest::interruptingAndStartingAgainForget()
{
    Teaching teaching;
    teaching.start(2, Operator::Communication);
    teaching.take(at(1), conditions);
    teaching.interrupt();
    QCOMPARE(teaching.state(), TeachingState::NotExecuted);
    teaching.start(2, Operator::Communication);
    QCOMPARE(teaching.nextPoint(), 1);
    teaching.take(at(2'000), conditions);
    QCOMPARE(teaching.take(at(5'000), conditions), (TaughtWindow{5'000, 2'000}));
}

QTEST_APPLESS_MAIN(TeachingTest)
#include "tst_teaching.moc"
