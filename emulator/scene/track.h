#pragma once

#include "course.h"

#include <optional>
#include <QtGlobal>
#include <vector>

namespace lds::emulator {

/// What the beam meets at one moment, without noise and foreign light.
struct Meeting {
    bool present = false;
    double height = 0; ///< nm
    double reflectance = 0;
};

/// All that passes under the beam, laid out over time beforehand so that a moment is found quickly.
class Track {
public:
    /// Adds a stretch after the ones already there; the first begins at 0. A stretch that ends where it
    /// begins is left out. Heights in nm; nothing is there without a facet.
    void add(qint64 fromNs, qint64 toNs, const std::optional<Facet>& facet);
    /// The whole begins again after this time; 0: the last stretch goes on for ever.
    void setPeriod(qint64 periodNs) { m_periodNs = periodNs; }
    qint64 periodNs() const { return m_periodNs; }
    /// Up and down around the stretches by amplitude * sin(2π (time / period + phase)); nm, ns,
    /// and a phase of 0 to below 1.
    void setSwing(double amplitude, qint64 periodNs, double phaseInTurns);

    std::size_t size() const { return m_stretches.size(); }
    Meeting at(qint64 timeNs) const; ///< timeNs >= 0

private:
    struct Stretch {
        qint64 fromNs;
        double height;
        double heightPerNs;
        double reflectance;
        double reflectancePerNs;
        bool present;
    };

    std::vector<Stretch> m_stretches;
    qint64 m_periodNs = 0;
    double m_swingAmplitude = 0;
    qint64 m_swingPeriodNs = 1;
    double m_swingPhase = 0;
};

} // namespace lds::emulator
