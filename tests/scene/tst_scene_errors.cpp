#include "scene_fixture.h"

#include <QTemporaryDir>

using namespace lds::emulator;
using namespace lds::emulator::test;
using namespace Qt::StringLiterals;

namespace {

const QByteArray part = R"({"name": "part", "height": 0.5, "length": 10})";
const QByteArray still = R"({"kind": "still", "workpiece": "part"})";

/// A row for a full scene in which one text has been put in another's place.
void replaced(const char* name, const QByteArray& what, const QByteArray& by, const QString& error)
{
    const QByteArray whole = fullScene();
    QCOMPARE(whole.count(what), 1); // otherwise the row tests something else
    QByteArray changed = whole;
    changed.replace(what, by);
    QTest::newRow(name) << changed << error;
}

void scene(const char* name, const QByteArray& workpieces, const QByteArray& motion, const QByteArray& rest,
           const QString& error)
{
    QTest::newRow(name) << sceneJson(workpieces, motion, rest) << error;
}

void addColumns()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("error");
}

QByteArray listOf(const QByteArray& element, int count)
{
    QByteArray list;
    for (int i = 0; i < count; ++i)
        list += (i > 0 ? "," : "") + element;
    return '[' + list + ']';
}

} // namespace

class SceneErrorsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void takesEveryFieldThereIs();
    void namesLineAndColumnOfWhatIsNoJson_data();
    void namesLineAndColumnOfWhatIsNoJson();
    void namesTheFieldOfTheFile_data();
    void namesTheFieldOfTheFile();
    void namesTheFieldOfAWorkpiece_data();
    void namesTheFieldOfAWorkpiece();
    void namesTheFieldOfTheMotion_data();
    void namesTheFieldOfTheMotion();
    void namesTheFieldOfATime_data();
    void namesTheFieldOfATime();
    void boundsHowMuchThereIs_data();
    void boundsHowMuchThereIs();
    void takesAsMuchAsTheBoundsAllow();
    void namesTheFile();
    void listsTheExamplesForAnUnknownFile();
    void refusesAFileThatIsTooLarge();
    void refusesWhatIsNoFile();
    void readsAFile();

private:
    void refuses();
};

void SceneErrorsTest::refuses()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, error);
    QCOMPARE(errorOf(json), error);
}

void SceneErrorsTest::takesEveryFieldThereIs() { QCOMPARE(errorOf(fullScene()), QString()); }

void SceneErrorsTest::namesLineAndColumnOfWhatIsNoJson_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("place");
    QTest::newRow("empty") << QByteArray() << u"line 1, column 1"_s;
    QTest::newRow("a word") << "hello"_ba << u"line 1, column 1"_s;
    QTest::newRow("no colon") << "{\n  \"format\" \"lds-scene\"\n}"_ba << u"line 2, column 12"_s;
    QTest::newRow("no comma") << "{\n\"a\": 1\n\"b\": 2}"_ba << u"line 3, column 1"_s;
    QTest::newRow("umlauts before") << QByteArray("{\n\"ä\": \"öü\" 1}") << u"line 2, column 11"_s;
    QTest::newRow("infinite") << "{\"a\": 1e999}"_ba << u"line 1, column 11"_s;
    QTest::newRow("not a number") << "{\n\n\"a\": NaN}"_ba << u"line 3, column 5"_s;
    QTest::newRow("no end") << "{\"a\": [1, 2"_ba << u"line 1, column 11"_s;
    QTest::newRow("something behind") << "{\n}\nx"_ba << u"line 3, column 1"_s;
    QTest::newRow("a comma too many") << "{\"a\": 1,}"_ba << u"line 1, column 9"_s;
    QTest::newRow("not UTF-8") << "{\"a\":\n \"\xff\xfe\"}"_ba << u"line 2, column 2"_s;
}

void SceneErrorsTest::namesLineAndColumnOfWhatIsNoJson()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, place);
    const QString error = errorOf(json);
    QVERIFY2(error.startsWith("is not JSON: "_L1), qPrintable(error));
    QVERIFY2(error.endsWith(u" at "_s + place), qPrintable(error));
}

void SceneErrorsTest::namesTheFieldOfTheFile_data()
{
    addColumns();
    QTest::newRow("a list") << "[]"_ba << u"has to be an object, {…}"_s;
    QTest::newRow("nothing in it") << "{}"_ba << u"format: is missing"_s;
    replaced("another format", "\"lds-scene\"", "\"sensors\"", u"format: has to be \"lds-scene\""_s);
    replaced("another version", "\"version\": 1,", "\"version\": 2,",
             u"version: has to be 1, the only one this program knows"_s);
    replaced("version as a text", "\"version\": 1,", "\"version\": \"1\",",
             u"version: has to be 1, the only one this program knows"_s);
    replaced("no name", "\"name\": \"Everything\",", "", u"name: is missing"_s);
    replaced("empty name", "\"Everything\"", "\"\"", u"name: has to have from 1 to 100 characters"_s);
    replaced("name as a number", "\"Everything\"", "12", u"name: has to be a text"_s);
    replaced("name too long", "Everything", QByteArray(101, 'x'),
             u"name: has to have from 1 to 100 characters"_s);
    replaced("description too long", "Every field of", QByteArray(2001, 'x'),
             u"description: has to have from 1 to 2000 characters"_s);
    replaced("another unit", "\"mm\"", "\"inch\"", u"unit: has to be \"mm\" or \"range\""_s);
    replaced("unknown field", "\"seed\"", "\"sead\"",
             u"sead: is no field here; these are: format, version, name, description, unit, workpieces, "
             "motion, noise, seed, ambientLight, faults, triggers"_s);
    replaced("unknown field with a long name", "\"seed\": 7", '"' + QByteArray(500, 'z') + "\": 7",
             QString(40, u'z') +
                 u"…: is no field here; these are: format, version, name, description, unit, workpieces, "
                 "motion, noise, seed, ambientLight, faults, triggers"_s);
    replaced("negative noise", "0.001", "-0.001",
             u"noise: -0.001 is out of range: it has to be from 0 to 1000 mm"_s);
    replaced("seed with a fraction", "\"seed\": 7", "\"seed\": 7.5", u"seed: 7.5 has to be a whole number"_s);
    replaced("seed negative", "\"seed\": 7", "\"seed\": -1",
             u"seed: -1 is out of range: it has to be from 0 to 9007199254740992"_s);
    scene("light negative", part, still, R"(, "ambientLight": -0.5)",
          u"ambientLight: -0.5 is out of range: it has to be from 0 to 100"_s);
    scene("light as a text", part, still, R"(, "ambientLight": "bright")",
          u"ambientLight: has to be a number"_s);
    scene("light without intervals", part, still, R"(, "ambientLight": {"level": 1})",
          u"ambientLight.intervals: is missing"_s);
    QTest::newRow("no workpieces") << sceneJson("", still)
                                   << u"workpieces: has to have at least one element"_s;
    QTest::newRow("no motion")
        << R"({"format": "lds-scene", "version": 1, "name": "n", "description": "d", "workpieces": [)" +
               part + "]}"
        << u"motion: is missing"_s;
}

void SceneErrorsTest::namesTheFieldOfTheFile() { refuses(); }

void SceneErrorsTest::namesTheFieldOfAWorkpiece_data()
{
    addColumns();
    replaced("unknown field", "\"measuringPoint\": 7", "\"measuringpoint\": 7",
             u"workpieces[1].measuringpoint: is no field here; these are: name, profile, height, "
             "reflectance, length, measuringPoint"_s);
    replaced("not an object", R"({ "name": "flat", "height": 0.5, "length": 10, "reflectance": 0.9 })", "5",
             u"workpieces[0]: has to be an object, {…}"_s);
    replaced("no name", "\"name\": \"flat\", ", "", u"workpieces[0].name: is missing"_s);
    replaced("the same name", "\"name\": \"stepped\"", "\"name\": \"flat\"",
             u"workpieces[1].name: workpieces[0] is called \"flat\" too"_s);
    replaced("a space after the name", "\"name\": \"flat\"", "\"name\": \"flat \"",
             u"workpieces[0].name: must not begin or end with a space, nor hold a character that cannot be "
             "printed"_s);
    replaced("an escape character in the name", "\"name\": \"flat\"", "\"name\": \"fl\\u001b[2Jat\"",
             u"workpieces[0].name: must not begin or end with a space, nor hold a character that cannot be "
             "printed"_s);
    replaced("neither height nor profile", "\"height\": 0.5, ", "",
             u"workpieces[0].height: is missing: give either height or profile"_s);
    replaced("height and profile", "\"height\": 0.5", "\"height\": 0.5, \"profile\": [[0, 0]]",
             u"workpieces[0].height: cannot be given together with profile"_s);
    replaced("height as a text", "\"height\": 0.5", "\"height\": \"0.5\"",
             u"workpieces[0].height: has to be a number"_s);
    replaced("height too large", "\"height\": 0.5", "\"height\": 1001",
             u"workpieces[0].height: 1001 is out of range: it has to be from -1000 to 1000 mm"_s);
    replaced("height enormous", "\"height\": 0.5", "\"height\": -1e308",
             u"workpieces[0].height: -1e+308 is out of range: it has to be from -1000 to 1000 mm"_s);
    scene("height in ranges too large", R"({"name": "part", "height": 10.5})", still, R"(, "unit": "range")",
          u"workpieces[0].height: 10.5 is out of range: it has to be from -10 to 10 measurement ranges"_s);
    replaced("negative length", "\"length\": 12", "\"length\": -12",
             u"workpieces[1].length: -12 is out of range: it has to be from 0.001 to 10000 mm"_s);
    replaced("length before the last point", "\"length\": 12", "\"length\": 9",
             u"workpieces[1].length: 9 mm ends before the last point, at 10 mm"_s);
    replaced("measuring point outside", "\"measuringPoint\": 7", "\"measuringPoint\": 13",
             u"workpieces[1].measuringPoint: 13 is out of range: it has to be from 0 to 12 mm"_s);
    replaced("profile no list", "[[0, 0], [5, 0], [5, 0.2], [10, 0.2]]", "{}",
             u"workpieces[1].profile: has to be a list, […]"_s);
    replaced("profile empty", "[[0, 0], [5, 0], [5, 0.2], [10, 0.2]]", "[]",
             u"workpieces[1].profile: has to have at least one element"_s);
    replaced("point as a number", "[5, 0.2]", "5",
             u"workpieces[1].profile[2]: has to be a point, [position, value]"_s);
    replaced("point of three", "[5, 0.2]", "[5, 0.2, 1]",
             u"workpieces[1].profile[2]: has to be a point, [position, value]"_s);
    replaced("point's position as a text", "[5, 0.2]", "[\"5\", 0.2]",
             u"workpieces[1].profile[2][0]: has to be a number"_s);
    replaced("point's position negative", "[[0, 0], [5, 0]", "[[-1, 0], [5, 0]",
             u"workpieces[1].profile[0][0]: -1 is out of range: it has to be from 0 to 10000 mm"_s);
    replaced("point's height too large", "[5, 0.2]", "[5, 2000]",
             u"workpieces[1].profile[2][1]: 2000 is out of range: it has to be from -1000 to 1000 mm"_s);
    replaced("profile unsorted", "[5, 0.2]", "[4.5, 0.2]",
             u"workpieces[1].profile[2]: position 4.5 comes after 5: positions have to ascend"_s);
    replaced("three points at one place", "[10, 0.2]", "[5, 0.3]",
             u"workpieces[1].profile[3]: is the third point at position 5; a step has two"_s);
    replaced("reflectance negative", "\"reflectance\": 0.9", "\"reflectance\": -0.9",
             u"workpieces[0].reflectance: -0.9 is out of range: it has to be from 0 to 100"_s);
    replaced("reflectance unsorted", "[5, 0.1]", "[1, 0.1]",
             u"workpieces[1].reflectance[2]: position 1 comes after 5: positions have to ascend"_s);
    replaced("reflectance too large at a point", "[5, 0.1]", "[5, 101]",
             u"workpieces[1].reflectance[2][1]: 101 is out of range: it has to be from 0 to 100"_s);
    const QByteArray shaft = R"({"kind": "shaft", "workpiece": "part", "revolutionsPerSecond": 1})";
    scene("length on a shaft", part, shaft, "",
          u"workpieces[0].length: does not apply to a shaft, which is 360° around"_s);
    scene("angle too large", R"({"name": "part", "profile": [[0, 0], [361, 0]]})", shaft, "",
          u"workpieces[0].profile[1][0]: 361 is out of range: it has to be from 0 to 360°"_s);
}

void SceneErrorsTest::namesTheFieldOfAWorkpiece() { refuses(); }

void SceneErrorsTest::namesTheFieldOfTheMotion_data()
{
    addColumns();
    scene("no object", part, "7", "", u"motion: has to be an object, {…}"_s);
    scene("no kind", part, "{}", "", u"motion.kind: is missing"_s);
    scene("unknown kind", part, R"({"kind": "rocket"})", "",
          u"motion.kind: \"rocket\" is no motion; it has to be \"conveyor\", \"shaft\", \"plate\", \"still\" "
          "or \"timeline\""_s);
    scene("field of another kind", part, R"({"kind": "still", "workpiece": "part", "speed": 1})", "",
          u"motion.speed: is no field here; these are: kind, workpiece"_s);
    scene("unknown workpiece", part, R"({"kind": "still", "workpiece": "Part"})", "",
          u"motion.workpiece: \"Part\" is none of the workpieces; these are: \"part\""_s);
    scene("no workpiece", part, R"({"kind": "still"})", "", u"motion.workpiece: is missing"_s);
    scene("null for a workpiece", part, R"({"kind": "still", "workpiece": null})", "",
          u"motion.workpiece: has to be the name of a workpiece"_s);
    replaced("no speed", "\"speed\": 100,", "", u"motion.speed: is missing"_s);
    replaced("speed zero", "\"speed\": 100", "\"speed\": 0",
             u"motion.speed: 0 is out of range: it has to be from 0.01 to 10000 mm/s"_s);
    replaced("speed negative", "\"speed\": 100", "\"speed\": -100",
             u"motion.speed: -100 is out of range: it has to be from 0.01 to 10000 mm/s"_s);
    replaced("no order", "\"order\": [\"flat\", \"stepped\", null],", "", u"motion.order: is missing"_s);
    replaced("order empty", "[\"flat\", \"stepped\", null]", "[]",
             u"motion.order: has to have at least one element"_s);
    replaced("order of numbers", "\"stepped\", null]", "3, null]",
             u"motion.order[1]: has to be the name of a workpiece, or null for none"_s);
    replaced("unknown workpiece in the order", "\"stepped\", null]", "\"steped\", null]",
             u"motion.order[1]: \"steped\" is none of the workpieces; these are: \"flat\", \"stepped\""_s);
    replaced("pitch and gap", "\"pitch\": 20,", "\"pitch\": 20, \"gap\": 3,",
             u"motion.gap: cannot be given together with pitch"_s);
    replaced("pitch too short", "\"pitch\": 20,", "\"pitch\": 11,",
             u"motion.order[1]: \"stepped\" is 12 mm long, which is more than the pitch of 11 mm"_s);
    replaced("empty place without a pitch", "\"pitch\": 20,", "\"gap\": 20,",
             u"motion.order[2]: an empty place needs the field pitch, which says how long it is"_s);
    replaced("background without height", "\"height\": -1, ", "", u"motion.background.height: is missing"_s);
    replaced("unknown field of the background", "\"height\": -1, ", "\"height\": -1, \"colour\": 1, ",
             u"motion.background.colour: is no field here; these are: height, reflectance"_s);
    scene("workpiece without length on a conveyor", R"({"name": "part", "height": 0})",
          R"({"kind": "conveyor", "speed": 1, "order": ["part"]})", "",
          u"workpieces[0].length: is missing: on a conveyor a workpiece has a length, or a profile"_s);
    scene("shaft not turning", R"({"name": "part", "height": 0})",
          R"({"kind": "shaft", "workpiece": "part", "revolutionsPerSecond": 0})", "",
          u"motion.revolutionsPerSecond: 0 is out of range: it has to be from 0.001 to 1000 revolutions per "
          "second"_s);
    scene("eccentricity negative", R"({"name": "part", "height": 0})",
          R"({"kind": "shaft", "workpiece": "part", "revolutionsPerSecond": 1, "eccentricity": -1})", "",
          u"motion.eccentricity: -1 is out of range: it has to be from 0 to 1000 mm"_s);
    scene("plate too quick", part,
          R"({"kind": "plate", "workpiece": "part", "amplitude": 1, "frequency": 5001})", "",
          u"motion.frequency: 5001 is out of range: it has to be from 0.001 to 5000 Hz"_s);
    scene("plate without amplitude", part, R"({"kind": "plate", "workpiece": "part", "frequency": 5})", "",
          u"motion.amplitude: is missing"_s);
    scene("timeline without places", part, R"({"kind": "timeline"})", "", u"motion.places: is missing"_s);
    scene("place without time", part, R"({"kind": "timeline", "places": [{"workpiece": "part"}]})", "",
          u"motion.places[0].atMs: is missing"_s);
    scene("place without workpiece", part, R"({"kind": "timeline", "places": [{"atMs": 0}]})", "",
          u"motion.places[0].workpiece: is missing"_s);
    scene(
        "places unsorted", part,
        R"({"kind": "timeline", "places": [{"workpiece": "part", "atMs": 5}, {"workpiece": null, "atMs": 5}]})",
        "", u"motion.places[1].atMs: 5 has to come after the place before, at 5"_s);
    scene("unknown workpiece in a place", part,
          R"({"kind": "timeline", "places": [{"workpiece": "x\u0007y", "atMs": 5}]})", "",
          u"motion.places[0].workpiece: \"x?y\" is none of the workpieces; these are: \"part\""_s);
    scene("repeat too early", part,
          R"({"kind": "timeline", "repeatMs": 5, "places": [{"workpiece": "part", "atMs": 5}]})", "",
          u"motion.repeatMs: 5 has to come after the last place, at 5"_s);
}

void SceneErrorsTest::namesTheFieldOfTheMotion() { refuses(); }

void SceneErrorsTest::namesTheFieldOfATime_data()
{
    addColumns();
    replaced("unknown fault", "\"noLight\"", "\"noLihgt\"",
             u"faults[0].fault: \"noLihgt\" is no fault; these are: noLight, saturated, ambientLight, "
             "outOfRange, laserCircuitError, systemError, slowAnswers, answersLost, answersCut, "
             "connectionDropped, inMenu, saving"_s);
    replaced("fault without time", "\"atMs\": 2000, ", "", u"faults[1].atMs: is missing"_s);
    replaced("time negative", "\"atMs\": 2000", "\"atMs\": -1",
             u"faults[1].atMs: -1 is out of range: it has to be from 0 to 31536000000 ms"_s);
    replaced("time with a fraction", "\"atMs\": 2000", "\"atMs\": 0.5",
             u"faults[1].atMs: 0.5 has to be a whole number"_s);
    replaced("time enormous", "\"atMs\": 2000", "\"atMs\": 1e300",
             u"faults[1].atMs: 1e+300 is out of range: it has to be from 0 to 31536000000 ms"_s);
    replaced("again without an end", "\"forMs\": 200, ", "",
             u"faults[0].forMs: is missing: what comes every 5000 ms has to end"_s);
    replaced("again before the end", "\"everyMs\": 5000", "\"everyMs\": 200",
             u"faults[0].everyMs: 200 has to be more than forMs, 200"_s);
    replaced("milliseconds of a fault without", "\"everyMs\": 5000", "\"everyMs\": 5000, \"milliseconds\": 5",
             u"faults[0].milliseconds: does not apply to noLight"_s);
    replaced("milliseconds too many", "\"milliseconds\": 150", "\"milliseconds\": 60001",
             u"faults[1].milliseconds: 60001 is out of range: it has to be from 1 to 60000 ms"_s);
    replaced("duration of saving", "\"atMs\": 3000", "\"atMs\": 3000, \"forMs\": 5",
             u"faults[2].forMs: does not apply to what lasts its milliseconds"_s);
    replaced("saving again before its end", "\"everyMs\": 10000", "\"everyMs\": 2500",
             u"faults[2].everyMs: 2500 has to be more than milliseconds, 2500"_s);
    replaced("unknown field of a fault", "\"atMs\": 2000", "\"at\": 2000", u"faults[1].atMs: is missing"_s);
    replaced("field too many in a fault", "\"atMs\": 2000", "\"atMs\": 2000, \"at\": 2",
             u"faults[1].at: is no field here; these are: fault, milliseconds, atMs, forMs, everyMs"_s);
    replaced("trigger no object", R"([{ "atMs": 100, "forMs": 50, "everyMs": 200 }])", "[true]",
             u"triggers[0]: has to be an object, {…}"_s);
    replaced("trigger again before the end", "\"everyMs\": 200 }", "\"everyMs\": 20 }",
             u"triggers[0].everyMs: 20 has to be more than forMs, 50"_s);
    replaced("light without level", "\"level\": 2, ", "", u"ambientLight.intervals[0].level: is missing"_s);
    replaced("light with a wrong time", "\"atMs\": 500", "\"atMs\": []",
             u"ambientLight.intervals[0].atMs: has to be a number"_s);
}

void SceneErrorsTest::namesTheFieldOfATime() { refuses(); }

void SceneErrorsTest::boundsHowMuchThereIs_data()
{
    addColumns();
    QTest::newRow("workpieces") << sceneJson(QByteArray(part + ',').repeated(100) + part, still)
                                << u"workpieces: has 101 elements; at most 100 are possible"_s;
    scene("points", R"({"name": "part", "profile": )" + listOf("[0, 0]", 1001) + '}', still, "",
          u"workpieces[0].profile: has 1001 elements; at most 1000 are possible"_s);
    scene("places", part, R"({"kind": "conveyor", "speed": 1, "order": )" + listOf("\"part\"", 1001) + '}',
          "", u"motion.order: has 1001 elements; at most 1000 are possible"_s);
    scene("times", part, R"({"kind": "timeline", "places": )" + listOf("{}", 1001) + '}', "",
          u"motion.places: has 1001 elements; at most 1000 are possible"_s);
    scene("faults", part, still, ", \"faults\": " + listOf("{}", 101),
          u"faults: has 101 elements; at most 100 are possible"_s);
    scene("triggers", part, still, ", \"triggers\": " + listOf("{}", 101),
          u"triggers: has 101 elements; at most 100 are possible"_s);
    scene("lights", part, still, ", \"ambientLight\": {\"intervals\": " + listOf("{}", 17) + '}',
          u"ambientLight.intervals: has 17 elements; at most 16 are possible"_s);

    QByteArray points;
    for (int i = 0; i < 200; ++i)
        points += (i > 0 ? ",[" : "[") + QByteArray::number(i) + ",0]";
    scene("points of all places", R"({"name": "part", "profile": [)" + points + "]}",
          R"({"kind": "conveyor", "speed": 1, "order": )" + listOf("\"part\"", 1000) + '}', "",
          u"motion.order: the profiles of all its places have 201000 points; at most 100000 are possible"_s);
    QTest::newRow("bytes") << sceneJson(part, still, QByteArray(1024 * 1024, ' '))
                           << u"is larger than 1048576 bytes"_s;
}

void SceneErrorsTest::boundsHowMuchThereIs() { refuses(); }

void SceneErrorsTest::takesAsMuchAsTheBoundsAllow()
{
    QByteArray points;
    for (int i = 0; i < 99; ++i)
        points += (i > 0 ? ",[" : "[") + QByteArray::number(i) + ",0]";
    QCOMPARE(errorOf(sceneJson(R"({"name": "part", "profile": [)" + points + "]}",
                               R"({"kind": "conveyor", "speed": 0.01, "gap": 10000, "order": )" +
                                   listOf("\"part\"", 1000) + '}')),
             QString());
}

void SceneErrorsTest::namesTheFile()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"broken.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\n\"format\": }");
    file.close();
    const auto scene = Scene::load(path, lds::catalog::SensorModel::HlG203);
    QVERIFY(!scene);
    QVERIFY2(scene.error().startsWith(path + u": is not JSON: "_s), qPrintable(scene.error()));
    QVERIFY2(scene.error().contains("line 2, column 11"_L1), qPrintable(scene.error()));
}

void SceneErrorsTest::listsTheExamplesForAnUnknownFile()
{
    const auto scene = Scene::load(u"conveyor"_s, lds::catalog::SensorModel::HlG203);
    QVERIFY(!scene);
    QCOMPARE(scene.error(),
             u"conveyor: there is no such file, and no example of that name; the examples are: "
             "conveyor-step, missing-parts, rotating-shaft, rubber-and-steel, vibrating-plate"_s);
}

void SceneErrorsTest::refusesAFileThatIsTooLarge()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"large.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.resize(1LL << 40)); // sparse: only its size is large
    file.close();
    const auto scene = Scene::load(path, lds::catalog::SensorModel::HlG203);
    QVERIFY(!scene);
    QCOMPARE(scene.error(), path + u": is larger than 1048576 bytes"_s);
}

void SceneErrorsTest::refusesWhatIsNoFile()
{
    const QTemporaryDir folder;
    const auto scene = Scene::load(folder.path(), lds::catalog::SensorModel::HlG203);
    QVERIFY(!scene);
    QCOMPARE(scene.error(), folder.path() + u": is not a file"_s);
}

void SceneErrorsTest::readsAFile()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"scene.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(fullScene());
    file.close();
    const auto scene = Scene::load(path, lds::catalog::SensorModel::HlG203);
    QVERIFY(scene);
    QCOMPARE((*scene)->name(), u"Everything"_s);
}

QTEST_GUILESS_MAIN(SceneErrorsTest)
#include "tst_scene_errors.moc"
