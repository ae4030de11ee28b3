#pragma once

#include "emulator_clock.h"
#include "line_settings.h"
#include "line_terminal.h"

#include <optional>
#include <QByteArray>
#include <QObject>

namespace lds::emulator {

/// Gives the client what units send, as fast as the line carries it and never faster. Whatever else is on
/// the line meanwhile is mixed into it; a client at other settings gets garbage of the same length.
class LineTransmitter final : public QObject {
    Q_OBJECT

public:
    LineTransmitter(LineTerminal& terminal, EmulatorClock& clock);

    /// The first byte begins at `startNs`, which may have passed a little. While something is being sent
    /// already, the two collide.
    void send(const QByteArray& bytes, LineSettings settings, qint64 startNs);
    /// The client sends too, from `startNs` on.
    void disturb(const QByteArray& bytes, qint64 startNs);
    void cut(); ///< The sender falls silent.
    bool isSending() const { return m_burst.has_value(); }
    /// Whether more than one sends.
    bool isCollision() const { return m_burst && m_burst->senders > 1; }

Q_SIGNALS:
    void finished(); ///< Everything has gone out.

private:
    /// What goes over the line without a pause.
    struct Burst {
        QByteArray bytes;
        LineSettings settings;
        qint64 startNs = 0;
        qsizetype delivered = 0;
        int senders = 1;
    };

    qsizetype charactersUntil(qint64 timeNs) const;
    void mix(const QByteArray& bytes, qsizetype from);
    void deliverDue();
    void waitForMore();

    LineTerminal& m_terminal;
    EmulatorClock& m_clock;
    std::optional<Burst> m_burst;
    EmulatorClock::TimerId m_timer = 0;
};

} // namespace lds::emulator
