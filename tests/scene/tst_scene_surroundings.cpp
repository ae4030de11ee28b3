#include "scene_fixture.h"

#include <algorithm>
#include <QSet>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;

namespace {

const QByteArray part = R"({"name": "part", "height": 0.5, "reflectance": 0.7})";
const QByteArray still = R"({"kind": "still", "workpiece": "part"})";

} // namespace

class SceneSurroundingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void intervalIsOnOnce();
    void intervalIsOnForEver();
    void intervalIsOnAgainAndAgain();
    void noiseStaysInsideItsHalfWidthAndFillsIt();
    void noiseIsAnotherForAnotherSeed();
    void noiseChangesWithTheShortestSamplingCycle();
    void noNoiseWithoutAWorkpiece();
    void ambientLightIsConstant();
    void ambientLightComesAndGoes();
    void strongestAmbientLightCounts();
    void faultsComeWithTheirTimes();
    void savingLastsItsMilliseconds();
    void triggersComeWithTheirTimes();
    void everyFaultHasAName();
    void noFaultHasAnotherName();
    void holdsAWorkpieceStillAtItsMeasuringPoint();
    void holdsWhatTheMotionDoesNotShow();
    void heldShaftKeepsItsEccentricity();
    void heldPlateDoesNotSwing();
    void heldWorkpieceIsInTheSameLightAndNoise();
    void heldWorkpieceOutlivesItsScene();
    void holdsNothingForAnUnknownName();
    void namesItsWorkpiecesInTheirOrder();
};

void SceneSurroundingsTest::intervalIsOnOnce()
{
    const Interval interval{100, 50, 0};
    QVERIFY(!interval.covers(0));
    QVERIFY(!interval.covers(99));
    QVERIFY(interval.covers(100));
    QVERIFY(interval.covers(149));
    QVERIFY(!interval.covers(150));
    QVERIFY(!interval.covers(1'000'000));
}

void SceneSurroundingsTest::intervalIsOnForEver()
{
    const Interval interval{100, 0, 0};
    QVERIFY(!interval.covers(99));
    QVERIFY(interval.covers(100));
    QVERIFY(interval.covers(1'000'000'000'000));
}

void SceneSurroundingsTest::intervalIsOnAgainAndAgain()
{
    const Interval interval{100, 50, 200};
    QVERIFY(!interval.covers(99));
    for (const qint64 began : {100LL, 300LL, 500LL, 200'000'100LL}) {
        QVERIFY(!interval.covers(began - 1));
        QVERIFY(interval.covers(began));
        QVERIFY(interval.covers(began + 49));
        QVERIFY(!interval.covers(began + 50));
    }
}

void SceneSurroundingsTest::noiseStaysInsideItsHalfWidthAndFillsIt()
{
    const auto scene = sceneOf(sceneJson(part, still, R"(, "noise": 0.01)"));
    QVERIFY(scene);
    constexpr int samples = 20'000;
    double sum = 0;
    Nanometres least = mm;
    Nanometres most = 0;
    for (int i = 0; i < samples; ++i) {
        const Nanometres distance = scene->at(i * ms / 10).distance;
        least = std::min(least, distance);
        most = std::max(most, distance);
        sum += double(distance);
    }
    QVERIFY(least >= 490'000 && least < 490'100);
    QVERIFY(most <= 510'000 && most > 509'900);
    // The mean of so many even numbers lies within 0.01 mm / √3 / √samples of the middle, six times over.
    QVERIFY(std::abs(sum / samples - 500'000) < 6 * 10'000 / 1.732 / 141.4);
}

void SceneSurroundingsTest::noiseIsAnotherForAnotherSeed()
{
    const auto one = sceneOf(sceneJson(part, still, R"(, "noise": 0.01, "seed": 1)"));
    const auto unseeded = sceneOf(sceneJson(part, still, R"(, "noise": 0.01)"));
    const auto two = sceneOf(sceneJson(part, still, R"(, "noise": 0.01, "seed": 2)"));
    QVERIFY(one && two && unseeded);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        different += one->at(i * ms).distance != two->at(i * ms).distance;
        QCOMPARE(one->at(i * ms).distance, unseeded->at(i * ms).distance);
    }
    QVERIFY(different > 90);
}

void SceneSurroundingsTest::noiseChangesWithTheShortestSamplingCycle()
{
    const auto scene = sceneOf(sceneJson(part, still, R"(, "noise": 0.01)"));
    QVERIFY(scene);
    QCOMPARE(scene->at(0).distance, scene->at(ms / 10 - 1).distance);
    QVERIFY(scene->at(0).distance != scene->at(ms / 10).distance);
}

void SceneSurroundingsTest::noNoiseWithoutAWorkpiece()
{
    const auto scene = sceneOf(sceneJson(
        part, R"({"kind": "timeline", "places": [{"workpiece": null, "atMs": 0}]})", R"(, "noise": 0.5)"));
    QVERIFY(scene);
    for (int i = 0; i < 100; ++i) {
        QVERIFY(!scene->at(i * ms).present);
        QCOMPARE(scene->at(i * ms).distance, 0);
    }
}

void SceneSurroundingsTest::ambientLightIsConstant()
{
    const auto none = sceneOf(sceneJson(part, still));
    const auto some = sceneOf(sceneJson(part, still, R"(, "ambientLight": 0.3)"));
    QVERIFY(none && some);
    QCOMPARE(none->at(5 * ms).ambientLight, 0.0);
    QCOMPARE(some->at(0).ambientLight, 0.3);
    QCOMPARE(some->at(123'456 * ms).ambientLight, 0.3);
}

void SceneSurroundingsTest::ambientLightComesAndGoes()
{
    const auto scene = sceneOf(sceneJson(part, still, R"(, "ambientLight": {"level": 0.1, "intervals": [
        {"level": 2, "atMs": 500, "forMs": 100, "everyMs": 1000}, {"level": 0, "atMs": 200, "forMs": 50}]})"));
    QVERIFY(scene);
    QCOMPARE(scene->at(0).ambientLight, 0.1);
    QCOMPARE(scene->at(200 * ms).ambientLight, 0.0); // a shadow is an interval too
    QCOMPARE(scene->at(250 * ms).ambientLight, 0.1);
    QCOMPARE(scene->at(500 * ms - 1).ambientLight, 0.1);
    QCOMPARE(scene->at(500 * ms).ambientLight, 2.0);
    QCOMPARE(scene->at(600 * ms).ambientLight, 0.1);
    QCOMPARE(scene->at(7500 * ms).ambientLight, 2.0);
}

void SceneSurroundingsTest::strongestAmbientLightCounts()
{
    const auto scene = sceneOf(sceneJson(part, still, R"(, "ambientLight": {"intervals": [
        {"level": 0.5, "atMs": 0}, {"level": 2, "atMs": 100, "forMs": 100}, {"level": 1, "atMs": 150}]})"));
    QVERIFY(scene);
    QCOMPARE(scene->at(0).ambientLight, 0.5);
    QCOMPARE(scene->at(160 * ms).ambientLight, 2.0);
    QCOMPARE(scene->at(200 * ms).ambientLight, 1.0);
}

void SceneSurroundingsTest::faultsComeWithTheirTimes()
{
    const auto scene = sceneOf(fullScene());
    QVERIFY(scene);
    QCOMPARE(scene->faults().size(), 3);
    const ScheduledFault& dark = scene->faults().at(0);
    QCOMPARE(dark.fault, NamedFault::NoLight);
    QCOMPARE(dark.when.atMs, 1000);
    QCOMPARE(dark.when.forMs, 200);
    QCOMPARE(dark.when.everyMs, 5000);
    QCOMPARE(dark.milliseconds, 0);
    const ScheduledFault& slow = scene->faults().at(1);
    QCOMPARE(slow.fault, NamedFault::SlowAnswers);
    QCOMPARE(slow.when.forMs, 0);
    QCOMPARE(slow.milliseconds, 150);

    const auto plain =
        sceneOf(sceneJson(part, still, R"(, "faults": [{"fault": "slowAnswers", "atMs": 5}])"));
    QVERIFY(plain);
    QCOMPARE(plain->faults().first().milliseconds, *defaultMilliseconds(NamedFault::SlowAnswers));
}

void SceneSurroundingsTest::savingLastsItsMilliseconds()
{
    const auto scene = sceneOf(fullScene());
    QVERIFY(scene);
    const ScheduledFault& saving = scene->faults().at(2);
    QCOMPARE(saving.fault, NamedFault::Saving);
    QCOMPARE(saving.milliseconds, 2500);
    QCOMPARE(saving.when.atMs, 3000);
    QCOMPARE(saving.when.forMs, 2500);
    QCOMPARE(saving.when.everyMs, 10'000);
}

void SceneSurroundingsTest::triggersComeWithTheirTimes()
{
    const auto scene = sceneOf(fullScene());
    QVERIFY(scene);
    QCOMPARE(scene->triggers().size(), 1);
    QVERIFY(!scene->triggers().first().covers(99));
    QVERIFY(scene->triggers().first().covers(100));
    QVERIFY(!scene->triggers().first().covers(150));
    QVERIFY(scene->triggers().first().covers(300));
}

void SceneSurroundingsTest::everyFaultHasAName()
{
    QCOMPARE(allFaults().size(), 12);
    QSet<QString> keys;
    for (const NamedFault fault : allFaults()) {
        const QString key = keyOf(fault);
        QVERIFY(!key.isEmpty());
        keys.insert(key);
        QCOMPARE(faultNamed(key), fault);
        QCOMPARE(defaultMilliseconds(fault).has_value(),
                 fault == NamedFault::SlowAnswers || fault == NamedFault::Saving);
    }
    QCOMPARE(keys.size(), allFaults().size());
    QCOMPARE(keyOf(NamedFault::LaserCircuitError), u"laserCircuitError"_s);
    QCOMPARE(faultNamed(u"connectionDropped"_s), NamedFault::ConnectionDropped);
}

void SceneSurroundingsTest::noFaultHasAnotherName()
{
    for (const QString& name : {QString(), u"NoLight"_s, u"nolight"_s, u" noLight"_s, u"fire"_s})
        QVERIFY(!faultNamed(name));
}

void SceneSurroundingsTest::holdsAWorkpieceStillAtItsMeasuringPoint()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "stepped", "profile": [[0, 0], [5, 0], [5, 0.2], [10, 0.2]],
            "reflectance": [[0, 1], [10, 2]], "measuringPoint": 7.5},
           {"name": "wedge", "profile": [[0, 0], [8, 1]]})",
        R"({"kind": "conveyor", "speed": 10, "order": ["stepped"], "gap": 50})"));
    QVERIFY(scene);
    const auto held = scene->holdingStill(u"stepped"_s);
    QVERIFY(held);
    for (const qint64 timeNs : {qint64(0), 777 * ms, 1'000'000 * ms}) {
        QVERIFY(held->at(timeNs).present);
        QCOMPARE(held->at(timeNs).distance, mm / 5);
        QCOMPARE(held->at(timeNs).reflectance, 1.75);
    }
    QCOMPARE(scene->holdingStill(u"wedge"_s)->at(0).distance, mm / 2); // the middle, unless told
}

void SceneSurroundingsTest::holdsWhatTheMotionDoesNotShow()
{
    const auto scene = sceneOf(sceneJson(part + R"(, {"name": "gauge", "height": -0.25})", still));
    QVERIFY(scene);
    QCOMPARE(scene->holdingStill(u"gauge"_s)->at(0).distance, -mm / 4);
}

void SceneSurroundingsTest::heldShaftKeepsItsEccentricity()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "high", "height": 0.5}, {"name": "low", "height": 0.5, "measuringPoint": 180})",
        R"({"kind": "shaft", "workpiece": "high", "revolutionsPerSecond": 9, "eccentricity": 0.2})"));
    QVERIFY(scene);
    QCOMPARE(scene->holdingStill(u"high"_s)->at(5 * ms).distance, mm * 7 / 10);
    QCOMPARE(scene->holdingStill(u"low"_s)->at(5 * ms).distance, mm * 3 / 10);
}

void SceneSurroundingsTest::heldPlateDoesNotSwing()
{
    const auto scene = sceneOf(
        sceneJson(part, R"({"kind": "plate", "workpiece": "part", "amplitude": 0.2, "frequency": 10})"));
    QVERIFY(scene);
    QCOMPARE(scene->at(25 * ms).distance, mm * 7 / 10);
    QCOMPARE(scene->holdingStill(u"part"_s)->at(25 * ms).distance, mm / 2);
}

void SceneSurroundingsTest::heldWorkpieceIsInTheSameLightAndNoise()
{
    const auto scene = sceneOf(sceneJson(part, still, R"(, "noise": 0.01, "ambientLight": {"intervals": [
        {"level": 2, "atMs": 500}]})"));
    QVERIFY(scene);
    const auto held = scene->holdingStill(u"part"_s);
    for (int i = 0; i < 100; ++i)
        QCOMPARE(held->at(i * ms).distance, scene->at(i * ms).distance);
    QCOMPARE(held->at(499 * ms).ambientLight, 0.0);
    QCOMPARE(held->at(500 * ms).ambientLight, 2.0);
}

void SceneSurroundingsTest::heldWorkpieceOutlivesItsScene()
{
    std::shared_ptr<const Scenery> held;
    {
        const auto scene = sceneOf(sceneJson(part, still));
        QVERIFY(scene);
        held = scene->holdingStill(u"part"_s);
    }
    QCOMPARE(held->at(0).distance, mm / 2);
}

void SceneSurroundingsTest::holdsNothingForAnUnknownName()
{
    const auto scene = sceneOf(sceneJson(part, still));
    QVERIFY(scene);
    QVERIFY(!scene->holdingStill(u"Part"_s));
    QVERIFY(!scene->holdingStill(QString()));
}

void SceneSurroundingsTest::namesItsWorkpiecesInTheirOrder()
{
    const auto scene = sceneOf(fullScene());
    QVERIFY(scene);
    QCOMPARE(scene->workpieces(), QStringList({u"flat"_s, u"stepped"_s}));
    QCOMPARE(scene->name(), u"Everything"_s);
    QCOMPARE(scene->description(), u"Every field of a conveyor's scene."_s);
}

QTEST_GUILESS_MAIN(SceneSurroundingsTest)
#include "tst_scene_surroundings.moc"
