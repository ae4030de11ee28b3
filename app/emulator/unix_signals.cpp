#include "unix_signals.h"

#include <QSocketNotifier>
#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/socket.h>
#include <unistd.h>
#endif

namespace lds::app {

#ifdef Q_OS_UNIX

namespace {

int sockets[2] = {-1, -1}; ///< The handler writes into the first; the event loop watches the second.

/// Only what a signal handler may do.
void wakeUp(int)
{
    const char byte = 1;
    [[maybe_unused]] const auto written = ::write(sockets[0], &byte, 1);
}

} // namespace

UnixSignals::UnixSignals(std::function<void()> onEnd, QObject* parent)
    : QObject(parent)
{
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, sockets) != 0)
        return; // signals then end the program as they always do
    m_notifier = std::make_unique<QSocketNotifier>(sockets[1], QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, [this, end = std::move(onEnd)] {
        m_notifier->setEnabled(false);
        end();
    });
    struct sigaction action = {};
    action.sa_handler = wakeUp;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

#else

UnixSignals::UnixSignals(std::function<void()>, QObject* parent)
    : QObject(parent)
{}

#endif

UnixSignals::~UnixSignals() = default;

} // namespace lds::app
