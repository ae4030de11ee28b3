#include "scene_fixture.h"

#include <cmath>
#include <limits>
#include <QRandomGenerator>
#include <QRegularExpression>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;
using lds::catalog::SensorModel;

namespace {

constexpr int mutationsEach = 800;
constexpr Nanometres farthest = 20'000 * mm; ///< Every height, swing and noise at its limit.

/// Numbers and texts that programs stumble over.
const QByteArrayList nastyValues{
    "0",           "-0",   "-1", "1e308", "-1e308", "1e-308",   "1e999", "9223372036854775807", "1.5",
    "null",        "true", "[]", "{}",    "\"\"",   "\"part\"", "NaN",   "[[0,0],[0,0],[0,0]]", "0.0000001",
    "31536000000", "1e15"};

QByteArray fileOf(const QString& key)
{
    QFile file(u":/lds/scenes/%1.json"_s.arg(key));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Every scene there is to start from: one for each kind of motion, and one with every other field.
QByteArrayList originals()
{
    QByteArrayList list{fullScene()};
    for (const QString& key : Scene::examples())
        list.append(fileOf(key));
    list.append(sceneJson(R"({"name": "part", "height": 1}, {"name": "other", "height": 2})",
                          R"({"kind": "timeline", "places": [{"workpiece": "part", "atMs": 0},
                              {"workpiece": "other", "atMs": 100}, {"workpiece": null, "atMs": 200}],
                              "repeatMs": 300, "background": {"height": -1}})"));
    list.append(sceneJson(R"({"name": "part", "height": 1})", R"({"kind": "still", "workpiece": "part"})"));
    return list;
}

QByteArray withAnotherValue(const QByteArray& json, QRandomGenerator& random)
{
    static const QRegularExpression value(u"-?[0-9][0-9.]*|\"[^\"]*\"|null"_s);
    QList<QRegularExpressionMatch> found;
    const QString text = QString::fromUtf8(json);
    for (auto it = value.globalMatch(text); it.hasNext();)
        found.append(it.next());
    if (found.isEmpty())
        return json;
    const auto& match = found.at(random.bounded(int(found.size())));
    bool isNumber = false;
    const double number = match.captured().toDouble(&isNumber);
    QByteArray by = nastyValues.at(random.bounded(int(nastyValues.size())));
    if (isNumber && random.bounded(4) > 0)
        by = QByteArray::number(number * random.bounded(2.0));
    else if (random.bounded(2) == 0)
        by = found.at(random.bounded(int(found.size()))).captured().toUtf8();
    return text.left(match.capturedStart()).toUtf8() + by + text.mid(match.capturedEnd()).toUtf8();
}

QByteArray mutated(QByteArray json, QRandomGenerator& random)
{
    const int times = random.bounded(3) == 0 ? random.bounded(2, 5) : 1;
    for (int i = 0; i < times; ++i) {
        const int size = int(json.size());
        if (size < 2)
            return json;
        const int at = random.bounded(size);
        const int length = random.bounded(1, std::min(60, size - at) + 1);
        switch (random.bounded(12)) {
        case 0:
            json[at] = char(random.bounded(256));
            break;
        case 1:
            json.remove(at, length);
            break;
        case 2:
            json.insert(random.bounded(size), json.mid(at, length));
            break;
        case 3:
            json.truncate(at);
            break;
        default: // the kind that often stays a scene
            json = withAnotherValue(json, random);
            break;
        }
    }
    return json;
}

bool isSane(const Sight& sight)
{
    return sight.distance >= -farthest && sight.distance <= farthest && sight.reflectance >= 0 &&
           sight.reflectance <= 100 && sight.ambientLight >= 0 && sight.ambientLight <= 100;
}

/// Whether a scene answers with sane numbers at any moment.
bool answersSanely(const Scenery& scenery)
{
    bool sane = isSane(scenery.at(0)) && isSane(scenery.at(std::numeric_limits<qint64>::max()));
    for (qint64 timeNs = 1; sane && timeNs < 100'000'000'000'000; timeNs = timeNs * 7 / 4 + 1)
        sane = isSane(scenery.at(timeNs));
    return sane;
}

bool hasSaneTimes(const Scene& scene)
{
    const auto sane = [](const Interval& interval) {
        interval.covers(std::numeric_limits<qint64>::max());
        return interval.atMs >= 0 && interval.forMs >= 0 &&
               (interval.everyMs == 0 || interval.everyMs > interval.forMs);
    };
    for (const ScheduledFault& fault : scene.faults()) {
        if (!sane(fault.when) || fault.milliseconds < 0 || fault.milliseconds > 60'000)
            return false;
    }
    return std::all_of(scene.triggers().begin(), scene.triggers().end(), sane);
}

/// A sentence for a person: something, short enough, on one line.
bool isSentence(const QString& error)
{
    return !error.isEmpty() && error.size() < 2000 && !error.contains(u'\n') && !error.contains(QChar(27));
}

} // namespace

class SceneHostileInputTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mutatedScenesAreRefusedOrAnswerSanely();
    void everyBeginningOfASceneIsRefused();
    void deepNestingIsRefused();
};

void SceneHostileInputTest::mutatedScenesAreRefusedOrAnswerSanely()
{
    QRandomGenerator random(20260301);
    int taken = 0;
    int refused = 0;
    for (const QByteArray& original : originals()) {
        QVERIFY(Scene::fromJson(original, SensorModel::HlG225));
        for (int i = 0; i < mutationsEach; ++i) {
            const QByteArray json = mutated(original, random);
            const auto scene = Scene::fromJson(json, SensorModel::HlG225);
            if (!scene) {
                ++refused;
                QVERIFY2(isSentence(scene.error()), json);
                continue;
            }
            ++taken;
            QVERIFY2(answersSanely(**scene), json);
            QVERIFY2(hasSaneTimes(**scene), json);
            for (const QString& workpiece : (*scene)->workpieces()) {
                const auto held = (*scene)->holdingStill(workpiece);
                QVERIFY2(held && answersSanely(*held), json);
            }
        }
    }
    qInfo("%d taken, %d refused", taken, refused);
    QVERIFY(taken > 500); // otherwise this has tested the parser only
    QVERIFY(refused > 500);
}

void SceneHostileInputTest::everyBeginningOfASceneIsRefused()
{
    const QByteArray whole = fullScene();
    for (qsizetype size = 0; size < whole.size(); ++size)
        QVERIFY2(isSentence(errorOf(whole.left(size))), whole.left(size));
}

void SceneHostileInputTest::deepNestingIsRefused()
{
    for (const QByteArray& opening : {"["_ba, "{\"a\":"_ba, "{\"workpieces\":["_ba}) {
        const QString error = errorOf(opening.repeated(50'000));
        QVERIFY2(error.startsWith("is not JSON: "_L1), qPrintable(error));
    }
}

QTEST_GUILESS_MAIN(SceneHostileInputTest)
#include "tst_scene_hostile_input.moc"
