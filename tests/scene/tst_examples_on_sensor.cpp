#include "manual_clock.h"
#include "scene_fixture.h"
#include "virtual_sensor.h"

#include <memory>
#include <QSet>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;
using lds::catalog::Catalog;
using lds::catalog::ItemId;
using lds::catalog::SensorModel;

/// The examples before a virtual sensor with a sampling cycle of 1 ms, nothing averaged, and an alarm at
/// the first sample that cannot be measured.
class ExamplesOnSensorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyTypeMeasuresThemWithoutAlarm_data();
    void everyTypeMeasuresThemWithoutAlarm();
    void taughtWindowTellsTheStepsApart();
    void peakToPeakShowsTheKeywayOfTheShaft();
    void brightnessAdjustsAtEveryEdgeBetweenRubberAndSteel();
    void tunedBrightnessTakesTheEdgesAtOnce();
    void emptyPlacesRaiseTheAlarm();

private:
    /// A sensor of this type before an example; false when something went wrong.
    bool put(const QString& example, SensorModel model = SensorModel::HlG203);
    void hold(const QString& workpiece, int forMs);
    Measured after(int milliseconds);
    bool write(ItemId id, lds::catalog::Value value) { return !m_sensor->write({{id, value}}).refusal; }

    std::unique_ptr<ManualClock> m_clock;
    std::unique_ptr<VirtualSensor> m_sensor;
    std::shared_ptr<const Scene> m_scene;
};

bool ExamplesOnSensorTest::put(const QString& example, SensorModel model)
{
    m_sensor.reset();
    m_clock = std::make_unique<ManualClock>();
    m_sensor = std::make_unique<VirtualSensor>(model, *m_clock);
    const auto scene = Scene::load(example, model);
    if (!scene)
        return false;
    m_scene = *scene;
    const bool set = write(ItemId::AverageTimes, 0) && write(ItemId::AlarmDelayCount, 1);
    m_sensor->setScenery(m_scene);
    return set;
}

void ExamplesOnSensorTest::hold(const QString& workpiece, int forMs)
{
    m_sensor->setScenery(m_scene->holdingStill(workpiece));
    after(forMs);
}

Measured ExamplesOnSensorTest::after(int milliseconds)
{
    m_clock->advanceMs(milliseconds);
    m_sensor->catchUp();
    return m_sensor->measured();
}

void ExamplesOnSensorTest::everyTypeMeasuresThemWithoutAlarm_data()
{
    QTest::addColumn<QString>("example");
    for (const QString& key : {u"conveyor-step"_s, u"rotating-shaft"_s, u"vibrating-plate"_s})
        QTest::newRow(qPrintable(key)) << key;
}

void ExamplesOnSensorTest::everyTypeMeasuresThemWithoutAlarm()
{
    QFETCH(QString, example);
    for (const auto& model : Catalog::hlG2().models()) {
        QVERIFY(put(example, model.model));
        QVERIFY(write(ItemId::AlarmDelayCount, 8)); // the default bears an edge between bright and dark
        after(100);                                 // the brightness has been found
        for (int i = 0; i < 3000; ++i) {
            const Measured measured = after(1);
            QVERIFY(!measured.alarm);
            QVERIFY(measured.value);
            QVERIFY(!m_sensor->coil(19)); // outside the measurement range (§5.2.5)
        }
    }
}

void ExamplesOnSensorTest::taughtWindowTellsTheStepsApart()
{
    QVERIFY(put(u"conveyor-step"_s));
    QVERIFY(write(ItemId::TeachingMode, 3));
    QVERIFY(!m_sensor->startTeaching(Operator::Communication).refusal);
    int point = 0;
    for (const QString& workpiece : {u"too low"_s, u"good"_s, u"too high"_s}) {
        hold(workpiece, 200);
        QVERIFY(!m_sensor->takeTeachingPoint(++point).refusal);
        after(200);
    }
    m_sensor->setScenery(m_scene);
    QList<Judgment> steps;
    after(300); // over the first step: 300 of the 1250 ms that a plate and its gap take
    for (int plate = 0; plate < 8; ++plate) {
        steps.append(m_sensor->measured().judgment);
        after(1250);
    }
    const auto go = Judgment::Go;
    QCOMPARE(steps, QList({go, go, Judgment::Low, go, go, go, Judgment::High, go}));
}

void ExamplesOnSensorTest::peakToPeakShowsTheKeywayOfTheShaft()
{
    QVERIFY(put(u"rotating-shaft"_s));
    after(100);
    QVERIFY(write(ItemId::HoldMode, 3)); // peak-to-peak
    const Measured measured = after(1000);
    QVERIFY(measured.value);
    // From the high side at +0.1 down to the keyway's edge at 80°, a little above its floor at −0.4.
    const double share = double(*measured.value) / (5.0 * mm);
    QVERIFY2(share > 0.49 && share < 0.53, QByteArray::number(share));
}

void ExamplesOnSensorTest::brightnessAdjustsAtEveryEdgeBetweenRubberAndSteel()
{
    QVERIFY(put(u"rubber-and-steel"_s));
    after(500);
    for (int edge = 0; edge < 4; ++edge) { // each plate takes a second
        QVERIFY(!m_sensor->measured().alarm);
        QVERIFY(after(400).value);
        int alarms = 0;
        int lastAlarm = 0;
        for (int i = 0; i < 200; ++i) {
            if (after(1).alarm) {
                ++alarms;
                lastAlarm = i;
            }
        }
        QVERIFY2(alarms > 3, QByteArray::number(alarms)); // too bright, or too dark, at first
        QVERIFY2(lastAlarm < 150, QByteArray::number(lastAlarm));
        after(400);
    }
}

void ExamplesOnSensorTest::tunedBrightnessTakesTheEdgesAtOnce()
{
    QVERIFY(put(u"rubber-and-steel"_s));
    QVERIFY(!m_sensor->startTuning(Operator::Communication).refusal);
    int point = 0;
    for (const QString& workpiece : {u"steel"_s, u"black rubber"_s}) {
        hold(workpiece, 500);
        QVERIFY(!m_sensor->takeTuningPoint(++point).refusal);
        after(2000);
    }
    QVERIFY(write(ItemId::AverageTimes, 0));
    m_sensor->setScenery(m_scene);
    after(100);
    int alarms = 0;
    for (int i = 0; i < 4000; ++i)
        alarms += after(1).alarm;
    QVERIFY2(alarms < 10, QByteArray::number(alarms));
}

void ExamplesOnSensorTest::emptyPlacesRaiseTheAlarm()
{
    QVERIFY(put(u"missing-parts"_s));
    QVERIFY(!after(400).alarm); // 40 mm of part at 50 mm/s, then 20 mm without
    QVERIFY(m_sensor->measured().value);
    QVERIFY(after(600).alarm);
    QVERIFY(!after(600).alarm); // the second part
    for (int i = 0; i < 20; ++i)
        QVERIFY(after(50).alarm == (i >= 8)); // and the empty place behind it, from 2000 ms on
}

QTEST_GUILESS_MAIN(ExamplesOnSensorTest)
#include "tst_examples_on_sensor.moc"
