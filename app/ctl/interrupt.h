#pragma once

#include "scheduler.h"

#include <functional>
#include <QObject>

namespace lds::ctl {

/// Turns Ctrl+C and SIGTERM into one call in the event loop, on every system; a second one ends the program
/// at once. One per program.
class Interrupt : public QObject {
    Q_OBJECT

public:
    Interrupt(ports::Scheduler& scheduler, std::function<void()> callback);

private:
    void look();

    ports::Scheduler& m_scheduler;
    std::function<void()> m_callback;
};

} // namespace lds::ctl
