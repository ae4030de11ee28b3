#pragma once

#include "catalog.h"
#include "scenery.h"

namespace lds::emulator {

/// A workpiece that moves gently inside the measurement range, with a little noise. A function of time
/// and seed only, so that the same moment always shows the same value.
class Workpiece final : public Scenery {
public:
    explicit Workpiece(const catalog::ModelDescription& model, quint64 seed = 1);
    Sight at(qint64 timeNs) const override;

private:
    double m_amplitude; ///< nm
    double m_noise;     ///< nm, half width
    quint64 m_seed;
};

} // namespace lds::emulator
