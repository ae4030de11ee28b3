#pragma once

#include "rules.h"

#include <random>

namespace lds::settings::test {

/// Settings of one model, from a seed: full states and wishes, with the corners of the ranges and close
/// calls of the rules more often than chance would have them.
class RandomSettings {
public:
    RandomSettings(catalog::SensorModel model, quint32 seed);

    /// Every rule holds.
    Values state();
    /// Values a sensor should never hold: windows upside down, ports equal, addresses that are none.
    /// Each value alone is within its limits.
    Values brokenState();
    /// Some items, with the values of another state, now and then finer than the resolution, illegal, or
    /// what is held already.
    Values wish(const Values& current);

private:
    int below(int bound);
    bool oneIn(int n) { return below(n) == 0; }
    Value legalValue(const catalog::SettingItem& item);
    void makeWindow(Values& values);
    void makeTolerance(Values& values);
    void makePorts(Values& values);
    void makeNetwork(Values& values);
    quint32 mask();
    quint32 addressIn(quint32 mask);

    catalog::SensorModel m_model;
    std::mt19937 m_random;
};

} // namespace lds::settings::test
