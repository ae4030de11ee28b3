#include "scene_motion_reader.h"

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

constexpr NumberLimits speedLimits{0.01, 10'000, " mm/s"};
constexpr NumberLimits turnLimits{0.001, 1'000, " revolutions per second"};
constexpr NumberLimits frequencyLimits{0.001, 5'000, " Hz"}; // 5 kHz: half of the quickest sampling
constexpr NumberLimits gapLimits{0, longestWorkpiece, " mm"};
constexpr NumberLimits pitchLimits{shortestWorkpiece, longestWorkpiece, " mm"};
constexpr NumberLimits timeLimits{0, longestTimeMs, " ms"};
constexpr NumberLimits repeatLimits{1, longestTimeMs, " ms"};

const QString motionKinds = u"\"conveyor\", \"shaft\", \"plate\", \"still\" or \"timeline\""_s;

class MotionReader {
public:
    MotionReader(const QJsonValue& value, const std::vector<WorkpieceDescription>& workpieces,
                 const HeightUnit& unit, Complaint& complaint)
        : m_fields(value, u"motion"_s, complaint)
        , m_workpieces(workpieces)
        , m_unit(unit)
        , m_complaint(complaint)
    {}

    Motion read()
    {
        const Motion motion = ofKind(m_fields.text("kind"_L1, 20));
        m_fields.rejectOthers();
        return motion;
    }

private:
    Motion ofKind(const QString& kind)
    {
        if (kind == "conveyor"_L1)
            return conveyor();
        if (kind == "shaft"_L1)
            return shaft();
        if (kind == "plate"_L1)
            return plate();
        if (kind == "timeline"_L1)
            return timeline();
        if (kind == "still"_L1)
            return StillMotion{workpiece()};
        m_fields.complain("kind"_L1, u"%1 is no motion; it has to be %2"_s.arg(quoted(kind), motionKinds));
        return StillMotion{0};
    }

    Motion conveyor()
    {
        ConveyorMotion motion{m_fields.number("speed"_L1, speedLimits), {}, {}, 0, {}};
        const QJsonArray order = m_fields.list("order"_L1, mostPlaces);
        for (qsizetype i = 0; i < order.size(); ++i)
            motion.order.push_back(place(order.at(i), elementPath(u"motion.order"_s, i)));
        if (m_fields.has("pitch"_L1) && m_fields.has("gap"_L1))
            m_fields.complain("gap"_L1, u"cannot be given together with pitch"_s);
        if (m_fields.has("pitch"_L1))
            motion.pitch = m_fields.number("pitch"_L1, pitchLimits);
        motion.gap = m_fields.number("gap"_L1, gapLimits, 0);
        motion.background = background();
        if (m_complaint.isEmpty())
            checkPlaces(motion);
        return motion;
    }

    void checkPlaces(const ConveyorMotion& motion)
    {
        std::size_t stretches = 0;
        for (std::size_t i = 0; i < motion.order.size(); ++i) {
            const QString path = elementPath(u"motion.order"_s, qsizetype(i));
            const Place& each = motion.order[i];
            if (!each) {
                if (!motion.pitch)
                    m_complaint.add(path,
                                    u"an empty place needs the field pitch, which says how long it is"_s);
                continue;
            }
            const WorkpieceDescription& found = m_workpieces[*each];
            if (found.length <= 0) {
                m_complaint.add(elementPath(u"workpieces"_s, qsizetype(*each)) + u".length"_s,
                                u"is missing: on a conveyor a workpiece has a length, or a profile"_s);
            } else if (motion.pitch && found.length > *motion.pitch) {
                m_complaint.add(path, u"%1 is %2 mm long, which is more than the pitch of %3 mm"_s.arg(
                                          quoted(found.name), QString::number(found.length),
                                          QString::number(*motion.pitch)));
            }
            stretches += found.height.points().size() + found.reflectance.points().size();
        }
        if (stretches > std::size_t(mostStretches)) {
            m_fields.complain(
                "order"_L1,
                u"the profiles of all its places have %1 points; at most %2 are possible"_s.arg(stretches)
                    .arg(mostStretches));
        }
    }

    Motion shaft()
    {
        const std::size_t turning = workpiece();
        const double speed = m_fields.number("revolutionsPerSecond"_L1, turnLimits);
        return ShaftMotion{turning, speed,
                           m_unit.nanometres *
                               m_fields.number("eccentricity"_L1, m_unit.unsignedLimits(), 0)};
    }

    Motion plate()
    {
        const std::size_t vibrating = workpiece();
        const double amplitude = m_fields.number("amplitude"_L1, m_unit.unsignedLimits());
        return PlateMotion{vibrating, m_unit.nanometres * amplitude,
                           m_fields.number("frequency"_L1, frequencyLimits)};
    }

    Motion timeline()
    {
        TimelineMotion motion;
        const QJsonArray places = m_fields.list("places"_L1, mostPlaces);
        for (qsizetype i = 0; i < places.size() && m_complaint.isEmpty(); ++i) {
            const QString path = elementPath(u"motion.places"_s, i);
            JsonFields fields(places.at(i), path, m_complaint);
            const QJsonValue name = fields.requiredValue("workpiece"_L1);
            const qint64 atMs = fields.wholeNumber("atMs"_L1, timeLimits, std::nullopt);
            fields.rejectOthers();
            if (!motion.places.empty() && atMs <= motion.places.back().atMs)
                fields.complain("atMs"_L1, u"%1 has to come after the place before, at %2"_s.arg(atMs).arg(
                                               motion.places.back().atMs));
            motion.places.push_back({place(name, path + u".workpiece"_s), atMs});
        }
        motion.repeatMs = m_fields.wholeNumber("repeatMs"_L1, repeatLimits, 0);
        if (motion.repeatMs > 0 && m_complaint.isEmpty() && motion.repeatMs <= motion.places.back().atMs)
            m_fields.complain("repeatMs"_L1,
                              u"%1 has to come after the last place, at %2"_s.arg(motion.repeatMs)
                                  .arg(motion.places.back().atMs));
        motion.background = background();
        return motion;
    }

    std::optional<Background> background()
    {
        const QJsonValue value = m_fields.value("background"_L1);
        if (value.isUndefined() || value.isNull())
            return std::nullopt;
        JsonFields fields(value, u"motion.background"_s, m_complaint);
        const double height = m_unit.nanometres * fields.number("height"_L1, m_unit.signedLimits());
        const double reflectance = fields.number("reflectance"_L1, lightLimits, 1);
        fields.rejectOthers();
        return Background{height, reflectance};
    }

    std::size_t workpiece()
    {
        const QJsonValue value = m_fields.requiredValue("workpiece"_L1);
        if (value.isNull())
            m_fields.complain("workpiece"_L1, u"has to be the name of a workpiece"_s);
        return place(value, m_fields.pathOf("workpiece"_L1)).value_or(0);
    }

    /// The name of a workpiece, or null.
    Place place(const QJsonValue& value, const QString& path)
    {
        if (value.isNull())
            return std::nullopt;
        if (!value.isString()) {
            m_complaint.add(path, u"has to be the name of a workpiece, or null for none"_s);
            return std::nullopt;
        }
        const QString name = value.toString();
        for (std::size_t i = 0; i < m_workpieces.size(); ++i) {
            if (m_workpieces[i].name == name)
                return i;
        }
        if (m_complaint.isEmpty()) {
            m_complaint.add(path,
                            u"%1 is none of the workpieces; these are: %2"_s.arg(quoted(name), known()));
        }
        return std::nullopt;
    }

    QString known() const
    {
        constexpr std::size_t mostShown = 10;
        QStringList names;
        for (std::size_t i = 0; i < m_workpieces.size() && i < mostShown; ++i)
            names.append(quoted(m_workpieces[i].name));
        if (m_workpieces.size() > mostShown)
            names.append(u"…"_s);
        return names.join(u", "_s);
    }

    JsonFields m_fields;
    const std::vector<WorkpieceDescription>& m_workpieces;
    HeightUnit m_unit;
    Complaint& m_complaint;
};

} // namespace

bool turnsOnShaft(const QJsonObject& scene)
{
    return scene.value("motion"_L1).toObject().value("kind"_L1).toString() == "shaft"_L1;
}

Motion readMotion(const QJsonValue& value, const std::vector<WorkpieceDescription>& workpieces,
                  const HeightUnit& unit, Complaint& complaint)
{
    return MotionReader(value, workpieces, unit, complaint).read();
}

Interval readInterval(JsonFields& fields)
{
    const Interval interval{fields.wholeNumber("atMs"_L1, timeLimits, std::nullopt),
                            fields.wholeNumber("forMs"_L1, timeLimits, 0),
                            fields.wholeNumber("everyMs"_L1, timeLimits, 0)};
    if (interval.everyMs > 0 && interval.forMs == 0)
        fields.complain("forMs"_L1, u"is missing: what comes every %1 ms has to end"_s.arg(interval.everyMs));
    if (interval.everyMs > 0 && interval.everyMs <= interval.forMs)
        fields.complain("everyMs"_L1,
                        u"%1 has to be more than forMs, %2"_s.arg(interval.everyMs).arg(interval.forMs));
    return interval;
}

Interval readInterval(JsonFields& fields, qint64 durationMs)
{
    const Interval interval{fields.wholeNumber("atMs"_L1, timeLimits, std::nullopt), durationMs,
                            fields.wholeNumber("everyMs"_L1, timeLimits, 0)};
    if (fields.has("forMs"_L1))
        fields.complain("forMs"_L1, u"does not apply to what lasts its milliseconds"_s);
    if (interval.everyMs > 0 && interval.everyMs <= durationMs)
        fields.complain("everyMs"_L1,
                        u"%1 has to be more than milliseconds, %2"_s.arg(interval.everyMs).arg(durationMs));
    return interval;
}

} // namespace lds::emulator
