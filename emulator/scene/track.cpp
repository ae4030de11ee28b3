#include "track.h"

#include "sine.h"

#include <algorithm>

namespace lds::emulator {

void Track::add(qint64 fromNs, qint64 toNs, const std::optional<Facet>& facet)
{
    if (toNs <= fromNs)
        return;
    if (!facet) {
        m_stretches.push_back({fromNs, 0, 0, 0, 0, false});
        return;
    }
    const double duration = double(toNs - fromNs);
    m_stretches.push_back({fromNs, facet->heightFrom, (facet->heightTo - facet->heightFrom) / duration,
                           facet->reflectanceFrom, (facet->reflectanceTo - facet->reflectanceFrom) / duration,
                           true});
}

void Track::setSwing(double amplitude, qint64 periodNs, double phaseInTurns)
{
    m_swingAmplitude = amplitude;
    m_swingPeriodNs = std::max<qint64>(1, periodNs);
    m_swingPhase = phaseInTurns;
}

Meeting Track::at(qint64 timeNs) const
{
    if (m_stretches.empty())
        return {};
    const qint64 inPeriod = m_periodNs > 0 ? timeNs % m_periodNs : timeNs;
    const auto next = std::upper_bound(m_stretches.begin() + 1, m_stretches.end(), inPeriod,
                                       [](qint64 at, const Stretch& stretch) { return at < stretch.fromNs; });
    const Stretch& stretch = *(next - 1);
    if (!stretch.present)
        return {};
    const double since = double(inPeriod - stretch.fromNs);
    double height = stretch.height + stretch.heightPerNs * since;
    if (m_swingAmplitude != 0) {
        const double turn = double(timeNs % m_swingPeriodNs) / double(m_swingPeriodNs);
        height += m_swingAmplitude * sineOfTurns(turn + m_swingPhase);
    }
    return {true, height, stretch.reflectance + stretch.reflectancePerNs * since};
}

} // namespace lds::emulator
