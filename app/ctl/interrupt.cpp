#include "interrupt.h"

#include <csignal>

namespace lds::ctl {

namespace {

// All that a signal handler may touch everywhere; hence looked at now and then instead of being told.
volatile std::sig_atomic_t interrupted = 0;
constexpr int lookEveryMs = 50;

void note(int signal)
{
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interrupt::Interrupt(ports::Scheduler& scheduler, std::function<void()> callback)
    : m_scheduler(scheduler)
    , m_callback(std::move(callback))
{
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    look();
}

void Interrupt::look()
{
    if (interrupted)
        return m_callback();
    m_scheduler.after(lookEveryMs, this, [this] { look(); });
}

} // namespace lds::ctl
