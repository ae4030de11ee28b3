#include "scene_reader.h"

#include "json_fields.h"
#include "scene_motion_reader.h"

#include <algorithm>
#include <QJsonDocument>
#include <QJsonParseError>
#include <utility>

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype longestName = 100;
constexpr qsizetype longestDescription = 2000;
constexpr int knownVersion = 1;
constexpr NumberLimits positionLimits{0, longestWorkpiece, " mm"};
constexpr NumberLimits angleLimits{0, fullTurn, "°"};
constexpr NumberLimits lengthLimits{shortestWorkpiece, longestWorkpiece, " mm"};
constexpr NumberLimits seedLimits{0, 9'007'199'254'740'992}; // 2^53: whole numbers JSON can carry
constexpr NumberLimits millisecondLimits{1, mostMilliseconds, " ms"};

/// "line 3, column 17": the character the parser could not take. Columns count characters, not bytes.
QString lineAndColumn(const QByteArray& json, const QJsonParseError& error)
{
    // The parser stops behind the character that is wrong, but in front of what follows a whole document.
    const bool stoppedInFront = error.error == QJsonParseError::GarbageAtEnd;
    const QByteArray before = json.left(stoppedInFront ? error.offset : std::max(0, error.offset - 1));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    const qsizetype line = before.count('\n') + 1;
    return u"line %1, column %2"_s.arg(line).arg(QString::fromUtf8(before.mid(lineStart)).size() + 1);
}

class SceneReader {
public:
    SceneReader(const QJsonObject& scene, double measurementRange)
        : m_scene(scene)
        , m_measurementRange(measurementRange)
        , m_onShaft(turnsOnShaft(scene))
    {}

    tl::expected<SceneDescription, QString> read()
    {
        JsonFields fields(m_scene, {}, m_complaint);
        readFormat(fields);
        if (!m_complaint.isEmpty()) // nothing else can be trusted to mean what it says
            return tl::unexpected(m_complaint.text());
        const QString name = fields.text("name"_L1, longestName);
        const QString description = fields.text("description"_L1, longestDescription);
        readUnit(fields);
        SceneDescription scene{name, description, readWorkpieces(fields), StillMotion{0}, {}, {}, {}};
        if (m_complaint.isEmpty())
            scene.motion =
                readMotion(fields.requiredValue("motion"_L1), scene.workpieces, m_unit, m_complaint);
        else
            fields.value("motion"_L1); // a field of its own all the same
        scene.surroundings = readSurroundings(fields);
        scene.faults = readFaults(fields);
        scene.triggers = readTriggers(fields);
        fields.rejectOthers();
        if (!m_complaint.isEmpty())
            return tl::unexpected(m_complaint.text());
        return scene;
    }

private:
    void readFormat(JsonFields& fields)
    {
        if (fields.requiredValue("format"_L1) != QJsonValue("lds-scene"_L1))
            fields.complain("format"_L1, u"has to be \"lds-scene\""_s);
        if (fields.requiredValue("version"_L1) != QJsonValue(knownVersion))
            fields.complain("version"_L1,
                            u"has to be %1, the only one this program knows"_s.arg(knownVersion));
    }

    void readUnit(JsonFields& fields)
    {
        const QJsonValue value = fields.value("unit"_L1);
        if (value == QJsonValue("range"_L1))
            m_unit = {m_measurementRange, mostRanges, " measurement ranges"};
        else if (!value.isUndefined() && value != QJsonValue("mm"_L1))
            fields.complain("unit"_L1, u"has to be \"mm\" or \"range\""_s);
    }

    std::vector<WorkpieceDescription> readWorkpieces(JsonFields& fields)
    {
        std::vector<WorkpieceDescription> workpieces;
        const QJsonArray list = fields.list("workpieces"_L1, mostWorkpieces);
        for (qsizetype i = 0; i < list.size() && m_complaint.isEmpty(); ++i) {
            const QString path = elementPath(u"workpieces"_s, i);
            JsonFields each(list.at(i), path, m_complaint);
            workpieces.push_back(readWorkpiece(each));
            checkName(workpieces, path);
            each.rejectOthers();
        }
        return workpieces;
    }

    void checkName(const std::vector<WorkpieceDescription>& workpieces, const QString& path)
    {
        const QString& name = workpieces.back().name;
        bool printable = name == name.trimmed();
        for (const QChar character : name)
            printable = printable && (character.isPrint() || character.isSurrogate());
        if (!printable)
            m_complaint.add(
                path + u".name"_s,
                u"must not begin or end with a space, nor hold a character that cannot be printed"_s);
        for (std::size_t i = 0; i + 1 < workpieces.size(); ++i) {
            if (workpieces[i].name == name)
                m_complaint.add(path + u".name"_s,
                                u"workpieces[%1] is called %2 too"_s.arg(i).arg(quoted(name)));
        }
    }

    WorkpieceDescription readWorkpiece(JsonFields& fields)
    {
        const QString name = fields.text("name"_L1, longestWorkpieceName);
        Course height = readHeight(fields);
        Course reflectance = readReflectance(fields);
        const double length = readLength(fields, std::max(height.end(), reflectance.end()));
        const NumberLimits within{0, length, m_onShaft ? "°" : " mm"};
        const double measuringPoint = fields.number("measuringPoint"_L1, within, m_onShaft ? 0 : length / 2);
        if (m_onShaft) {
            height = height.closedAt(fullTurn);
            reflectance = reflectance.closedAt(fullTurn);
        }
        return {name, std::move(height), std::move(reflectance), length, measuringPoint};
    }

    Course readHeight(JsonFields& fields)
    {
        const NumberLimits limits = m_unit.signedLimits();
        const bool hasProfile = fields.has("profile"_L1);
        if (fields.has("height"_L1) == hasProfile) {
            fields.complain("height"_L1, hasProfile ? u"cannot be given together with profile"_s
                                                    : u"is missing: give either height or profile"_s);
        }
        if (hasProfile)
            return readCourse(fields, "profile"_L1, limits, m_unit.nanometres);
        return Course(m_unit.nanometres * fields.number("height"_L1, limits));
    }

    Course readReflectance(JsonFields& fields)
    {
        if (fields.value("reflectance"_L1).isArray())
            return readCourse(fields, "reflectance"_L1, lightLimits, 1);
        return Course(fields.number("reflectance"_L1, lightLimits, 1));
    }

    /// A list of [position, value].
    Course readCourse(JsonFields& fields, QLatin1StringView key, const NumberLimits& limits, double factor)
    {
        const QJsonArray list = fields.list(key, mostPoints);
        std::vector<Course::Point> points;
        for (qsizetype i = 0; i < list.size() && m_complaint.isEmpty(); ++i) {
            const QString path = elementPath(fields.pathOf(key), i);
            const QJsonArray pair = list.at(i).toArray();
            if (pair.size() != 2) {
                m_complaint.add(path, u"has to be a point, [position, value]"_s);
                break;
            }
            const double position = checkedNumber(pair.at(0), elementPath(path, 0),
                                                  m_onShaft ? angleLimits : positionLimits, m_complaint);
            const double value = checkedNumber(pair.at(1), elementPath(path, 1), limits, m_complaint);
            checkOrder(points, position, path);
            points.push_back({position, factor * value});
        }
        return points.empty() ? Course(0) : Course(std::move(points));
    }

    void checkOrder(const std::vector<Course::Point>& points, double position, const QString& path)
    {
        if (points.empty())
            return;
        const double previous = points.back().position;
        if (position < previous)
            m_complaint.add(
                path, u"position %1 comes after %2: positions have to ascend"_s.arg(position).arg(previous));
        if (points.size() >= 2 && position == previous && points[points.size() - 2].position == position)
            m_complaint.add(path, u"is the third point at position %1; a step has two"_s.arg(position));
    }

    double readLength(JsonFields& fields, double end)
    {
        if (m_onShaft) {
            if (fields.has("length"_L1))
                fields.complain("length"_L1, u"does not apply to a shaft, which is 360° around"_s);
            return fullTurn;
        }
        const double length = fields.number("length"_L1, lengthLimits, end);
        if (length < end)
            fields.complain("length"_L1,
                            u"%1 mm ends before the last point, at %2 mm"_s.arg(length).arg(end));
        return length;
    }

    Surroundings readSurroundings(JsonFields& fields)
    {
        Surroundings surroundings;
        surroundings.noise = m_unit.nanometres * fields.number("noise"_L1, m_unit.unsignedLimits(), 0);
        surroundings.seed = quint64(fields.wholeNumber("seed"_L1, seedLimits, 1));
        if (!fields.value("ambientLight"_L1).isObject()) {
            surroundings.ambientLight = fields.number("ambientLight"_L1, lightLimits, 0);
            return surroundings;
        }
        const QString path = fields.pathOf("ambientLight"_L1);
        JsonFields light(fields.value("ambientLight"_L1), path, m_complaint);
        surroundings.ambientLight = light.number("level"_L1, lightLimits, 0);
        const QJsonArray list = light.list("intervals"_L1, mostGlares);
        for (qsizetype i = 0; i < list.size() && m_complaint.isEmpty(); ++i) {
            JsonFields each(list.at(i), elementPath(path + u".intervals"_s, i), m_complaint);
            const double level = each.number("level"_L1, lightLimits);
            surroundings.glares.push_back({level, readInterval(each)});
            each.rejectOthers();
        }
        light.rejectOthers();
        return surroundings;
    }

    QList<ScheduledFault> readFaults(JsonFields& fields)
    {
        QList<ScheduledFault> faults;
        if (!fields.has("faults"_L1))
            return faults;
        const QJsonArray list = fields.list("faults"_L1, mostIntervals);
        for (qsizetype i = 0; i < list.size() && m_complaint.isEmpty(); ++i) {
            JsonFields each(list.at(i), elementPath(u"faults"_s, i), m_complaint);
            faults.append(readFault(each));
            each.rejectOthers();
        }
        return faults;
    }

    ScheduledFault readFault(JsonFields& fields)
    {
        const QString name = fields.text("fault"_L1, 40);
        const auto fault = faultNamed(name);
        if (!fault) {
            QStringList known;
            for (const NamedFault each : allFaults())
                known.append(keyOf(each));
            fields.complain("fault"_L1,
                            u"%1 is no fault; these are: %2"_s.arg(quoted(name), known.join(u", "_s)));
            return {NamedFault::NoLight, {}, 0};
        }
        ScheduledFault scheduled{*fault, {}, 0};
        if (const auto standard = defaultMilliseconds(*fault))
            scheduled.milliseconds = int(fields.wholeNumber("milliseconds"_L1, millisecondLimits, *standard));
        else if (fields.has("milliseconds"_L1))
            fields.complain("milliseconds"_L1, u"does not apply to %1"_s.arg(name));
        scheduled.when = *fault == NamedFault::Saving ? readInterval(fields, scheduled.milliseconds)
                                                      : readInterval(fields);
        return scheduled;
    }

    QList<Interval> readTriggers(JsonFields& fields)
    {
        QList<Interval> triggers;
        if (!fields.has("triggers"_L1))
            return triggers;
        const QJsonArray list = fields.list("triggers"_L1, mostIntervals);
        for (qsizetype i = 0; i < list.size() && m_complaint.isEmpty(); ++i) {
            JsonFields each(list.at(i), elementPath(u"triggers"_s, i), m_complaint);
            triggers.append(readInterval(each));
            each.rejectOthers();
        }
        return triggers;
    }

    const QJsonObject m_scene;
    double m_measurementRange;
    bool m_onShaft;
    HeightUnit m_unit{1'000'000, mostMillimetres, " mm"};
    Complaint m_complaint;
};

} // namespace

tl::expected<SceneDescription, QString> readScene(const QByteArray& json, double measurementRange)
{
    if (json.size() > largestSceneFile)
        return tl::unexpected(u"is larger than %1 bytes"_s.arg(largestSceneFile));
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return tl::unexpected(
            u"is not JSON: %1 at %2"_s.arg(error.errorString(), lineAndColumn(json, error)));
    if (!document.isObject())
        return tl::unexpected(u"has to be an object, {…}"_s);
    return SceneReader(document.object(), measurementRange).read();
}

} // namespace lds::emulator
