#pragma once

#include <functional>
#include <memory>
#include <QObject>

class QSocketNotifier;

namespace lds::app {

/// Turns SIGINT and SIGTERM into a call in the event loop. One per program. Does nothing where there are
/// no Unix signals.
class UnixSignals : public QObject {
    Q_OBJECT

public:
    explicit UnixSignals(std::function<void()> onEnd, QObject* parent = nullptr);
    ~UnixSignals() override;

private:
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace lds::app
