#include "apply_plan.h"

#include "random_settings.h"
#include "settings_text.h"
#include "value_text.h"

#include <QtTest>

#include <array>

using namespace lds::settings;
using namespace lds::settings::test;
using namespace lds::catalog;

namespace {

constexpr int casesPerModel = 2'000;

/// What the person asked for, worked out without the planner: the sensor's values with the wanted ones,
/// rounded down, laid over; and One Shot gone where a new hold mode takes it away (§4.3.4).
Values goalOf(SensorModel model, const Values& current, const Values& wanted)
{
    Values goal = current;
    for (auto it = wanted.begin(); it != wanted.end(); ++it) {
        if (current.value(it.key()) != it.value())
            goal[it.key()] = effectiveValue(hlG2(it.key()), model, it.value());
    }
    const bool newHoldMode = goal[ItemId::HoldMode] != current[ItemId::HoldMode];
    if (newHoldMode && goal[ItemId::HoldMode] != 0 && !wanted.contains(ItemId::TriggerMode))
        goal[ItemId::TriggerMode] = 0;
    return goal;
}

/// §4.4.5: there is a moment at which the hysteresis is small enough to write the tolerance.
bool toleranceCanBeWritten(const Values& current, const Values& goal)
{
    return goal[ItemId::Tolerance] == current[ItemId::Tolerance] ||
           goal[ItemId::Tolerance] > std::min(current[ItemId::Hysteresis], goal[ItemId::Hysteresis]);
}

/// The octets of an address count as one.
int changedThings(const Values& current, const Values& goal)
{
    int things = 0;
    QSet<WriteGroup> groups;
    for (auto it = goal.begin(); it != goal.end(); ++it) {
        const WriteGroup group = hlG2(it.key()).group;
        if (current[it.key()] == it.value() || groups.contains(group))
            continue;
        ++things;
        if (group != WriteGroup::None)
            groups << group;
    }
    return things;
}

/// The empty text when the plan keeps every promise of apply_plan.h.
QString whatIsWrongWith(SensorModel model, const ApplyPlan& plan, const Values& current, const Values& goal)
{
    Values state = current;
    for (const Write& step : plan.steps) {
        const auto next = apply(model, state, step);
        if (!next)
            return QStringLiteral("refused: ") + text(step) + u' ' + text(QList{next.error()});
        const bool changes = std::any_of(
            step.begin(), step.end(), [&](const ItemValue& each) { return state[each.item] != each.value; });
        if (!changes)
            return QStringLiteral("writes what is held: ") + text(step);
        const bool isOneThing =
            step.size() == 1 ||
            (step.size() == 4 && std::all_of(step.begin(), step.end(), [&](const ItemValue& each) {
                 return hlG2(each.item).group == hlG2(step.first().item).group;
             }));
        if (!isOneThing)
            return QStringLiteral("not one message: ") + text(step);
        state = *next;
    }
    if (state != goal)
        return QStringLiteral("ends at ") + text(state);
    return {};
}

QByteArray describe(const QString& wrong, const Values& current, const Values& wanted, const Values& goal)
{
    return (wrong + QStringLiteral("\n  from ") + text(current) + QStringLiteral("\n  wanted ") +
            text(wanted) + QStringLiteral("\n  goal ") + text(goal))
        .toUtf8();
}

/// Texts are made only for what fails: there are tens of thousands of cases.
#define VERIFY_CASE(condition, wrong)                                                                        \
    do {                                                                                                     \
        if (!(condition))                                                                                    \
            QFAIL(describe(wrong, current, wanted, goal));                                                   \
    } while (false)

/// No write at all gets anywhere from here. For the window it is enough to try the most permissive value
/// of each item; for the network every mask, with the gateway off.
bool isStuck(SensorModel model, const Values& current)
{
    const auto accepts = [&](const Values& state, const Write& write) {
        return apply(model, state, write).has_value();
    };
    const bool windowMoves =
        accepts(current, {{ItemId::HighSetValue, hlG2(ItemId::HighSetValue).limitsFor(model).maximum}}) ||
        accepts(current, {{ItemId::LowSetValue, hlG2(ItemId::LowSetValue).limitsFor(model).minimum}}) ||
        accepts(current, {{ItemId::Hysteresis, 0}});
    const Values noGateway = current + address(WriteGroup::DefaultGateway, "0.0.0.0");
    bool networkMoves = accepts(noGateway, addressWrite(WriteGroup::IpAddress, "192.168.1.6"));
    for (int bits = 1; bits <= 32; ++bits) {
        const quint32 mask = quint32(~0ULL << (32 - bits));
        const QByteArray dotted = QByteArray::number(mask >> 24) + '.' +
                                  QByteArray::number(mask >> 16 & 255) + '.' +
                                  QByteArray::number(mask >> 8 & 255) + '.' + QByteArray::number(mask & 255);
        networkMoves = networkMoves || accepts(noGateway, addressWrite(WriteGroup::SubnetMask, dotted));
    }
    return !windowMoves || !networkMoves;
}

} // namespace

class ApplyPlanPropertiesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyGoalTheRulesAllowIsReached_data() { models(); }
    void everyGoalTheRulesAllowIsReached();
    void brokenStatesAreRepairedUnlessNoWriteIsAccepted_data() { models(); }
    void brokenStatesAreRepairedUnlessNoWriteIsAccepted();
    void withPartOfTheSensorUnknownThePlanStillHolds_data() { models(); }
    void withPartOfTheSensorUnknownThePlanStillHolds();
    void everySmallWindowReachesEveryOther();

private:
    static void models();
};

void ApplyPlanPropertiesTest::models()
{
    QTest::addColumn<SensorModel>("model");
    for (const ModelDescription& model : Catalog::hlG2().models())
        QTest::newRow(model.typeName) << model.model;
}

/// From a state the sensor allows, the plan exists exactly when the sensor could hold the goal and would
/// let the tolerance be written.
void ApplyPlanPropertiesTest::everyGoalTheRulesAllowIsReached()
{
    QFETCH(SensorModel, model);
    RandomSettings random(model, 1000 + quint32(model));
    int reached = 0;
    int failed = 0;
    for (int i = 0; i < casesPerModel; ++i) {
        const Values current = random.state();
        QVERIFY(check(model, current).isEmpty());
        const Values wanted = random.wish(current);
        const Values goal = goalOf(model, current, wanted);
        const auto plan = planWrites(model, current, wanted);
        const bool isAllowed = check(model, goal).isEmpty() && toleranceCanBeWritten(current, goal);
        VERIFY_CASE(plan.has_value() == isAllowed, plan ? text(plan->steps) : text(plan.error().refusals));
        QCOMPARE(goalProblems(model, current, wanted).isEmpty(), isAllowed);
        if (!plan) {
            QVERIFY(!plan.error().refusals.isEmpty());
            ++failed;
            continue;
        }
        ++reached;
        const QString wrong = whatIsWrongWith(model, *plan, current, goal);
        VERIFY_CASE(wrong.isEmpty(), wrong);
        // Ports that swap take one more, the gateway's way two, an address between two masks one.
        const int steps = int(plan->steps.size());
        VERIFY_CASE(steps <= changedThings(current, goal) + 4, text(plan->steps));
        QCOMPARE(planWrites(model, current, wanted)->steps, plan->steps);
    }
    QVERIFY2(reached > casesPerModel / 3 && failed > casesPerModel / 20,
             qPrintable(QStringLiteral("%1 reached, %2 failed").arg(reached).arg(failed)));
}

void ApplyPlanPropertiesTest::brokenStatesAreRepairedUnlessNoWriteIsAccepted()
{
    QFETCH(SensorModel, model);
    RandomSettings random(model, 2000 + quint32(model));
    int repaired = 0;
    for (int i = 0; i < casesPerModel; ++i) {
        const Values current = random.brokenState();
        // Half of the time a person wants all of it in order, else something or other.
        const Values wanted = i % 2 == 0 ? random.state() : random.wish(current);
        const Values goal = goalOf(model, current, wanted);
        const auto plan = planWrites(model, current, wanted);
        if (!plan) {
            const bool isAllowed = check(model, goal).isEmpty() && toleranceCanBeWritten(current, goal);
            QVERIFY(!plan.error().refusals.isEmpty());
            VERIFY_CASE(!isAllowed || isStuck(model, current), text(plan.error().refusals));
            continue;
        }
        const QString wrong = whatIsWrongWith(model, *plan, current, goal);
        VERIFY_CASE(wrong.isEmpty(), wrong);
        if (!check(model, current).isEmpty() && check(model, goal).isEmpty())
            ++repaired;
    }
    QVERIFY2(repaired > casesPerModel / 10, qPrintable(QString::number(repaired)));
}

/// What is not known is neither judged nor written unless wanted.
void ApplyPlanPropertiesTest::withPartOfTheSensorUnknownThePlanStillHolds()
{
    QFETCH(SensorModel, model);
    RandomSettings random(model, 3000 + quint32(model));
    std::mt19937 coin(quint32(model) + 1);
    int reached = 0;
    for (int i = 0; i < casesPerModel; ++i) {
        Values current = random.state();
        const Values wanted = random.wish(current);
        for (const ItemId item : current.keys()) {
            if (coin() % 4 == 0)
                current.remove(item);
        }
        const auto plan = planWrites(model, current, wanted);
        if (!plan)
            continue;
        Values state = current;
        for (const Write& step : plan->steps) {
            const auto next = apply(model, state, step);
            if (!next)
                QFAIL(qPrintable(text(step)));
            state = *next;
        }
        for (auto it = wanted.begin(); it != wanted.end(); ++it)
            QCOMPARE(effectiveValue(hlG2(it.key()), model, state[it.key()]),
                     effectiveValue(hlG2(it.key()), model, it.value()));
        for (const ItemId item : state.keys())
            QVERIFY(current.contains(item) || wanted.contains(item));
        ++reached;
    }
    QVERIFY(reached > casesPerModel / 4);
}

/// All windows on a grid of five values and three hystereses, each to each.
void ApplyPlanPropertiesTest::everySmallWindowReachesEveryOther()
{
    constexpr auto model = SensorModel::HlG203;
    QList<Values> windows;
    for (const Value high : {-95'000, -94'998, 0, 94'998, 95'000}) {
        for (const Value low : {-95'000, -94'998, 0, 94'998, 95'000}) {
            for (const Value hysteresis : {0, 1, 47'498, 94'999}) {
                const Values window{{ItemId::HighSetValue, high},
                                    {ItemId::LowSetValue, low},
                                    {ItemId::Hysteresis, hysteresis}};
                if (check(model, window).isEmpty())
                    windows << window;
            }
        }
    }
    QVERIFY(windows.size() > 20);
    for (const Values& current : std::as_const(windows)) {
        for (const Values& goal : std::as_const(windows)) {
            const Values& wanted = goal;
            const auto plan = planWrites(model, current, wanted);
            VERIFY_CASE(plan, text(plan.error().refusals));
            const QString wrong = whatIsWrongWith(model, *plan, current, goal);
            VERIFY_CASE(wrong.isEmpty(), wrong);
            // Between two states that are allowed no detour is ever needed here.
            QCOMPARE(int(plan->steps.size()), changedThings(current, goal));
        }
    }
}

QTEST_APPLESS_MAIN(ApplyPlanPropertiesTest)
#include "tst_apply_plan_properties.moc"
