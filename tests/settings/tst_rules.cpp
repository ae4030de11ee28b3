#include "rules.h"

#include "settings_text.h"

#include <QtTest>

using namespace lds::settings;
using namespace lds::settings::test;
using namespace lds::catalog;

namespace {

constexpr auto model = SensorModel::HlG203;

Values window(Value high, Value low, Value hysteresis)
{
    return {{ItemId::HighSetValue, high}, {ItemId::LowSetValue, low}, {ItemId::Hysteresis, hysteresis}};
}

std::optional<Rule> refusedBy(const Values& state, const Write& write, SensorModel sensor = model)
{
    const auto next = apply(sensor, state, write);
    return next ? std::nullopt : std::optional(next.error().rule);
}

QList<Rule> rulesOf(const QList<Refusal>& refusals)
{
    QList<Rule> rules;
    for (const Refusal& refusal : refusals)
        rules << refusal.rule;
    return rules;
}

} // namespace

class RulesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anAcceptedWriteChangesWhatItNamesAndNothingElse();
    void statusAndAddresslessItemsAreNotWritable();
    void limitsHoldPerModel_data();
    void limitsHoldPerModel();
    void aChoiceTheModelLacksIsRefused();
    void valuesAreRoundedDownBeforeTheyAreJudged();
    void highMustBeAboveLow();
    void windowMustBeMoreThanTwiceTheHysteresis();
    void theLargestWindowDoesNotOverflow();
    void toleranceIsJudgedOnlyWhenWritten();
    void oneShotNeedsHoldModeNone();
    void anotherHoldModeTurnsOneShotIntoHold();
    void portsMustDifferAndSpare44818();
    void unknownNeighboursDoNotBlock();
    void onlyTheRulesTheWriteTouchesAreJudged();
    void aStateTheRulesWouldRefuseCanBeRepaired();
    void switchesAreJudgedByTheirOwnLimitsOnly();
    void aRefusalNamesTheWrittenItemFirst();
    void factorySettingsOfEveryModelPass();
    void checkFindsEveryBrokenRule();
    void checkAdmitsAToleranceTheHysteresisHasGrownPast();
};

void RulesTest::anAcceptedWriteChangesWhatItNamesAndNothingElse()
{
    const Values before = factorySettings(model);
    const auto after = apply(model, before, {{ItemId::HighSetValue, 60'000}});
    QVERIFY(after);
    QCOMPARE(text(*after), text(before + Values{{ItemId::HighSetValue, 60'000}}));
}

void RulesTest::statusAndAddresslessItemsAreNotWritable()
{
    QCOMPARE(refusedBy({}, {{ItemId::MeasuredValue, 0}}), Rule::NotWritable);
    QCOMPARE(refusedBy({}, {{ItemId::PortSlmp, 45'237}}), Rule::NotWritable);
    QCOMPARE(refusedBy({}, {{ItemId::MacAddress, 0}}), Rule::NotWritable);
}

void RulesTest::limitsHoldPerModel_data()
{
    QTest::addColumn<SensorModel>("sensor");
    QTest::addColumn<int>("largest");
    QTest::newRow("30 mm") << SensorModel::HlG203 << 95'000;
    QTest::newRow("50 mm") << SensorModel::HlG205 << 950'000;
    QTest::newRow("85 mm") << SensorModel::HlG208 << 950'000;
    QTest::newRow("120 mm") << SensorModel::HlG212 << 950'000;
    QTest::newRow("250 mm") << SensorModel::HlG225 << 9'500'000;
}

void RulesTest::limitsHoldPerModel()
{
    QFETCH(SensorModel, sensor);
    QFETCH(int, largest);
    const int step = hlG2(ItemId::Offset).limitsFor(sensor).resolution;
    QCOMPARE(refusedBy({}, {{ItemId::Offset, largest}}, sensor), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::Offset, -largest}}, sensor), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::Offset, largest + step}}, sensor), Rule::OutOfRange);
    QCOMPARE(refusedBy({}, {{ItemId::Offset, -largest - step}}, sensor), Rule::OutOfRange);
}

void RulesTest::aChoiceTheModelLacksIsRefused()
{
    QCOMPARE(refusedBy({}, {{ItemId::HoldMode, 3}}), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::HoldMode, 4}}), Rule::NotAChoice);
    // §4.8.1: four digits on the 30 mm type only, none behind the point on the others only
    QCOMPARE(refusedBy({}, {{ItemId::DisplayDigit, 0}}), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::DisplayDigit, 4}}), Rule::NotAChoice);
    QCOMPARE(refusedBy({}, {{ItemId::DisplayDigit, 0}}, SensorModel::HlG205), Rule::NotAChoice);
    QCOMPARE(refusedBy({}, {{ItemId::DisplayDigit, 4}}, SensorModel::HlG225), std::nullopt);
}

/// §1.4 "Setting resolution"
void RulesTest::valuesAreRoundedDownBeforeTheyAreJudged()
{
    const auto sensor = SensorModel::HlG205; // 1 µm
    const auto after = apply(sensor, window(100'000, -100'000, 200), {{ItemId::LowSetValue, -12'349}});
    QVERIFY(after);
    QCOMPARE(after->value(ItemId::LowSetValue), -12'340);
    // 20 + 409 rounded down leaves exactly twice the hysteresis.
    QCOMPARE(refusedBy(window(1'000, 20, 200), {{ItemId::HighSetValue, 429}}, sensor),
             Rule::WindowNotOverHysteresis);
    // 0.0009 mm becomes nothing, and the least tolerance is 0.001 mm.
    QCOMPARE(refusedBy({}, {{ItemId::Tolerance, 9}}, sensor), Rule::OutOfRange);
}

/// §4.4.1, §4.4.2
void RulesTest::highMustBeAboveLow()
{
    const Values state = window(1'000, 0, 0);
    QCOMPARE(refusedBy(state, {{ItemId::HighSetValue, 0}}), Rule::HighNotAboveLow);
    QCOMPARE(refusedBy(state, {{ItemId::HighSetValue, 1}}), std::nullopt);
    QCOMPARE(refusedBy(state, {{ItemId::LowSetValue, 1'000}}), Rule::HighNotAboveLow);
    QCOMPARE(refusedBy(state, {{ItemId::LowSetValue, 999}}), std::nullopt);
    QCOMPARE(refusedBy(window(0, 1'000, 0), {{ItemId::Hysteresis, 1}}), Rule::HighNotAboveLow);
}

/// §4.4.1–4.4.3
void RulesTest::windowMustBeMoreThanTwiceTheHysteresis()
{
    const Values state = window(1'000, 0, 100);
    QCOMPARE(refusedBy(state, {{ItemId::HighSetValue, 200}}), Rule::WindowNotOverHysteresis);
    QCOMPARE(refusedBy(state, {{ItemId::HighSetValue, 201}}), std::nullopt);
    QCOMPARE(refusedBy(state, {{ItemId::LowSetValue, 800}}), Rule::WindowNotOverHysteresis);
    QCOMPARE(refusedBy(state, {{ItemId::LowSetValue, 799}}), std::nullopt);
    QCOMPARE(refusedBy(state, {{ItemId::Hysteresis, 500}}), Rule::WindowNotOverHysteresis);
    QCOMPARE(refusedBy(state, {{ItemId::Hysteresis, 499}}), std::nullopt);
}

void RulesTest::theLargestWindowDoesNotOverflow()
{
    const auto sensor = SensorModel::HlG225;
    const Values widest = window(9'500'000, -9'500'000, 0);
    QCOMPARE(refusedBy(widest, {{ItemId::Hysteresis, 9'499'900}}, sensor), std::nullopt);
    QCOMPARE(refusedBy(widest, {{ItemId::Hysteresis, 9'500'000}}, sensor), Rule::WindowNotOverHysteresis);
    // What a sensor reports is not trusted to be in range.
    constexpr Value most = std::numeric_limits<Value>::max();
    constexpr Value least = std::numeric_limits<Value>::min();
    QCOMPARE(refusedBy(window(most, least, most), {{ItemId::HighSetValue, 0}}, sensor),
             Rule::WindowNotOverHysteresis);
}

/// §4.4.5: "Hysteresis can be set regardless of the tolerance value."
void RulesTest::toleranceIsJudgedOnlyWhenWritten()
{
    const Values state = window(50'000, -50'000, 100) + Values{{ItemId::Tolerance, 200}};
    QCOMPARE(refusedBy(state, {{ItemId::Tolerance, 100}}), Rule::ToleranceNotOverHysteresis);
    QCOMPARE(refusedBy(state, {{ItemId::Tolerance, 101}}), std::nullopt);
    QCOMPARE(refusedBy(state, {{ItemId::Hysteresis, 5'000}}), std::nullopt);
}

/// §4.6.2
void RulesTest::oneShotNeedsHoldModeNone()
{
    const Write oneShot{{ItemId::TriggerMode, 1}};
    QCOMPARE(refusedBy({{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 0}}, oneShot), std::nullopt);
    for (const Value holdMode : {1, 2, 3}) {
        QCOMPARE(refusedBy({{ItemId::HoldMode, holdMode}, {ItemId::TriggerMode, 0}}, oneShot),
                 Rule::OneShotNeedsNormalHold);
        QCOMPARE(refusedBy({{ItemId::HoldMode, holdMode}}, {{ItemId::TriggerMode, 0}}), std::nullopt);
    }
}

/// §4.3.4
void RulesTest::anotherHoldModeTurnsOneShotIntoHold()
{
    const Values oneShot{{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 1}};
    for (const Value holdMode : {1, 2, 3}) {
        const auto after = apply(model, oneShot, {{ItemId::HoldMode, holdMode}});
        QVERIFY(after);
        QCOMPARE(text(*after), text(Values{{ItemId::HoldMode, holdMode}, {ItemId::TriggerMode, 0}}));
    }
    const auto normal = apply(model, oneShot, {{ItemId::HoldMode, 0}});
    QVERIFY(normal);
    QCOMPARE(text(*normal), text(oneShot));
    const auto unknownTrigger = apply(model, {{ItemId::HoldMode, 0}}, {{ItemId::HoldMode, 1}});
    QVERIFY(unknownTrigger);
    QVERIFY(!unknownTrigger->contains(ItemId::TriggerMode));
}

/// §5.2.1, notes 1 and 2
void RulesTest::portsMustDifferAndSpare44818()
{
    const Values state{{ItemId::PortModbus, 502}, {ItemId::PortTool, 49'152}};
    for (const ItemId port : {ItemId::PortModbus, ItemId::PortTool}) {
        QCOMPARE(refusedBy(state, {{port, 44'818}}), Rule::PortReserved);
        QCOMPARE(refusedBy(state, {{port, 44'817}}), std::nullopt);
        QCOMPARE(refusedBy(state, {{port, 0}}), Rule::OutOfRange);
        QCOMPARE(refusedBy(state, {{port, 65'536}}), Rule::OutOfRange);
    }
    QCOMPARE(refusedBy(state, {{ItemId::PortModbus, 49'152}}), Rule::PortsEqual);
    QCOMPARE(refusedBy(state, {{ItemId::PortTool, 502}}), Rule::PortsEqual);
}

void RulesTest::unknownNeighboursDoNotBlock()
{
    QCOMPARE(refusedBy({}, {{ItemId::HighSetValue, -95'000}}), std::nullopt);
    QCOMPARE(refusedBy({{ItemId::HighSetValue, 0}}, {{ItemId::Hysteresis, 95'000}}), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::Tolerance, 1}}), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::TriggerMode, 1}}), std::nullopt);
    QCOMPARE(refusedBy({}, {{ItemId::PortTool, 502}}), std::nullopt);
    // HIGH against LOW is judged without the hysteresis.
    QCOMPARE(refusedBy({{ItemId::LowSetValue, 0}}, {{ItemId::HighSetValue, 0}}), Rule::HighNotAboveLow);
}

void RulesTest::onlyTheRulesTheWriteTouchesAreJudged()
{
    const Values broken = window(-5, 5, 95'000) + Values{{ItemId::PortModbus, 44'818},
                                                         {ItemId::PortTool, 44'818},
                                                         {ItemId::HoldMode, 1},
                                                         {ItemId::TriggerMode, 1},
                                                         {ItemId::Tolerance, 0}};
    QCOMPARE(refusedBy(broken, {{ItemId::Span, 20'000}}), std::nullopt);
    QCOMPARE(refusedBy(broken, {{ItemId::PortModbus, 502}}), std::nullopt);
    QCOMPARE(refusedBy(broken, {{ItemId::TriggerMode, 0}}), std::nullopt);
}

void RulesTest::aStateTheRulesWouldRefuseCanBeRepaired()
{
    const auto widened = apply(model, window(-10, 10, 30), {{ItemId::HighSetValue, 71}});
    QVERIFY(widened);
    QVERIFY(check(model, *widened).isEmpty());
    const auto noHold =
        apply(model, {{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 1}}, {{ItemId::HoldMode, 0}});
    QVERIFY(noHold);
    QCOMPARE(noHold->value(ItemId::TriggerMode), 1);
}

void RulesTest::switchesAreJudgedByTheirOwnLimitsOnly()
{
    const auto stopped = apply(model, {}, {{ItemId::LaserStop, 1}});
    QVERIFY(stopped);
    QCOMPARE(stopped->value(ItemId::LaserStop), 1);
    QCOMPARE(refusedBy({}, {{ItemId::LaserStop, 2}}), Rule::NotAChoice);
    const auto saved = apply(model, {}, {{ItemId::SetValueSaving, 0}});
    QVERIFY(saved);
    QVERIFY2(saved->isEmpty(), "a command has no value to hold");
}

void RulesTest::aRefusalNamesTheWrittenItemFirst()
{
    const auto byLow = apply(model, window(1'000, 0, 100), {{ItemId::LowSetValue, 900}});
    QVERIFY(!byLow);
    QCOMPARE(byLow.error().items, (QList{ItemId::LowSetValue, ItemId::HighSetValue, ItemId::Hysteresis}));
    const auto byTool = apply(model, {{ItemId::PortModbus, 502}}, {{ItemId::PortTool, 502}});
    QVERIFY(!byTool);
    QCOMPARE(byTool.error().items, (QList{ItemId::PortTool, ItemId::PortModbus}));
}

void RulesTest::factorySettingsOfEveryModelPass()
{
    for (const ModelDescription& each : Catalog::hlG2().models()) {
        const Values settings = factorySettings(each.model);
        QVERIFY(settings.size() > 30);
        QCOMPARE(text(check(each.model, settings)), QString());
    }
}

void RulesTest::checkFindsEveryBrokenRule()
{
    const Values broken =
        factorySettings(model) + Values{{ItemId::HighSetValue, 95'001}, {ItemId::HoldMode, 1},
                                        {ItemId::TriggerMode, 1},       {ItemId::Hysteresis, 90'000},
                                        {ItemId::DisplayDigit, 4},      {ItemId::PortTool, 44'818}};
    const QList<Rule> rules = rulesOf(check(model, broken));
    QCOMPARE(rules, (QList{Rule::OutOfRange, Rule::NotAChoice, Rule::WindowNotOverHysteresis,
                           Rule::OneShotNeedsNormalHold, Rule::PortReserved}));
    QCOMPARE(rulesOf(check(model, window(0, 1, 0))), (QList{Rule::HighNotAboveLow}));
    QCOMPARE(rulesOf(check(model, {{ItemId::PortTool, 502}, {ItemId::PortModbus, 502}})),
             (QList{Rule::PortsEqual}));
    QVERIFY2(check(model, {{ItemId::MeasuredValue, 9'999'999}}).isEmpty(), "only settings are looked at");
}

/// §4.4.5: the sensor could hold it, so it is no broken state.
void RulesTest::checkAdmitsAToleranceTheHysteresisHasGrownPast()
{
    QVERIFY(check(model, window(50'000, -50'000, 5'000) + Values{{ItemId::Tolerance, 200}}).isEmpty());
}

QTEST_APPLESS_MAIN(RulesTest)
#include "tst_rules.moc"
