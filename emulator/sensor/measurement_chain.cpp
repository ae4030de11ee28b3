#include "measurement_chain.h"

#include <algorithm>

namespace lds::emulator {

namespace {
constexpr Nanometres spanUnit = 10'000;
}

void MeasurementChain::setSettings(const ChainSettings& settings)
{
    if (settings == m_settings)
        return;
    const ChainSettings before = std::exchange(m_settings, settings);
    if (before.averageTimes != settings.averageTimes || before.holdMode != settings.holdMode ||
        before.triggerMode != settings.triggerMode) {
        restart();
        return;
    }
    // §4.7.2 note 1: changed while unmeasurable, it shows ---- until light comes back.
    if (before.alarmShown != settings.alarmShown && !measurable())
        m_output.reset();
    judge();
}

void MeasurementChain::restart()
{
    m_ring.assign(std::size_t(std::max(1, m_settings.averageTimes)), 0);
    m_next = 0;
    m_filled = 0;
    m_sum = 0;
    m_highest.reset();
    m_lowest.reset();
    m_output.reset();
    m_holding = m_settings.triggerMode == TriggerMode::Hold && m_trigger;
    m_judgment = Judgment::None;
}

void MeasurementChain::settle(const Reflection& reflection, bool trigger)
{
    for (std::size_t i = 0; i < m_ring.size(); ++i)
        sample(reflection, true, trigger);
}

void MeasurementChain::sample(const Reflection& reflection, bool laserEmitting, bool trigger)
{
    m_reflection = reflection;
    if (!laserEmitting) { // nothing to see, and nothing wrong either
        restart();
        m_trigger = trigger;
        m_unmeasurable = 0;
        m_alarm = false;
        return;
    }
    if (measurable()) {
        m_unmeasurable = 0;
        m_alarm = false;
        average(reflection.distance);
        hold(corrected(), trigger);
    } else { // the last value stays while the alarm is delayed, and after it (§4.7.1, §4.7.2)
        m_unmeasurable = std::min(m_unmeasurable + 1, m_settings.alarmDelayCount + 1);
        m_alarm = m_settings.alarmDelayCount > 0 && m_unmeasurable > m_settings.alarmDelayCount;
        hold(std::nullopt, trigger);
    }
    m_trigger = trigger;
    judge();
}

void MeasurementChain::average(Nanometres distance)
{
    m_sum += distance - m_ring[m_next];
    m_ring[m_next] = distance;
    m_next = (m_next + 1) % m_ring.size();
    m_filled = std::min(m_filled + 1, m_ring.size());
}

std::optional<Nanometres> MeasurementChain::beforeZero() const
{
    if (m_filled < m_ring.size())
        return std::nullopt;
    const Nanometres mean = m_sum / Nanometres(m_ring.size());
    return m_settings.inverted ? -mean : mean;
}

std::optional<Nanometres> MeasurementChain::corrected() const
{
    const auto value = beforeZero();
    if (!value)
        return std::nullopt;
    return (*value - m_settings.zeroCorrection.value_or(0)) * m_settings.span / spanUnit + m_settings.offset;
}

void MeasurementChain::hold(std::optional<Nanometres> now, bool trigger)
{
    const bool raised = trigger && !m_trigger;
    const bool released = !trigger && m_trigger;
    if (m_settings.holdMode != HoldMode::None) {
        holdExtremes(now, trigger, released);
        return;
    }
    if (m_settings.triggerMode == TriggerMode::OneShot) {
        // Indeterminate until the first trigger, then every rising edge brings a new value (§4.6.2).
        if (raised && now) {
            m_output = now;
            m_holding = true;
        }
        return;
    }
    m_holding = trigger;
    if (now && (!trigger || raised || !m_output))
        m_output = now;
}

void MeasurementChain::holdExtremes(std::optional<Nanometres> now, bool trigger, bool released)
{
    m_holding = trigger;
    if (released) { // §4.3.4: the held value starts afresh when the trigger goes OFF
        m_highest.reset();
        m_lowest.reset();
    }
    if (!now || (trigger && m_output))
        return;
    m_highest = std::max(m_highest.value_or(*now), *now);
    m_lowest = std::min(m_lowest.value_or(*now), *now);
    switch (m_settings.holdMode) {
    case HoldMode::None:
        break;
    case HoldMode::Peak:
        m_output = m_highest;
        break;
    case HoldMode::Bottom:
        m_output = m_lowest;
        break;
    case HoldMode::PeakToPeak:
        m_output = *m_highest - *m_lowest;
        break;
    }
}

/// §4.4.3: HIGH comes above the set value and goes at the hysteresis below it; LOW the other way round.
void MeasurementChain::judge()
{
    if (!m_output) {
        m_judgment = Judgment::None;
        return;
    }
    const bool wasHigh = m_judgment == Judgment::High;
    const bool wasLow = m_judgment == Judgment::Low;
    if (*m_output > m_settings.high - (wasHigh ? m_settings.hysteresis : 0))
        m_judgment = Judgment::High;
    else if (*m_output < m_settings.low + (wasLow ? m_settings.hysteresis : 0))
        m_judgment = Judgment::Low;
    else
        m_judgment = Judgment::Go;
}

} // namespace lds::emulator
