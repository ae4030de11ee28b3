#include "output_delay_timer.h"

namespace lds::emulator {

void OutputDelayTimer::setSettings(const OutputDelaySettings& settings)
{
    m_wanted = settings;
    if (!isBusy())
        adoptSettings();
}

void OutputDelayTimer::adoptSettings()
{
    if (m_settings == m_wanted)
        return;
    const bool selectionChanged = m_settings.selection != m_wanted.selection;
    m_settings = m_wanted;
    // A judgment that is ON already is no rising edge, so One Shot has nothing to show for it.
    if (selectionChanged)
        m_output = m_judgment && m_settings.selection != OutputDelay::OneShot;
}

void OutputDelayTimer::advance(qint64 nowNs)
{
    if (!m_dueNs || nowNs < *m_dueNs)
        return;
    m_dueNs.reset();
    m_output = m_settings.selection == OutputDelay::OnDelay;
    adoptSettings();
}

void OutputDelayTimer::change(bool judgment, qint64 nowNs)
{
    advance(nowNs);
    if (judgment == m_judgment)
        return;
    m_judgment = judgment;
    if (judgment)
        rise(nowNs);
    else
        fall(nowNs);
}

void OutputDelayTimer::rise(qint64 nowNs)
{
    switch (m_settings.selection) {
    case OutputDelay::Off:
    case OutputDelay::Hold:
        m_output = true;
        break;
    case OutputDelay::OnDelay:
        m_dueNs = nowNs + m_settings.durationNs;
        break;
    case OutputDelay::OffDelay: // an OFF shorter than the timer does not show
        m_dueNs.reset();
        m_output = true;
        break;
    case OutputDelay::OneShot: // a second rise does not prolong the first one's time
        if (!m_dueNs) {
            m_output = true;
            m_dueNs = nowNs + m_settings.durationNs;
        }
        break;
    }
    if (!isBusy())
        adoptSettings();
}

void OutputDelayTimer::fall(qint64 nowNs)
{
    switch (m_settings.selection) {
    case OutputDelay::Off:
        m_output = false;
        break;
    case OutputDelay::OnDelay: // an ON shorter than the timer does not show
        m_dueNs.reset();
        m_output = false;
        break;
    case OutputDelay::OffDelay:
        m_dueNs = nowNs + m_settings.durationNs;
        break;
    case OutputDelay::OneShot:
    case OutputDelay::Hold:
        break;
    }
    if (!isBusy())
        adoptSettings();
}

void OutputDelayTimer::reset()
{
    m_dueNs.reset();
    m_judgment = false;
    m_output = false;
    m_settings = m_wanted;
}

} // namespace lds::emulator
