#pragma once

#include "control_desk.h"
#include "line_splitter.h"

#include <functional>
#include <memory>
#include <QObject>

class QSocketNotifier;

namespace lds::app {

/// Control lines on standard input. Its end ends nothing else. Only where standard input can be watched by
/// an event loop: Unix.
class ControlInput final : public QObject {
    Q_OBJECT

public:
    using Print = std::function<void(const QByteArray& line)>;

    /// Starts with a file descriptor; `print` takes the answers.
    ControlInput(ControlDesk& desk, int descriptor, Print print, QObject* parent = nullptr);
    ~ControlInput() override;
    static bool isPossible();

private:
    void read();
    void answer(const LineSplitter::Line& line);

    ControlDesk& m_desk;
    const int m_descriptor;
    const Print m_print;
    LineSplitter m_splitter{ControlDesk::longestLine};
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace lds::app
