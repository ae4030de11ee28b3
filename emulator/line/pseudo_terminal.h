#pragma once

#include "emulator_clock.h"
#include "line_terminal.h"

#include <memory>
#include <QSocketNotifier>
#include <QString>
#include <tl/expected.hpp>

namespace lds::emulator {

/// A pseudo-terminal of Linux, to which a symbolic link leads that programs open like a serial port. It
/// stays when a client closes it; what that one has not read is lost, as on a line.
///
/// The client's speed and stop bits can be seen from here, and whether its parity is odd; the system hides
/// whether it has parity at all. Two stop bits therefore count as no parity, one as even or odd: no client
/// that uses one of the sensor's three combinations (§6.2) is misunderstood.
class PseudoTerminal final : public LineTerminal {
    Q_OBJECT

public:
    using Opened = tl::expected<std::unique_ptr<PseudoTerminal>, QString>;

    /// Makes the link, or takes over one that an emulator left behind. Anything else that stands there stays
    /// and is an error, as is a link that another emulator serves now.
    static Opened open(const QString& link, EmulatorClock& clock);
    ~PseudoTerminal() override; ///< Takes the link away, if it is still its own.

    QString link() const { return m_link; } ///< Absolute.
    QString device() const { return m_device; }
    /// Whether a client has it open, as far as is known yet.
    bool isOpen() const { return m_open; }

    std::optional<LineSettings> clientSettings() const override;
    void send(const QByteArray& bytes) override;

private:
    PseudoTerminal(const QString& link, EmulatorClock& clock);
    tl::expected<void, QString> reserveLink();
    tl::expected<void, QString> openTerminal();
    tl::expected<void, QString> makeLink();
    void readArrived();
    void forgetClient();
    void clientLeft();
    void replaceTerminal();
    bool hasClient() const;
    void waitForClient();

    QString m_link;
    EmulatorClock& m_clock;
    QString m_device;
    int m_master = -1;
    int m_reservation = -1;
    bool m_linked = false;
    bool m_open = true; ///< Also before the first client: nothing tells when it comes.
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace lds::emulator
