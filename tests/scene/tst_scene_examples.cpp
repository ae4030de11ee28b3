#include "scene_fixture.h"

#include <algorithm>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;
using lds::catalog::Catalog;

namespace {

constexpr qint64 longEnough = 20'000 * ms; ///< Every example shows all it has in less.

std::shared_ptr<const Scene> example(const QString& key,
                                     lds::catalog::SensorModel model = lds::catalog::SensorModel::HlG203)
{
    const auto scene = Scene::load(key, model);
    if (!scene)
        qWarning("%s", qPrintable(scene.error()));
    return scene.value_or(nullptr);
}

/// What a scene shows in its first seconds.
struct Seen {
    Nanometres lowest = 0;
    Nanometres highest = 0;
    double dimmest = 100;
    double brightest = 0;
    int present = 0;
    int absent = 0;
};

Seen lookAt(const Scenery& scenery)
{
    Seen seen{1'000'000 * mm, -1'000'000 * mm};
    for (qint64 timeNs = 0; timeNs < longEnough; timeNs += ms) {
        const Sight sight = scenery.at(timeNs);
        if (!sight.present) {
            ++seen.absent;
            continue;
        }
        ++seen.present;
        seen.lowest = std::min(seen.lowest, sight.distance);
        seen.highest = std::max(seen.highest, sight.distance);
        seen.dimmest = std::min(seen.dimmest, sight.reflectance);
        seen.brightest = std::max(seen.brightest, sight.reflectance);
    }
    return seen;
}

/// A share of the measurement range of the type with ±5 mm, with room for the noise.
bool isAbout(Nanometres distance, double share)
{
    return std::abs(double(distance) - share * 5 * mm) < 0.001 * 5 * mm;
}

QString documentation()
{
    QFile file(qEnvironmentVariable("LDS_SOURCE") + u"/docs/scenes.md"_s); // ctest sets it
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void collectKeys(const QJsonValue& value, QSet<QString>& keys)
{
    if (value.isArray()) {
        for (const QJsonValue element : value.toArray())
            collectKeys(element, keys);
    }
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        keys.insert(it.key());
        collectKeys(it.value(), keys);
    }
}

} // namespace

class SceneExamplesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void thereAreFive();
    void everyOneSuitsEveryType_data();
    void everyOneSuitsEveryType();
    void everyWorkpieceCanBeTaught_data();
    void everyWorkpieceCanBeTaught();
    void conveyorStepHasThreeHeights();
    void rotatingShaftRunsOutOfTrue();
    void vibratingPlateSwingsTenTimesASecond();
    void rubberIsFarDarkerThanSteelAtTheSameMoment();
    void missingPartsLeaveNothingThere();
    void theDocumentedSceneIsOne();
    void everyFieldAndFaultIsDocumented();
};

void SceneExamplesTest::thereAreFive()
{
    QCOMPARE(Scene::examples(), QStringList({u"conveyor-step"_s, u"missing-parts"_s, u"rotating-shaft"_s,
                                             u"rubber-and-steel"_s, u"vibrating-plate"_s}));
    QCOMPARE(Scene::examples().size(), 5); // the same when asked again
}

void SceneExamplesTest::everyOneSuitsEveryType_data()
{
    QTest::addColumn<QString>("key");
    for (const QString& key : Scene::examples())
        QTest::newRow(qPrintable(key)) << key;
}

void SceneExamplesTest::everyOneSuitsEveryType()
{
    QFETCH(QString, key);
    for (const auto& model : Catalog::hlG2().models()) {
        const auto scene = example(key, model.model);
        QVERIFY(scene);
        QVERIFY(!scene->name().isEmpty() && !scene->description().isEmpty());
        QVERIFY(scene->faults().isEmpty()); // what goes wrong is switched by hand
        const Nanometres range = model.measurementRange * nanometresPerWireUnit;
        const Seen seen = lookAt(*scene);
        QVERIFY(seen.present > 0);
        QVERIFY(seen.lowest >= -range && seen.highest <= range);
        QVERIFY(seen.highest - seen.lowest > range / 10); // and something happens
        QVERIFY(seen.dimmest > 0);
    }
}

void SceneExamplesTest::everyWorkpieceCanBeTaught_data() { everyOneSuitsEveryType_data(); }

void SceneExamplesTest::everyWorkpieceCanBeTaught()
{
    QFETCH(QString, key);
    const auto scene = example(key);
    QVERIFY(scene);
    QVERIFY(!scene->workpieces().isEmpty());
    for (const QString& workpiece : scene->workpieces()) {
        const auto held = scene->holdingStill(workpiece);
        QVERIFY(held);
        const Seen seen = lookAt(*held);
        QCOMPARE(seen.absent, 0);
        QVERIFY(seen.lowest >= -5 * mm && seen.highest <= 5 * mm);
        QVERIFY(seen.highest - seen.lowest <= mm / 100); // nothing but the noise
        QCOMPARE(seen.dimmest, seen.brightest);
    }
}

void SceneExamplesTest::conveyorStepHasThreeHeights()
{
    const auto scene = example(u"conveyor-step"_s);
    QVERIFY(scene);
    QVERIFY(isAbout(scene->holdingStill(u"good"_s)->at(0).distance, 0.1));
    QVERIFY(isAbout(scene->holdingStill(u"too low"_s)->at(0).distance, -0.05));
    QVERIFY(isAbout(scene->holdingStill(u"too high"_s)->at(0).distance, 0.25));
    // A plate's base, its step, and the belt behind it: 60 mm and 40 mm at 80 mm/s.
    QVERIFY(isAbout(scene->at(100 * ms).distance, -0.3));
    QVERIFY(isAbout(scene->at(250 * ms).distance, 0.1));
    QVERIFY(isAbout(scene->at(499 * ms).distance, 0.1));
    QVERIFY(isAbout(scene->at(500 * ms).distance, -0.3));
    QVERIFY(isAbout(scene->at(750 * ms).distance, -0.7));
    QVERIFY(isAbout(scene->at(2 * 1250 * ms + 300 * ms).distance, -0.05)); // the third is too low
    QVERIFY(isAbout(scene->at(6 * 1250 * ms + 300 * ms).distance, 0.25));  // the seventh too high
    QVERIFY(isAbout(scene->at(7 * 1250 * ms + 300 * ms).distance, 0.1));
    QVERIFY(isAbout(scene->at(8 * 1250 * ms + 300 * ms).distance, 0.1));
    QCOMPARE(lookAt(*scene).absent, 0);
}

void SceneExamplesTest::rotatingShaftRunsOutOfTrue()
{
    const auto scene = example(u"rotating-shaft"_s);
    QVERIFY(scene);
    for (const qint64 turn : {qint64(0), 500 * ms, 500'000 * ms}) { // twice a second
        QVERIFY(isAbout(scene->at(turn).distance, 0.1));
        QVERIFY(isAbout(scene->at(turn + 250 * ms).distance, -0.1));
        QVERIFY(isAbout(scene->at(turn + 125 * ms).distance, -0.4)); // the keyway, at 90°
    }
    QVERIFY(isAbout(scene->holdingStill(u"high side"_s)->at(0).distance, 0.1));
    QVERIFY(isAbout(scene->holdingStill(u"low side"_s)->at(0).distance, -0.1));
    QVERIFY(isAbout(scene->holdingStill(u"keyway"_s)->at(0).distance, -0.4));
    QCOMPARE(lookAt(*scene).absent, 0);
}

void SceneExamplesTest::vibratingPlateSwingsTenTimesASecond()
{
    const auto scene = example(u"vibrating-plate"_s);
    QVERIFY(scene);
    for (int swing = 0; swing < 10; ++swing) {
        QVERIFY(isAbout(scene->at(swing * 100 * ms + 25 * ms).distance, 0.25));
        QVERIFY(isAbout(scene->at(swing * 100 * ms + 75 * ms).distance, -0.25));
    }
    QVERIFY(isAbout(scene->holdingStill(u"plate"_s)->at(25 * ms).distance, 0));
    QVERIFY(isAbout(scene->holdingStill(u"upper end"_s)->at(0).distance, 0.25));
    QVERIFY(isAbout(scene->holdingStill(u"lower end"_s)->at(0).distance, -0.25));
}

void SceneExamplesTest::rubberIsFarDarkerThanSteelAtTheSameMoment()
{
    const auto scene = example(u"rubber-and-steel"_s);
    QVERIFY(scene);
    QCOMPARE(scene->holdingStill(u"steel"_s)->at(0).reflectance, 5.0);
    QCOMPARE(scene->holdingStill(u"black rubber"_s)->at(0).reflectance, 0.02);
    QCOMPARE(scene->at(1000 * ms - 1).reflectance, 5.0); // 60 mm at 60 mm/s, without a gap
    QCOMPARE(scene->at(1000 * ms).reflectance, 0.02);
    QCOMPARE(scene->at(2000 * ms).reflectance, 5.0);
    QCOMPARE(lookAt(*scene).absent, 0);
}

void SceneExamplesTest::missingPartsLeaveNothingThere()
{
    const auto scene = example(u"missing-parts"_s);
    QVERIFY(scene);
    QVERIFY(scene->at(400 * ms).present);
    QVERIFY(scene->at(1600 * ms).present);
    for (qint64 timeNs = 2400 * ms; timeNs < 3600 * ms; timeNs += ms) // the third place, 60 mm at 50 mm/s
        QVERIFY(!scene->at(timeNs).present);
    QVERIFY(scene->at(3600 * ms).present);
    const Seen seen = lookAt(*scene);
    QVERIFY(seen.absent > 0);
    QVERIFY(seen.present > 0);
}

void SceneExamplesTest::theDocumentedSceneIsOne()
{
    const QString text = documentation();
    const qsizetype begin = text.indexOf("```json\n"_L1) + 8;
    QVERIFY(begin > 8);
    const QByteArray json = text.mid(begin, text.indexOf("```"_L1, begin) - begin).toUtf8();
    for (const auto& model : Catalog::hlG2().models()) {
        const auto scene = sceneOf(json, model.model);
        QVERIFY(scene);
        QCOMPARE(scene->holdingStill(u"without cap"_s)->at(0).distance / 10'000, -mm / 10'000);
    }
}

void SceneExamplesTest::everyFieldAndFaultIsDocumented()
{
    const QString text = documentation();
    QSet<QString> words;
    collectKeys(QJsonDocument::fromJson(fullScene()).object(), words);
    for (const QString& key : Scene::examples()) {
        words.insert(key);
        QFile file(u":/lds/scenes/%1.json"_s.arg(key));
        QVERIFY(file.open(QIODevice::ReadOnly));
        collectKeys(QJsonDocument::fromJson(file.readAll()).object(), words);
    }
    for (const NamedFault fault : allFaults())
        words.insert(keyOf(fault));
    QVERIFY(words.size() > 30);
    for (const QString& word : std::as_const(words))
        QVERIFY2(text.contains(u'`' + word + u'`'), qPrintable(word));
}

QTEST_GUILESS_MAIN(SceneExamplesTest)
#include "tst_scene_examples.moc"
