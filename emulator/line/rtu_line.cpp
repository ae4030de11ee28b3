#include "rtu_line.h"

#include <algorithm>

namespace lds::emulator {

RtuLine::RtuLine(LineTerminal& terminal, EmulatorClock& clock)
    : m_terminal(terminal)
    , m_clock(clock)
    , m_transmitter(terminal, clock)
{
    connect(&terminal, &LineTerminal::received, this, &RtuLine::receive);
    connect(&m_transmitter, &LineTransmitter::finished, this, &RtuLine::answersGone);
}

void RtuLine::attach(RtuUnit& unit)
{
    m_units.append(&unit);
    unit.answerGone(); // what it owed another line before will never be sent
    connect(&unit, &RtuUnit::fellSilent, this, [this, unit = &unit] { dropAnswer(unit); });
    connect(&unit, &QObject::destroyed, this, [this, unit = &unit] { detach(unit); });
}

void RtuLine::receive(const QByteArray& bytes)
{
    const auto settings = m_terminal.clientSettings();
    if (!settings)
        return; // no speed, no characters
    const qint64 now = m_clock.nowNs();
    if (const auto due = m_receiver.frameDueNs(); due && *due <= now)
        endFrame(); // its timer comes late
    if (!m_receiver.frameDueNs())
        m_frameSettings = *settings;
    m_receiver.feed(bytes, settings->rate(), now);
    if (m_transmitter.isSending()) {
        m_transmitter.disturb(bytes, now);
        m_receiver.spoil();
    }
    if (m_frameSettings != settings)
        m_receiver.spoil();
    waitForSilence();
}

void RtuLine::waitForSilence()
{
    m_clock.cancel(m_silenceTimer);
    m_silenceTimer = 0;
    const auto due = m_receiver.frameDueNs();
    if (!due)
        return;
    m_silenceTimer = m_clock.at(*due, this, [this] {
        m_silenceTimer = 0;
        endFrame();
    });
}

void RtuLine::endFrame()
{
    const qint64 completeNs = m_receiver.frameDueNs().value_or(m_clock.nowNs());
    const auto bytes = m_receiver.take();
    waitForSilence();
    const auto frame = modbus::decodeRtuFrame(bytes.value_or(QByteArray()));
    if (!frame) {
        ++m_noiseCount;
        return;
    }
    ++m_frameCount;
    const auto units = m_units;
    for (RtuUnit* unit : units) {
        auto answer = unit->hear(*frame, m_frameSettings, completeNs, m_clock.nowNs());
        if (!answer)
            continue;
        const qint64 startNs = answer->startNs;
        const auto timer = m_clock.at(startNs, this, [this, unit] { startAnswer(unit); });
        m_outstanding.push_back({unit, std::move(*answer), timer});
    }
}

void RtuLine::startAnswer(RtuUnit* unit)
{
    const auto outstanding = std::find_if(m_outstanding.begin(), m_outstanding.end(),
                                          [unit](const Outstanding& each) { return each.unit == unit; });
    if (outstanding == m_outstanding.end())
        return;
    outstanding->timer = 0;
    const RtuUnit::Answer answer = outstanding->answer;
    m_transmitter.send(answer.frame, answer.settings, answer.startNs);
    // A client that speaks at this moment spoils the answer, and is not understood either.
    if (m_receiver.frameDueNs() && m_receiver.lastByteNs() > answer.startNs) {
        const auto rate = answer.settings.rate();
        const qint64 characters =
            (m_receiver.lastByteNs() - answer.startNs) / modbus::charactersNs(rate, 1) + 1;
        m_transmitter.disturb(QByteArray(characters, '\x55'), answer.startNs);
        m_receiver.spoil();
    }
}

/// The unit falls silent in whatever it was about.
void RtuLine::dropAnswer(RtuUnit* unit)
{
    const auto outstanding = std::find_if(m_outstanding.begin(), m_outstanding.end(),
                                          [unit](const Outstanding& each) { return each.unit == unit; });
    if (outstanding == m_outstanding.end())
        return;
    if (outstanding->timer == 0 && !m_transmitter.isCollision()) {
        m_transmitter.cut(); // which ends it
        return;
    }
    m_clock.cancel(outstanding->timer);
    m_outstanding.erase(outstanding);
    unit->answerGone();
}

void RtuLine::answersGone()
{
    for (auto each = m_outstanding.begin(); each != m_outstanding.end();) {
        if (each->timer != 0) {
            ++each;
            continue;
        }
        RtuUnit* unit = each->unit;
        each = m_outstanding.erase(each);
        unit->answerGone();
    }
}

void RtuLine::detach(RtuUnit* unit)
{
    m_units.removeOne(unit);
    m_outstanding.remove_if([this, unit](const Outstanding& each) {
        if (each.unit != unit)
            return false;
        m_clock.cancel(each.timer);
        return true;
    });
}

} // namespace lds::emulator
