#include "brightness_tuning.h"

#include <algorithm>

namespace lds::emulator {

int BrightnessTuning::nextPoint() const
{
    if (isAdjusting())
        return 0;
    if (m_state == TuningState::FirstPoint)
        return 1;
    return m_state == TuningState::SecondPoint ? 2 : 0;
}

void BrightnessTuning::start(Operator by)
{
    m_state = TuningState::FirstPoint;
    m_operator = by;
    m_startedNs.reset();
}

void BrightnessTuning::interrupt()
{
    m_state = TuningState::NotExecuted;
    m_startedNs.reset();
}

void BrightnessTuning::take(qint64 nowNs)
{
    if (nextPoint() == 0)
        return;
    m_startedNs = nowNs;
    m_optimalSinceNs = nowNs;
}

void BrightnessTuning::fail()
{
    m_state = TuningState::Failed;
    m_startedNs.reset();
}

std::optional<BrightnessRange> BrightnessTuning::sample(const LightReceiver& receiver, qint64 timeNs)
{
    if (!isAdjusting())
        return std::nullopt;
    if (!receiver.isOptimal())
        m_optimalSinceNs = timeNs;
    if (timeNs - m_optimalSinceNs < stableNs) {
        if (timeNs - *m_startedNs >= longestNs)
            fail();
        return std::nullopt;
    }
    m_startedNs.reset();
    if (m_state == TuningState::FirstPoint) {
        m_first = receiver.brightness();
        m_state = TuningState::SecondPoint;
        return std::nullopt;
    }
    m_state = TuningState::Success;
    return BrightnessRange{std::min(m_first, receiver.brightness()),
                           std::max(m_first, receiver.brightness())};
}

} // namespace lds::emulator
