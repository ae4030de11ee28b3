#include "apply_plan.h"

#include "settings_text.h"

#include <QtTest>

using namespace lds::settings;
using namespace lds::settings::test;
using namespace lds::catalog;

namespace {

constexpr auto model = SensorModel::HlG203;

Values window(Value high, Value low, Value hysteresis, Value tolerance)
{
    return {{ItemId::HighSetValue, high},
            {ItemId::LowSetValue, low},
            {ItemId::Hysteresis, hysteresis},
            {ItemId::Tolerance, tolerance}};
}

Values network(const char* ip, const char* mask, const char* gateway)
{
    return address(WriteGroup::IpAddress, ip) + address(WriteGroup::SubnetMask, mask) +
           address(WriteGroup::DefaultGateway, gateway);
}

/// "ipAddress 192.168.2.6; defaultGateway 0.0.0.0": a step a group, a name once.
QString inShort(const QList<Write>& steps)
{
    QStringList parts;
    for (const Write& step : steps) {
        if (step.size() != 4) {
            parts << text(step);
            continue;
        }
        QStringList numbers;
        for (const ItemValue& each : step)
            numbers << QString::number(each.value);
        QString name = QString::fromLatin1(hlG2(step.first().item).key);
        name.chop(int(qstrlen("1stOctet")));
        parts << name + u' ' + numbers.join(u'.');
    }
    return parts.join(QStringLiteral("; "));
}

QString planned(const Values& current, const Values& wanted)
{
    const auto plan = planWrites(model, current, wanted);
    return plan ? inShort(plan->steps) : QStringLiteral("no plan: ") + text(plan.error().refusals);
}

std::optional<Rule> failure(const Values& current, const Values& wanted)
{
    const auto plan = planWrites(model, current, wanted);
    return plan ? std::nullopt : std::optional(plan.error().refusals.first().rule);
}

} // namespace

class ApplyPlanTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingToDoIsAnEmptyPlan();
    void stepsTakeTheOrderThatTheRulesAccept_data();
    void stepsTakeTheOrderThatTheRulesAccept();
    void whatCannotBeSaysWhichRule_data();
    void whatCannotBeSaysWhichRule();
    void wantedValuesAreRoundedDown();
    void aHeldValueFinerThanTheResolutionStays();
    void aHeldValueThatCannotBePutBackIsNoDetour();
    void partOfAnAddressBringsTheOtherOctets();
    void partOfAnUnknownAddressIsIncomplete();
    void onlySettingsArePlanned();
    void stuckWindowsSayWhatHoldsThem();
    void anAddressBetweenTwoMasksGoesThroughTheFactoryAddress();
};

void ApplyPlanTest::nothingToDoIsAnEmptyPlan()
{
    const Values factory = factorySettings(model);
    QCOMPARE(planned(factory, {}), QString());
    QCOMPARE(planned(factory, factory), QString());
}

void ApplyPlanTest::stepsTakeTheOrderThatTheRulesAccept_data()
{
    QTest::addColumn<Values>("current");
    QTest::addColumn<Values>("wanted");
    QTest::addColumn<QString>("steps");

    const auto row = [](const char* name, const Values& current, const Values& wanted, const char* steps) {
        QTest::newRow(name) << current << wanted << QString::fromLatin1(steps);
    };
    const Values narrow = window(1'000, 0, 100, 500);
    row("§4.4.1 window up past itself", narrow, {{ItemId::HighSetValue, 9'000}, {ItemId::LowSetValue, 8'000}},
        "highSetValue=9000; lowSetValue=8000");
    row("window down past itself", narrow, {{ItemId::HighSetValue, -8'000}, {ItemId::LowSetValue, -9'000}},
        "lowSetValue=-9000; highSetValue=-8000");
    row("§4.4.3 hysteresis grows with the window", narrow,
        {{ItemId::HighSetValue, 9'000}, {ItemId::Hysteresis, 4'000}}, "highSetValue=9000; hysteresis=4000");
    row("hysteresis shrinks before the window", narrow,
        {{ItemId::HighSetValue, 50}, {ItemId::Hysteresis, 10}}, "hysteresis=10; highSetValue=50");
    row("§4.4.5 tolerance before a growing hysteresis", narrow,
        {{ItemId::Hysteresis, 400}, {ItemId::Tolerance, 300}}, "tolerance=300; hysteresis=400");
    row("tolerance after a shrinking hysteresis", narrow, {{ItemId::Hysteresis, 10}, {ItemId::Tolerance, 50}},
        "hysteresis=10; tolerance=50");
    row("hysteresis past a tolerance nobody writes", narrow, {{ItemId::Hysteresis, 499}}, "hysteresis=499");

    const Values normal{{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 0}};
    const Values oneShot{{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 1}};
    const Values peak{{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 0}};
    row("§4.6.2 One Shot after hold mode None", peak, oneShot, "holdMode=0; triggerMode=1");
    row("§4.3.4 the sensor itself leaves One Shot", oneShot, {{ItemId::HoldMode, 1}}, "holdMode=1");
    row("and is not told what it does itself", oneShot, peak, "holdMode=1");
    row("One Shot alone", normal, {{ItemId::TriggerMode, 1}}, "triggerMode=1");
    const Values neverAllowed{{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 1}};
    row("a hold mode is not written again to leave One Shot", neverAllowed, {{ItemId::TriggerMode, 0}},
        "triggerMode=0");

    const Values ports{{ItemId::PortModbus, 502}, {ItemId::PortTool, 49'152}};
    row("ports that swap pass through a free one", ports,
        {{ItemId::PortModbus, 49'152}, {ItemId::PortTool, 502}},
        "portModbus=49153; portTool=502; portModbus=49152");
    row("a port that becomes free first", ports, {{ItemId::PortModbus, 49'152}, {ItemId::PortTool, 50'000}},
        "portTool=50000; portModbus=49152");
    row("the other port that becomes free first", ports, {{ItemId::PortModbus, 503}, {ItemId::PortTool, 502}},
        "portModbus=503; portTool=502");

    const Values factory = network("192.168.1.6", "255.255.255.0", "192.168.1.1");
    row("§5.1.1 gateway off, address, gateway on", factory, network("10.0.0.6", "255.255.255.0", "10.0.0.1"),
        "defaultGateway 0.0.0.0; ipAddress 10.0.0.6; defaultGateway 10.0.0.1");
    row("gateway that stays off", factory, network("10.0.0.6", "255.255.255.0", "0.0.0.0"),
        "defaultGateway 0.0.0.0; ipAddress 10.0.0.6");
    row("address in the same subnet", factory, network("192.168.1.7", "255.255.255.0", "192.168.1.1"),
        "ipAddress 192.168.1.7");
    row("mask before an address that needs it", network("192.168.1.6", "255.255.255.0", "0.0.0.0"),
        network("192.168.2.255", "255.255.0.0", "0.0.0.0"),
        "subnetMask 255.255.0.0; ipAddress 192.168.2.255");
    row("gateway put back where nobody wanted it changed", factory,
        address(WriteGroup::IpAddress, "192.168.2.6") + address(WriteGroup::SubnetMask, "255.255.252.0"),
        "subnetMask 255.255.252.0; ipAddress 192.168.2.6");

    row("independent items in the catalog's order", {}, {{ItemId::Span, 20'000}, {ItemId::AverageTimes, 3}},
        "averageTimes=3; span=20000");
    row("a window upside down", window(-10, 10, 30, 500), window(20, 10, 2, 500),
        "highSetValue=95000; hysteresis=2; highSetValue=20");
}

void ApplyPlanTest::stepsTakeTheOrderThatTheRulesAccept()
{
    QFETCH(Values, current);
    QFETCH(Values, wanted);
    QTEST(planned(current, wanted), "steps");
}

void ApplyPlanTest::whatCannotBeSaysWhichRule_data()
{
    QTest::addColumn<Values>("current");
    QTest::addColumn<Values>("wanted");
    QTest::addColumn<Rule>("rule");

    const auto row = [](const char* name, const Values& current, const Values& wanted, Rule rule) {
        QTest::newRow(name) << current << wanted << rule;
    };
    const Values narrow = window(1'000, 0, 100, 500);
    row("HIGH below LOW", narrow, {{ItemId::HighSetValue, -1}}, Rule::HighNotAboveLow);
    row("window within the hysteresis", narrow, {{ItemId::LowSetValue, 800}}, Rule::WindowNotOverHysteresis);
    row("tolerance within the hysteresis", narrow, {{ItemId::Tolerance, 100}},
        Rule::ToleranceNotOverHysteresis);
    row("tolerance within both hystereses", narrow, {{ItemId::Tolerance, 100}, {ItemId::Hysteresis, 200}},
        Rule::ToleranceNotOverHysteresis);
    row("One Shot with a hold mode", {{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 0}},
        {{ItemId::TriggerMode, 1}}, Rule::OneShotNeedsNormalHold);
    row("One Shot kept with a hold mode", {{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 1}},
        {{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 1}}, Rule::OneShotNeedsNormalHold);
    row("reserved port", {}, {{ItemId::PortTool, 44'818}}, Rule::PortReserved);
    row("one port for both", {{ItemId::PortModbus, 502}}, {{ItemId::PortTool, 502}}, Rule::PortsEqual);
    row("address away from its gateway", network("192.168.1.6", "255.255.255.0", "192.168.1.1"),
        address(WriteGroup::IpAddress, "10.0.0.6"), Rule::GatewayOtherNetwork);
    row("out of range", {}, {{ItemId::HighSetValue, 95'001}}, Rule::OutOfRange);
    row("no choice", {}, {{ItemId::HoldMode, 9}}, Rule::NotAChoice);
}

void ApplyPlanTest::whatCannotBeSaysWhichRule()
{
    QFETCH(Values, current);
    QFETCH(Values, wanted);
    QTEST(failure(current, wanted).value_or(Rule::NotWritable), "rule");
}

void ApplyPlanTest::wantedValuesAreRoundedDown()
{
    const auto plan = planWrites(SensorModel::HlG205, {{ItemId::Offset, 120}},
                                 {{ItemId::Offset, -1'239}, {ItemId::LowSetValue, 129}});
    QVERIFY(plan);
    QCOMPARE(text(plan->steps), QStringLiteral("lowSetValue=120; offset=-1230"));
    const auto none = planWrites(SensorModel::HlG205, {{ItemId::Offset, 120}}, {{ItemId::Offset, 129}});
    QVERIFY(none);
    QVERIFY2(none->steps.isEmpty(), "the sensor would make of it what it holds");
}

/// Teaching may have stored it.
void ApplyPlanTest::aHeldValueFinerThanTheResolutionStays()
{
    const auto plan =
        planWrites(SensorModel::HlG205, {{ItemId::HighSetValue, 125}}, {{ItemId::HighSetValue, 125}});
    QVERIFY(plan);
    QVERIFY(plan->steps.isEmpty());
}

void ApplyPlanTest::aHeldValueThatCannotBePutBackIsNoDetour()
{
    // The way to this hysteresis is to widen the window, but LOW's 5 could not be restored.
    const Values upsideDown{
        {ItemId::HighSetValue, -100'000}, {ItemId::LowSetValue, 5}, {ItemId::Hysteresis, 500'000}};
    const auto plan =
        planWrites(SensorModel::HlG205, upsideDown, {{ItemId::HighSetValue, 100}, {ItemId::Hysteresis, 0}});
    QVERIFY(!plan);
    Values restorable = upsideDown;
    restorable[ItemId::LowSetValue] = -10;
    QVERIFY(planWrites(SensorModel::HlG205, restorable + Values{{ItemId::Hysteresis, 400'000}},
                       {{ItemId::HighSetValue, 100}, {ItemId::Hysteresis, 0}}));
}

void ApplyPlanTest::partOfAnAddressBringsTheOtherOctets()
{
    QCOMPARE(
        planned(network("192.168.1.6", "255.255.255.0", "192.168.1.1"), {{ItemId::IpAddress4thOctet, 9}}),
        QStringLiteral("ipAddress 192.168.1.9"));
}

void ApplyPlanTest::partOfAnUnknownAddressIsIncomplete()
{
    QCOMPARE(failure({}, {{ItemId::IpAddress4thOctet, 9}}), Rule::GroupIncomplete);
}

void ApplyPlanTest::onlySettingsArePlanned()
{
    QCOMPARE(failure({}, {{ItemId::LaserStop, 1}}), Rule::NotWritable);
    QCOMPARE(failure({}, {{ItemId::SetValueSaving, 0}}), Rule::NotWritable);
    QCOMPARE(failure({}, {{ItemId::PortSlmp, 45'000}}), Rule::NotWritable);
}

/// With this hysteresis no window is wide enough, and with this window no hysteresis small enough.
void ApplyPlanTest::stuckWindowsSayWhatHoldsThem()
{
    const auto plan = planWrites(model, window(-5, 5, 95'000, 1), window(1'000, 0, 0, 500));
    QVERIFY(!plan);
    QVERIFY(!plan.error().refusals.isEmpty());
    QVERIFY(goalProblems(model, window(-5, 5, 95'000, 1), window(1'000, 0, 0, 500)).isEmpty());
}

/// 192.0.0.0 is a host in /1 but not in /24, and 10.0.0.5 is one in /24 but not in /1.
void ApplyPlanTest::anAddressBetweenTwoMasksGoesThroughTheFactoryAddress()
{
    QCOMPARE(planned(network("192.0.0.0", "128.0.0.0", "0.0.0.0"),
                     network("10.0.0.5", "255.255.255.0", "0.0.0.0")),
             QStringLiteral("ipAddress 192.168.1.6; subnetMask 255.255.255.0; ipAddress 10.0.0.5"));
}

QTEST_APPLESS_MAIN(ApplyPlanTest)
#include "tst_apply_plan.moc"
