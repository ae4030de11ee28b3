#pragma once

#include "emulator_clock.h"
#include "frame_receiver.h"
#include "line_terminal.h"
#include "line_transmitter.h"
#include "rtu_unit.h"

#include <list>
#include <QList>
#include <QObject>

namespace lds::emulator {

/// An RS-485 line with several units and one client (§6.2): half duplex, one pair of wires, everything takes
/// the time that its characters take. Lives in the thread of its units.
class RtuLine final : public QObject {
    Q_OBJECT

public:
    RtuLine(LineTerminal& terminal, EmulatorClock& clock);

    /// From now on the unit is on the line, for as long as it lives.
    void attach(RtuUnit& unit);
    int unitCount() const { return int(m_units.size()); }
    /// What the line has carried from the client: frames with a CRC that fits, and everything else.
    int frameCount() const { return m_frameCount; }
    int noiseCount() const { return m_noiseCount; }

private:
    struct Outstanding {
        RtuUnit* unit;
        RtuUnit::Answer answer;
        EmulatorClock::TimerId timer = 0; ///< 0 once it is being sent.
    };

    void receive(const QByteArray& bytes);
    void waitForSilence();
    void endFrame();
    void startAnswer(RtuUnit* unit);
    void dropAnswer(RtuUnit* unit);
    void answersGone();
    void detach(RtuUnit* unit);

    LineTerminal& m_terminal;
    EmulatorClock& m_clock;
    QList<RtuUnit*> m_units;
    FrameReceiver m_receiver;
    LineTransmitter m_transmitter;
    LineSettings m_frameSettings; ///< The client's when the frame began.
    EmulatorClock::TimerId m_silenceTimer = 0;
    std::list<Outstanding> m_outstanding; ///< At most one of each unit.
    int m_frameCount = 0;
    int m_noiseCount = 0;
};

} // namespace lds::emulator
