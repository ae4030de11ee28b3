#include "measurement_chain.h"

#include <algorithm>
#include <utility>

namespace lds::emulator {

namespace {

constexpr Nanometres spanUnit = 10'000;

} // namespace

void MeasurementChain::setSettings(const ChainSettings& settings)
{
    if (settings == m_settings)
        return;
    const ChainSettings before = std::exchange(m_settings, settings);
    if (before.outputDelay != settings.outputDelay) {
        for (OutputDelayTimer& timer : m_timers)
            timer.setSettings(settings.outputDelay);
    }
    if (before.averageTimes != settings.averageTimes || before.holdMode != settings.holdMode ||
        before.triggerMode != settings.triggerMode) {
        restart();
        return;
    }
    // §4.7.2 note 1: changed while unmeasurable, it shows ---- until light comes back.
    if (before.alarmShown != settings.alarmShown && !measurable()) {
        m_blank = true;
        m_live.value.reset();
        m_output.value.reset();
    }
    judge(m_timeNs);
}

void MeasurementChain::restart()
{
    m_ring.assign(std::size_t(std::max(1, m_settings.averageTimes)), 0);
    m_next = 0;
    m_filled = 0;
    m_sum = 0;
    m_highest.reset();
    m_lowest.reset();
    m_live.value.reset();
    m_output = m_live;
    m_holding = m_settings.triggerMode == TriggerMode::Hold && m_trigger;
    judge(m_timeNs);
}

void MeasurementChain::reset()
{
    restart();
    for (OutputDelayTimer& timer : m_timers)
        timer.reset();
}

void MeasurementChain::settle(const Reflection& reflection, bool trigger, qint64 timeNs)
{
    for (std::size_t i = 0; i < m_ring.size(); ++i)
        sample(reflection, true, trigger, timeNs);
}

void MeasurementChain::sample(const Reflection& reflection, bool laserEmitting, bool trigger, qint64 timeNs)
{
    m_reflection = reflection;
    if (laserEmitting) {
        if (measurable())
            average(reflection.distance);
        else
            countUnmeasurable();
    }
    refresh(laserEmitting, trigger, timeNs);
}

void MeasurementChain::refresh(bool laserEmitting, bool trigger, qint64 timeNs)
{
    m_timeNs = timeNs;
    if (!laserEmitting) { // nothing to see, and nothing wrong either
        m_unmeasurable = 0;
        m_blank = false;
        m_live = {};
        m_output = {};
        m_trigger = trigger;
        const bool holding = m_settings.triggerMode == TriggerMode::Hold && trigger;
        if (m_filled > 0 || m_judgment != Judgment::None || m_holding != holding)
            restart();
        return;
    }
    if (measurable()) {
        m_unmeasurable = 0;
        m_blank = false;
        m_live = {corrected(), false};
    }
    hold(trigger);
    m_trigger = trigger;
    judge(timeNs);
}

void MeasurementChain::advance(qint64 timeNs)
{
    m_timeNs = timeNs;
    for (OutputDelayTimer& timer : m_timers)
        timer.advance(timeNs);
}

void MeasurementChain::average(Nanometres distance)
{
    m_sum += distance - m_ring[m_next];
    m_ring[m_next] = distance;
    if (++m_next == m_ring.size())
        m_next = 0;
    m_filled = std::min(m_filled + 1, m_ring.size());
}

/// The last value stays while the alarm is delayed, and after it (§4.7.1, §4.7.2).
void MeasurementChain::countUnmeasurable()
{
    m_unmeasurable = std::min(m_unmeasurable + 1, m_settings.alarmDelayCount + 1);
    m_live.alarm = m_settings.alarmDelayCount > 0 && m_unmeasurable > m_settings.alarmDelayCount;
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

void MeasurementChain::hold(bool trigger)
{
    const bool raised = trigger && !m_trigger;
    const bool released = !trigger && m_trigger;
    if (m_settings.holdMode != HoldMode::None) {
        holdExtremes(trigger, released);
        return;
    }
    if (m_settings.triggerMode == TriggerMode::OneShot) {
        // Indeterminate until the first trigger, then every rising edge brings a new value (§4.6.2).
        if (raised) {
            m_output = m_live;
            m_holding = true;
        }
        return;
    }
    m_holding = trigger;
    if (!trigger || raised || !m_output.isThere())
        m_output = m_live;
}

void MeasurementChain::holdExtremes(bool trigger, bool released)
{
    m_holding = trigger;
    if (released) { // §4.3.4: the held value starts afresh when the trigger goes OFF
        m_highest.reset();
        m_lowest.reset();
    }
    if (trigger && m_output.isThere())
        return;
    m_output.alarm = m_live.alarm;
    if (!measurable() || !m_live.value) {
        if (m_blank)
            m_output.value.reset();
        return;
    }
    const Nanometres now = *m_live.value;
    m_highest = std::max(m_highest.value_or(now), now);
    m_lowest = std::min(m_lowest.value_or(now), now);
    switch (m_settings.holdMode) {
    case HoldMode::None:
        break;
    case HoldMode::Peak:
        m_output.value = m_highest;
        break;
    case HoldMode::Bottom:
        m_output.value = m_lowest;
        break;
    case HoldMode::PeakToPeak:
        m_output.value = *m_highest - *m_lowest;
        break;
    }
}

/// §4.4.3: HIGH comes above the set value and goes at the hysteresis below it; LOW the other way round.
Judgment MeasurementChain::judged() const
{
    if (!m_output.value || alarmShown())
        return Judgment::None;
    const bool wasHigh = m_judgment == Judgment::High;
    const bool wasLow = m_judgment == Judgment::Low;
    if (*m_output.value > m_settings.high - (wasHigh ? m_settings.hysteresis : 0))
        return Judgment::High;
    if (*m_output.value < m_settings.low + (wasLow ? m_settings.hysteresis : 0))
        return Judgment::Low;
    return Judgment::Go;
}

void MeasurementChain::judge(qint64 timeNs)
{
    m_judgment = judged();
    m_timers[0].judge(m_judgment == Judgment::High, timeNs);
    m_timers[1].judge(m_judgment == Judgment::Go, timeNs);
    m_timers[2].judge(m_judgment == Judgment::Low, timeNs);
}

JudgmentOutputs MeasurementChain::outputs() const
{
    return {m_timers[0].output(), m_timers[1].output(), m_timers[2].output()};
}

} // namespace lds::emulator
