// A scene before a sensor: what is seen, and each edge of its faults and its trigger input at its time.
#include "scene_player.h"
#include "station_fixture.h"

#include <QSignalSpy>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;
using By = FaultDesk::By;
using namespace Qt::StringLiterals;

namespace {

/// Two workpieces, 1 mm and 2 mm towards the sensor, changing places every 1000 ms.
QByteArray sceneJson(const QByteArray& rest)
{
    return R"({"format": "lds-scene", "version": 1, "name": "Test", "description": "A test.", "unit": "mm",
        "workpieces": [{"name": "low", "height": 1}, {"name": "the high one", "height": 2}],
        "motion": {"kind": "still", "workpiece": "low"})" +
           rest + '}';
}

std::shared_ptr<const Scene> sceneWith(const QByteArray& rest)
{
    const auto scene = Scene::fromJson(sceneJson(rest), SensorModel::HlG203);
    if (!scene)
        qWarning("refused: %s", qPrintable(scene.error()));
    return scene.value_or(nullptr);
}

/// A clock whose event loop comes late: time passes without any timer running.
class StallingClock final : public EmulatorClock {
public:
    qint64 nowNs() const override { return m_clock.nowNs() + m_stalledNs; }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override
    {
        return m_clock.after(delayMs, owner, std::move(callback));
    }
    void cancel(TimerId timer) override { m_clock.cancel(timer); }
    void stallMs(qint64 milliseconds) { m_stalledNs += milliseconds * 1'000'000; }
    ManualClock& timers() { return m_clock; }

private:
    ManualClock m_clock;
    qint64 m_stalledNs = 0;
};

} // namespace

class ScenePlayerTest : public StationFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void findsTheNextEdgeOfAnInterval_data();
    void findsTheNextEdgeOfAnInterval();
    void showsTheSceneToTheSensor();
    void holdsAWorkpieceStillAndLetsItMoveAgain();
    void anUnknownWorkpieceChangesNothing();
    void holdsSomethingAtAPlace();
    void faultsGoOnAndOffAtTheirTimes();
    void overlappingIntervalsOfOneFaultAreOne();
    void aFaultFromTheBeginningIsOnAtOnce();
    void theTriggerInputFollowsTheScene();
    void aPersonsTriggerIsOred();
    void wakesUpForEdgesOnly();
    void anotherSceneTakesItsFaultsAndTriggerWithIt();
    void heldStillNothingOfTheSceneHappens();
    void edgesMissedInALongStallHappenAtTheirTimes();
    void manyEdgesInALongStallEndInTheRightState();
    void aSceneFileIsNamedInItsError();
};

void ScenePlayerTest::findsTheNextEdgeOfAnInterval_data()
{
    QTest::addColumn<Interval>("interval");
    QTest::newRow("once") << Interval{100, 50, 0};
    QTest::newRow("from the beginning") << Interval{0, 30, 0};
    QTest::newRow("for ever") << Interval{70, 0, 0};
    QTest::newRow("for ever from the beginning") << Interval{0, 0, 0};
    QTest::newRow("again and again") << Interval{20, 10, 25};
    QTest::newRow("again and again, a millisecond apart") << Interval{0, 9, 10};
    QTest::newRow("for a millisecond") << Interval{5, 1, 2};
}

/// Against covers(), millisecond by millisecond.
void ScenePlayerTest::findsTheNextEdgeOfAnInterval()
{
    QFETCH(Interval, interval);
    for (qint64 after = 0; after < 300; ++after) {
        std::optional<qint64> expected;
        for (qint64 time = after + 1; time < 400 && !expected; ++time) {
            if (interval.covers(time) != interval.covers(time - 1))
                expected = time;
        }
        QCOMPARE(nextEdgeMs(interval, after), expected);
    }
}

void ScenePlayerTest::showsTheSceneToTheSensor()
{
    player().play(sceneWith({}));
    m_clock->advanceMs(2000);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::MeasuredValue), 10'000);
    QCOMPARE(m_station->state().sceneName, u"Test"_s);
    QCOMPARE(m_station->state().workpieces, (QStringList{u"low"_s, u"the high one"_s}));
    player().play(nullptr);
    QCOMPARE(m_station->state().workpieces, QStringList());
    QSet<Value> values;
    for (int i = 0; i < 20; ++i) {
        m_clock->advanceMs(300);
        sensor().catchUp();
        values.insert(sensor().read(ItemId::MeasuredValue));
    }
    QVERIFY(values.size() > 10); // moves gently
}

void ScenePlayerTest::holdsAWorkpieceStillAndLetsItMoveAgain()
{
    player().play(sceneWith({}));
    QVERIFY(player().holdStill(u"the high one"_s));
    QVERIFY(!player().isMoving());
    m_clock->advanceMs(2000);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::MeasuredValue), 20'000);
    QCOMPARE(m_station->state().held, u"the high one"_s);
    player().letMove();
    QVERIFY(player().isMoving());
    m_clock->advanceMs(2000);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::MeasuredValue), 10'000);
}

void ScenePlayerTest::anUnknownWorkpieceChangesNothing()
{
    const QSignalSpy changed(&player(), &ScenePlayer::changed);
    QVERIFY(!player().holdStill(u"low"_s)); // no scene
    player().play(sceneWith({}));
    QVERIFY(!player().holdStill(u"high"_s));
    QVERIFY(player().isMoving());
    QCOMPARE(changed.size(), 1);
}

void ScenePlayerTest::holdsSomethingAtAPlace()
{
    player().holdAt(-12'345);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::MeasuredValue), -12'345);
    QCOMPARE(m_station->state().heldAt, -12'345);
    player().play(sceneWith({}));
    QVERIFY(player().isMoving());
    player().holdAt(5);
    QVERIFY(player().holdStill(u"low"_s));
    m_clock->advanceMs(2000);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::MeasuredValue), 10'000);
    QVERIFY(!m_station->state().heldAt);
}

void ScenePlayerTest::faultsGoOnAndOffAtTheirTimes()
{
    player().play(sceneWith(R"(, "faults": [
        {"fault": "inMenu", "atMs": 100, "forMs": 50},
        {"fault": "slowAnswers", "milliseconds": 70, "atMs": 120, "forMs": 10, "everyMs": 40}])"));
    const auto on = [this] {
        return qMakePair(!sensor().isReady(), faults().milliseconds(NamedFault::SlowAnswers));
    };
    for (int time = 0; time < 400; ++time) {
        const bool slow = time >= 120 && (time - 120) % 40 < 10;
        QCOMPARE(on(), qMakePair(time >= 100 && time < 150, slow ? 70 : 0));
        m_clock->advanceMs(1);
    }
}

void ScenePlayerTest::overlappingIntervalsOfOneFaultAreOne()
{
    player().play(sceneWith(R"(, "faults": [
        {"fault": "inMenu", "atMs": 100, "forMs": 100},
        {"fault": "inMenu", "atMs": 150, "forMs": 100}])"));
    m_clock->advanceMs(99);
    QVERIFY(sensor().isReady());
    for (int time = 100; time < 250; ++time) {
        m_clock->advanceMs(1);
        QVERIFY(!sensor().isReady());
    }
    m_clock->advanceMs(1);
    QVERIFY(sensor().isReady());
}

void ScenePlayerTest::aFaultFromTheBeginningIsOnAtOnce()
{
    player().play(sceneWith(R"(, "faults": [{"fault": "inMenu", "atMs": 0}])"));
    QVERIFY(!sensor().isReady());
    QVERIFY(faults().isOn(NamedFault::InMenu, By::Scene));
}

void ScenePlayerTest::theTriggerInputFollowsTheScene()
{
    player().play(sceneWith(R"(, "triggers": [{"atMs": 100, "forMs": 20, "everyMs": 100}])"));
    for (int time = 0; time < 400; time += 5) {
        const bool line = time >= 100 && time % 100 < 20;
        QCOMPARE(player().triggerByScene(), line);
        if (time % 100 == 10) { // the level has lasted its 2 ms
            sensor().catchUp();
            QCOMPARE(sensor().read(ItemId::TriggerInputExternal), Value(line));
        }
        m_clock->advanceMs(5);
    }
}

void ScenePlayerTest::aPersonsTriggerIsOred()
{
    const auto level = [this] {
        m_clock->advanceMs(5);
        sensor().catchUp();
        return sensor().read(ItemId::TriggerInputExternal);
    };
    player().play(sceneWith(R"(, "triggers": [{"atMs": 100, "forMs": 100}])"));
    player().setTrigger(true);
    QCOMPARE(level(), 1);
    m_clock->advanceMs(145);
    player().setTrigger(false);
    QCOMPARE(level(), 1); // the scene's
    player().setTrigger(true);
    m_clock->advanceMs(100);
    QCOMPARE(level(), 1); // the person's
    player().setTrigger(false);
    QCOMPARE(level(), 0);
}

void ScenePlayerTest::wakesUpForEdgesOnly()
{
    const int sensorTimers = m_clock->pending();
    player().play(sceneWith(R"(, "faults": [{"fault": "inMenu", "atMs": 100, "forMs": 50}])"));
    QCOMPARE(m_clock->pending(), sensorTimers + 1);
    m_clock->advanceMs(150);
    QCOMPARE(m_clock->pending(), sensorTimers); // there is nothing more to come
    player().play(sceneWith(R"(, "triggers": [{"atMs": 31536000000, "forMs": 5}])")); // in a year
    QCOMPARE(m_clock->pending(), sensorTimers + 1);
    player().play(sceneWith({}));
    QCOMPARE(m_clock->pending(), sensorTimers);
}

void ScenePlayerTest::anotherSceneTakesItsFaultsAndTriggerWithIt()
{
    player().play(sceneWith(R"(, "faults": [{"fault": "inMenu", "atMs": 0}, {"fault": "noLight", "atMs": 0}],
                               "triggers": [{"atMs": 0}])"));
    faults().switchOn(NamedFault::NoLight, By::Person);
    player().play(nullptr);
    QVERIFY(sensor().isReady());
    QVERIFY(!player().triggerByScene());
    QVERIFY(faults().isOn(NamedFault::NoLight)); // the person's stays
    m_clock->advanceMs(1000);
    sensor().catchUp();
    QCOMPARE(sensor().read(ItemId::TriggerInputExternal), 0);
}

void ScenePlayerTest::heldStillNothingOfTheSceneHappens()
{
    player().play(sceneWith(R"(, "faults": [{"fault": "inMenu", "atMs": 100, "forMs": 100}],
                               "triggers": [{"atMs": 100, "forMs": 100}])"));
    m_clock->advanceMs(150);
    QVERIFY(!sensor().isReady());
    QVERIFY(player().holdStill(u"low"_s));
    QVERIFY(sensor().isReady());
    QVERIFY(!player().triggerByScene());
    m_clock->advanceMs(5000);
    QVERIFY(sensor().isReady());
    player().letMove(); // from the beginning
    m_clock->advanceMs(99);
    QVERIFY(sensor().isReady());
    m_clock->advanceMs(1);
    QVERIFY(!sensor().isReady());
}

void ScenePlayerTest::edgesMissedInALongStallHappenAtTheirTimes()
{
    StallingClock clock;
    auto station = SensorStation::start({}, clock);
    QVERIFY(station.has_value());
    VirtualSensor& late = (*station)->sensor();
    late.write({{ItemId::AverageTimes, 0}, {ItemId::HoldMode, 1}}); // peak hold
    (*station)->player().play(sceneWith(R"(, "triggers": [{"atMs": 100, "forMs": 200}])"));
    clock.stallMs(250);
    (*station)->player().follow();
    late.catchUp();
    QCOMPARE(late.read(ItemId::TriggerInputExternal),
             1); // had it come just now, it would not have lasted 2 ms
    clock.stallMs(51);
    clock.timers().advanceMs(1000); // the sensor's own timer comes first
    late.catchUp();
    QCOMPARE(late.read(ItemId::TriggerInputExternal), 0);
}

void ScenePlayerTest::manyEdgesInALongStallEndInTheRightState()
{
    StallingClock clock;
    auto station = SensorStation::start({}, clock);
    QVERIFY(station.has_value());
    (*station)->player().play(
        sceneWith(R"(, "faults": [{"fault": "inMenu", "atMs": 0, "forMs": 1, "everyMs": 2}])"));
    for (const qint64 stall : {86'400'000LL, 86'400'001LL}) { // a day
        clock.stallMs(stall);
        (*station)->player().follow();
        const bool on = clock.nowNs() / 1'000'000 % 2 == 0;
        QCOMPARE((*station)->sensor().isReady(), !on);
    }
}

void ScenePlayerTest::aSceneFileIsNamedInItsError()
{
    const auto loaded = m_station->loadScene(u"/nowhere/scene.json"_s);
    QVERIFY(!loaded.has_value());
    QVERIFY2(loaded.error().contains(u"/nowhere/scene.json"_s), qPrintable(loaded.error()));
    QVERIFY(m_station->loadScene(u"conveyor-step"_s).has_value());
    QVERIFY(!m_station->loadScene(u"conveyor"_s).has_value());
    QCOMPARE(m_station->state().scene, u"conveyor-step"_s); // stays
    StationOptions options;
    options.scene = u"/nowhere/scene.json"_s;
    const auto station = SensorStation::start(options, *m_clock);
    QVERIFY(!station.has_value());
    QCOMPARE(station.error().kind, StationProblem::Kind::Scene);
}

QTEST_GUILESS_MAIN(ScenePlayerTest)
#include "tst_scene_player.moc"
