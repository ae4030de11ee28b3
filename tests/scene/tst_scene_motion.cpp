#include "scene_fixture.h"

#include <cmath>
#include <limits>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;
using lds::catalog::Catalog;

namespace {

const QByteArray stepped = R"({"name": "stepped", "profile": [[0, 0], [5, 0], [5, 0.2], [10, 0.2]]})";
const QByteArray flat = R"({"name": "flat", "height": 0.5, "length": 20})";

Nanometres distanceAt(const std::shared_ptr<const Scene>& scene, qint64 timeNs)
{
    return scene->at(timeNs).distance;
}

} // namespace

class SceneMotionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void conveyorShowsAStepAtItsExactTime();
    void conveyorMovesAtItsSpeed();
    void conveyorFollowsItsOrderWithGaps();
    void conveyorWithAPitchHasEmptyPlaces();
    void conveyorStartsAgainForEver();
    void slopeRunsStraightBetweenItsPoints();
    void reflectanceRunsAlongTheWorkpiece();
    void workpieceLongerThanItsProfileGoesOnAsItEnds();
    void shaftTurnsAtItsSpeed();
    void shaftProfileClosesAroundTheCircle();
    void eccentricShaftSwingsOnceATurn();
    void eccentricSwingFollowsTheCosine();
    void eccentricSwingKeepsStepWithTheProfile();
    void plateSwingsByItsAmplitude();
    void plateSwingsAtItsFrequency();
    void stillWorkpieceStaysWhereItsMeasuringPointIs();
    void timelinePlacesWorkpiecesByTime();
    void timelineRepeats();
    void heightsInRangesSuitEveryType();
    void farFutureIsAnsweredAsWell();
    void sameMomentAlwaysLooksTheSame();
};

void SceneMotionTest::conveyorShowsAStepAtItsExactTime()
{
    const auto scene =
        sceneOf(sceneJson(stepped,
                          R"({"kind": "conveyor", "speed": 100, "order": ["stepped"], "gap": 10,
            "background": {"height": -1, "reflectance": 0.3}})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 0), 0);
    QCOMPARE(distanceAt(scene, 50 * ms - 1), 0);
    QCOMPARE(distanceAt(scene, 50 * ms), mm / 5); // 5 mm at 100 mm/s
    QCOMPARE(distanceAt(scene, 100 * ms - 1), mm / 5);
    QCOMPARE(distanceAt(scene, 100 * ms), -mm);
    QCOMPARE(scene->at(100 * ms).reflectance, 0.3);
    QVERIFY(scene->at(100 * ms).present);
    QCOMPARE(distanceAt(scene, 200 * ms - 1), -mm);
    QCOMPARE(distanceAt(scene, 200 * ms), 0);
}

void SceneMotionTest::conveyorMovesAtItsSpeed()
{
    for (const int speed : {1, 3, 70, 2000}) {
        const auto scene =
            sceneOf(sceneJson(stepped, R"({"kind": "conveyor", "order": ["stepped"], "speed": )" +
                                           QByteArray::number(speed) + '}'));
        QVERIFY(scene);
        const qint64 step = std::llround(5e9 / speed);
        QCOMPARE(distanceAt(scene, step - 1), 0);
        QCOMPARE(distanceAt(scene, step), mm / 5);
    }
}

void SceneMotionTest::conveyorFollowsItsOrderWithGaps()
{
    const auto scene = sceneOf(
        sceneJson(stepped + ',' + flat,
                  R"({"kind": "conveyor", "speed": 10, "order": ["flat", "stepped", "flat"], "gap": 5})"));
    QVERIFY(scene);
    // 20 mm flat, 5 nothing, 10 stepped, 5 nothing, 20 flat, 5 nothing; 10 mm each second.
    QCOMPARE(distanceAt(scene, 1999 * ms), mm / 2);
    QVERIFY(!scene->at(2000 * ms).present);
    QVERIFY(!scene->at(2499 * ms).present);
    QVERIFY(scene->at(2500 * ms).present);
    QCOMPARE(distanceAt(scene, 2999 * ms), 0);
    QCOMPARE(distanceAt(scene, 3000 * ms), mm / 5);
    QVERIFY(!scene->at(3500 * ms).present);
    QCOMPARE(distanceAt(scene, 4000 * ms), mm / 2);
    QVERIFY(!scene->at(6499 * ms).present);
    QVERIFY(scene->at(6500 * ms).present);
}

void SceneMotionTest::conveyorWithAPitchHasEmptyPlaces()
{
    const auto scene = sceneOf(sceneJson(
        flat, R"({"kind": "conveyor", "speed": 100, "order": ["flat", null, "flat"], "pitch": 30})"));
    QVERIFY(scene);
    QVERIFY(scene->at(0).present);
    QVERIFY(scene->at(200 * ms - 1).present);
    for (const qint64 empty : {200 * ms, 300 * ms, 450 * ms, 600 * ms - 1}) {
        QVERIFY(!scene->at(empty).present);
        QCOMPARE(scene->at(empty).reflectance, 0.0);
    }
    QVERIFY(scene->at(600 * ms).present);
    QVERIFY(!scene->at(800 * ms).present);
    QVERIFY(scene->at(900 * ms).present);
}

void SceneMotionTest::conveyorStartsAgainForEver()
{
    const auto scene =
        sceneOf(sceneJson(stepped, R"({"kind": "conveyor", "speed": 100, "order": ["stepped"], "gap": 10})"));
    QVERIFY(scene);
    const qint64 days = 300LL * 24 * 3600 * 1000 * ms; // a whole number of the 200 ms it takes
    QCOMPARE(distanceAt(scene, days + 50 * ms - 1), 0);
    QCOMPARE(distanceAt(scene, days + 50 * ms), mm / 5);
    QVERIFY(!scene->at(days + 100 * ms).present);
}

void SceneMotionTest::slopeRunsStraightBetweenItsPoints()
{
    const auto scene = sceneOf(sceneJson(R"({"name": "wedge", "profile": [[2, -1], [6, 1], [8, 0]]})",
                                         R"({"kind": "conveyor", "speed": 1, "order": ["wedge"]})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 0), -mm); // as its first point
    QCOMPARE(distanceAt(scene, 2000 * ms), -mm);
    QCOMPARE(distanceAt(scene, 3000 * ms), -mm / 2);
    QCOMPARE(distanceAt(scene, 4000 * ms), 0);
    QCOMPARE(distanceAt(scene, 6000 * ms), mm);
    QCOMPARE(distanceAt(scene, 7500 * ms), mm / 4);
}

void SceneMotionTest::reflectanceRunsAlongTheWorkpiece()
{
    const auto scene = sceneOf(sceneJson(R"({"name": "striped", "height": 0, "length": 30,
                      "reflectance": [[0, 5], [10, 5], [10, 0.02], [20, 0.02], [30, 1.02]]})",
                                         R"({"kind": "conveyor", "speed": 10, "order": ["striped"]})"));
    QVERIFY(scene);
    QCOMPARE(scene->at(1000 * ms - 1).reflectance, 5.0);
    QCOMPARE(scene->at(1000 * ms).reflectance, 0.02);
    QCOMPARE(scene->at(2000 * ms).reflectance, 0.02);
    QCOMPARE(scene->at(2500 * ms).reflectance, 0.52);
    QCOMPARE(scene->at(3000 * ms).reflectance, 5.0);
}

void SceneMotionTest::workpieceLongerThanItsProfileGoesOnAsItEnds()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "long", "profile": [[0, 0], [5, 1]], "length": 8, "reflectance": [[0, 1], [6, 2]]})",
        R"({"kind": "conveyor", "speed": 1, "order": ["long"]})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 7000 * ms), mm);
    QCOMPARE(scene->at(7000 * ms).reflectance, 2.0);
    QCOMPARE(distanceAt(scene, 8000 * ms), 0);
}

void SceneMotionTest::shaftTurnsAtItsSpeed()
{
    const auto scene =
        sceneOf(sceneJson(R"({"name": "cam", "profile": [[0, 0], [90, 0], [90, 1], [180, 1], [180, 0]]})",
                          R"({"kind": "shaft", "workpiece": "cam", "revolutionsPerSecond": 5})"));
    QVERIFY(scene);
    for (const int turn : {0, 1, 1234}) {
        const qint64 began = turn * 200 * ms;
        QCOMPARE(distanceAt(scene, began), 0);
        QCOMPARE(distanceAt(scene, began + 50 * ms - 1), 0);
        QCOMPARE(distanceAt(scene, began + 50 * ms), mm);
        QCOMPARE(distanceAt(scene, began + 100 * ms - 1), mm);
        QCOMPARE(distanceAt(scene, began + 100 * ms), 0);
    }
}

void SceneMotionTest::shaftProfileClosesAroundTheCircle()
{
    const auto scene =
        sceneOf(sceneJson(R"({"name": "oval", "profile": [[90, 1], [270, 0]], "reflectance": [[180, 2]]})",
                          R"({"kind": "shaft", "workpiece": "oval", "revolutionsPerSecond": 1})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 0), mm / 2); // half way from 270° to 90° of the next turn
    QCOMPARE(distanceAt(scene, 125 * ms), mm * 3 / 4);
    QCOMPARE(distanceAt(scene, 250 * ms), mm);
    QCOMPARE(distanceAt(scene, 500 * ms), mm / 2);
    QCOMPARE(distanceAt(scene, 750 * ms), 0);
    QCOMPARE(distanceAt(scene, 875 * ms), mm / 4);
    QCOMPARE(scene->at(300 * ms).reflectance, 2.0);
}

void SceneMotionTest::eccentricShaftSwingsOnceATurn()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "shaft", "height": 0.5})",
        R"({"kind": "shaft", "workpiece": "shaft", "revolutionsPerSecond": 2, "eccentricity": 0.25})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 0), mm * 3 / 4);
    QCOMPARE(distanceAt(scene, 125 * ms), mm / 2);
    QCOMPARE(distanceAt(scene, 250 * ms), mm / 4);
    QCOMPARE(distanceAt(scene, 375 * ms), mm / 2);
    QCOMPARE(distanceAt(scene, 500 * ms), mm * 3 / 4);
}

void SceneMotionTest::eccentricSwingFollowsTheCosine()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "shaft", "height": 0})",
        R"({"kind": "shaft", "workpiece": "shaft", "revolutionsPerSecond": 1, "eccentricity": 100})"));
    QVERIFY(scene);
    for (int degree = 0; degree < 360; ++degree) {
        const qint64 timeNs = degree * 1000 * ms / 360;
        const double expected = 100.0 * mm * std::cos(2 * M_PI * double(timeNs) / 1e9);
        QVERIFY2(std::abs(double(distanceAt(scene, timeNs)) - expected) <= 1, QByteArray::number(degree));
    }
}

void SceneMotionTest::eccentricSwingKeepsStepWithTheProfile()
{
    // Turns that no whole number of nanoseconds lasts; after years the side at 0° is still the one at 0°.
    for (const QByteArray& speed : {"3"_ba, "7.3"_ba, "16.666667"_ba, "101.01"_ba}) {
        const auto scene = sceneOf(
            sceneJson(R"({"name": "key", "profile": [[0, 0], [10, 0], [10, 5], [20, 5], [20, 0]]})",
                      R"({"kind": "shaft", "workpiece": "key", "eccentricity": 1, "revolutionsPerSecond": )" +
                          speed + '}'));
        QVERIFY(scene);
        const qint64 turn = std::llround(1e9 / speed.toDouble());
        for (const qint64 turns : {1LL, 1'000LL, 100'000'000LL}) {
            // The key begins at 10° and ends at 20°, wherever in its turn the shaft is by now.
            qint64 timeNs = turns * turn;
            const auto onKey = [&](qint64 at) { return distanceAt(scene, at) > 3 * mm; };
            while (onKey(timeNs))
                timeNs += turn / 36;
            while (!onKey(timeNs))
                timeNs += turn / 3600;
            QVERIFY(std::abs(double(distanceAt(scene, timeNs)) - mm * (5 + std::cos(10.05 / 180 * M_PI))) <
                    0.001 * mm);
        }
    }
}

void SceneMotionTest::plateSwingsByItsAmplitude()
{
    const auto scene =
        sceneOf(sceneJson(R"({"name": "plate", "height": 0.1})",
                          R"({"kind": "plate", "workpiece": "plate", "amplitude": 0.3, "frequency": 10})"));
    QVERIFY(scene);
    QCOMPARE(distanceAt(scene, 0), mm / 10);
    QCOMPARE(distanceAt(scene, 25 * ms), mm * 4 / 10);
    QCOMPARE(distanceAt(scene, 50 * ms), mm / 10);
    QCOMPARE(distanceAt(scene, 75 * ms), -mm * 2 / 10);
    for (qint64 timeNs = 0; timeNs < 1000 * ms; timeNs += ms / 10) {
        QVERIFY(distanceAt(scene, timeNs) <= mm * 4 / 10);
        QVERIFY(distanceAt(scene, timeNs) >= -mm * 2 / 10);
    }
}

void SceneMotionTest::plateSwingsAtItsFrequency()
{
    for (const int frequency : {1, 7, 50, 333}) {
        const auto scene =
            sceneOf(sceneJson(R"({"name": "plate", "height": 0})",
                              R"({"kind": "plate", "workpiece": "plate", "amplitude": 1, "frequency": )" +
                                  QByteArray::number(frequency) + '}'));
        QVERIFY(scene);
        int upward = 0; // crossings of the middle in two seconds
        Nanometres before = distanceAt(scene, ms / 20);
        for (qint64 timeNs = ms / 20; timeNs < 2000 * ms + ms / 10; timeNs += ms / 10) {
            const Nanometres now = distanceAt(scene, timeNs);
            upward += before < 0 && now >= 0;
            before = now;
        }
        QCOMPARE(upward, 2 * frequency);
    }
}

void SceneMotionTest::stillWorkpieceStaysWhereItsMeasuringPointIs()
{
    const auto scene = sceneOf(sceneJson(
        R"({"name": "stepped", "profile": [[0, 0], [5, 0], [5, 0.2], [10, 0.2]], "measuringPoint": 7})",
        R"({"kind": "still", "workpiece": "stepped"})"));
    QVERIFY(scene);
    for (const qint64 timeNs : {qint64(0), ms, 123'456 * ms})
        QCOMPARE(distanceAt(scene, timeNs), mm / 5);
}

void SceneMotionTest::timelinePlacesWorkpiecesByTime()
{
    const QByteArray workpieces =
        R"({"name": "low", "height": -0.5}, {"name": "high", "height": 0.5, "reflectance": 2})";
    const auto scene = sceneOf(sceneJson(workpieces, R"({"kind": "timeline", "places": [
        {"workpiece": "low", "atMs": 100}, {"workpiece": null, "atMs": 200}, {"workpiece": "high", "atMs": 350}]})"));
    QVERIFY(scene);
    QVERIFY(!scene->at(0).present);
    QVERIFY(!scene->at(100 * ms - 1).present);
    QCOMPARE(distanceAt(scene, 100 * ms), -mm / 2);
    QCOMPARE(distanceAt(scene, 200 * ms - 1), -mm / 2);
    QVERIFY(!scene->at(200 * ms).present);
    QCOMPARE(distanceAt(scene, 350 * ms), mm / 2);
    QCOMPARE(scene->at(350 * ms).reflectance, 2.0);
    QCOMPARE(distanceAt(scene, 1'000'000 * ms), mm / 2); // the last one stays
}

void SceneMotionTest::timelineRepeats()
{
    const auto scene =
        sceneOf(sceneJson(R"({"name": "low", "height": -0.5}, {"name": "high", "height": 0.5})",
                          R"({"kind": "timeline", "repeatMs": 300, "background": {"height": -2}, "places": [
            {"workpiece": "low", "atMs": 0}, {"workpiece": null, "atMs": 100}, {"workpiece": "high", "atMs": 200}]})"));
    QVERIFY(scene);
    for (const qint64 began : {qint64(0), 300 * ms, 3'000'000 * ms}) {
        QCOMPARE(distanceAt(scene, began), -mm / 2);
        QCOMPARE(distanceAt(scene, began + 100 * ms), -2 * mm);
        QCOMPARE(distanceAt(scene, began + 300 * ms - 1), mm / 2);
    }
}

void SceneMotionTest::heightsInRangesSuitEveryType()
{
    const QByteArray json = sceneJson(
        R"({"name": "part", "height": -0.5, "length": 10})",
        R"({"kind": "conveyor", "speed": 100, "order": ["part"], "gap": 10, "background": {"height": 0.25}})",
        R"(, "unit": "range")");
    int types = 0;
    for (const auto& model : Catalog::hlG2().models()) {
        const auto scene = sceneOf(json, model.model);
        QVERIFY(scene);
        const Nanometres range = model.measurementRange * nanometresPerWireUnit;
        QCOMPARE(distanceAt(scene, 99 * ms), -range / 2);
        QCOMPARE(distanceAt(scene, 100 * ms), range / 4); // lengths along the belt stay millimetres
        ++types;
    }
    QCOMPARE(types, 5);
}

void SceneMotionTest::farFutureIsAnsweredAsWell()
{
    for (const QByteArray& motion : {
             R"({"kind": "conveyor", "speed": 333, "order": ["flat"], "gap": 1})"_ba,
             R"({"kind": "plate", "workpiece": "flat", "amplitude": 1, "frequency": 77})"_ba,
             R"({"kind": "timeline", "places": [{"workpiece": "flat", "atMs": 3}], "repeatMs": 7})"_ba,
         }) {
        const auto scene = sceneOf(sceneJson(flat, motion, R"(, "noise": 0.1)"));
        QVERIFY(scene);
        const Nanometres distance = distanceAt(scene, std::numeric_limits<qint64>::max());
        QVERIFY(distance >= -2 * mm && distance <= 2 * mm);
        QCOMPARE(distanceAt(scene, -1), distanceAt(scene, 0));
    }
}

void SceneMotionTest::sameMomentAlwaysLooksTheSame()
{
    const auto scene = sceneOf(fullScene());
    const auto again = sceneOf(fullScene());
    QVERIFY(scene && again);
    for (qint64 timeNs = 0; timeNs < 2000 * ms; timeNs += 7 * ms + 13) {
        const Sight one = scene->at(timeNs);
        again->at(timeNs * 3); // what was asked before does not matter
        const Sight other = again->at(timeNs);
        QCOMPARE(one.present, other.present);
        QCOMPARE(one.distance, other.distance);
        QCOMPARE(one.reflectance, other.reflectance);
        QCOMPARE(one.ambientLight, other.ambientLight);
    }
}

QTEST_GUILESS_MAIN(SceneMotionTest)
#include "tst_scene_motion.moc"
