#include "scene_track.h"

#include <cmath>
#include <numbers>

namespace lds::emulator {

namespace {

constexpr double nanosecondsPerSecond = 1e9;
constexpr qint64 nanosecondsPerMillisecond = 1'000'000;
constexpr double quarterTurn = 0.25; ///< The eccentric side is on top at 0°: a cosine.
constexpr qint64 anyDuration = 1;    ///< Of a stretch whose values stay the same.

Facet flat(double height, double reflectance) { return {0, 0, height, height, reflectance, reflectance}; }

std::optional<Facet> facetOf(const std::optional<Background>& background)
{
    return background ? std::optional(flat(background->height, background->reflectance)) : std::nullopt;
}

Facet measuringPoint(const SceneDescription& scene, std::size_t workpiece)
{
    const Meeting meeting = meetingAtMeasuringPoint(scene, workpiece);
    return flat(meeting.height, meeting.reflectance);
}

/// Lays one behind the other what passes at a constant speed. Times are rounded from positions since the
/// beginning, so that roundings do not add up.
class PassingBy {
public:
    explicit PassingBy(double positionsPerSecond)
        : m_positionsPerSecond(positionsPerSecond)
    {}

    void add(const WorkpieceDescription& workpiece)
    {
        for (const Facet& facet : facetsOf(workpiece.height, workpiece.reflectance, workpiece.length))
            m_track.add(timeOf(m_position + facet.from), timeOf(m_position + facet.to), facet);
        m_position += workpiece.length;
    }
    void add(double length, const std::optional<Facet>& facet)
    {
        m_track.add(timeOf(m_position), timeOf(m_position + length), facet);
        m_position += length;
    }
    Track track()
    {
        m_track.setPeriod(timeOf(m_position));
        return std::move(m_track);
    }

private:
    qint64 timeOf(double position) const
    {
        return std::llround(position / m_positionsPerSecond * nanosecondsPerSecond);
    }

    double m_positionsPerSecond;
    double m_position = 0;
    Track m_track;
};

Track trackOf(const SceneDescription& scene, const ConveyorMotion& motion)
{
    const std::optional<Facet> background = facetOf(motion.background);
    PassingBy belt(motion.speed);
    for (const Place& place : motion.order) {
        double length = 0;
        if (place) {
            belt.add(scene.workpieces[*place]);
            length = scene.workpieces[*place].length;
        }
        belt.add(motion.pitch ? *motion.pitch - length : motion.gap, background);
    }
    return belt.track();
}

Track trackOf(const SceneDescription& scene, const ShaftMotion& motion)
{
    PassingBy around(fullTurn * motion.revolutionsPerSecond);
    around.add(scene.workpieces[motion.workpiece]);
    Track track = around.track();
    // The turn's own period, to the nanosecond: the swing must not drift against the profile.
    track.setSwing(motion.eccentricity, track.periodNs(), quarterTurn);
    return track;
}

Track trackOf(const SceneDescription& scene, const PlateMotion& motion)
{
    Track track;
    track.add(0, anyDuration, measuringPoint(scene, motion.workpiece));
    track.setSwing(motion.amplitude, std::llround(nanosecondsPerSecond / motion.frequency), 0);
    return track;
}

Track trackOf(const SceneDescription& scene, const StillMotion& motion)
{
    Track track;
    track.add(0, anyDuration, measuringPoint(scene, motion.workpiece));
    return track;
}

Track trackOf(const SceneDescription& scene, const TimelineMotion& motion)
{
    const std::optional<Facet> background = facetOf(motion.background);
    Track track;
    track.add(0, motion.places.front().atMs * nanosecondsPerMillisecond, background);
    for (const TimelineMotion::Placing& placing : motion.places) {
        const qint64 fromNs = placing.atMs * nanosecondsPerMillisecond;
        track.add(fromNs, fromNs + anyDuration,
                  placing.workpiece ? measuringPoint(scene, *placing.workpiece) : background);
    }
    track.setPeriod(motion.repeatMs * nanosecondsPerMillisecond);
    return track;
}

} // namespace

Track trackOf(const SceneDescription& scene)
{
    return std::visit([&](const auto& motion) { return trackOf(scene, motion); }, scene.motion);
}

Meeting meetingAtMeasuringPoint(const SceneDescription& scene, std::size_t workpiece)
{
    const WorkpieceDescription& found = scene.workpieces[workpiece];
    double height = found.height.valueAt(found.measuringPoint);
    if (const auto* shaft = std::get_if<ShaftMotion>(&scene.motion))
        height += shaft->eccentricity * std::cos(found.measuringPoint / fullTurn * 2 * std::numbers::pi);
    return {true, height, found.reflectance.valueAt(found.measuringPoint)};
}

} // namespace lds::emulator
