#include "control_input.h"

#include <QSocketNotifier>

#ifdef Q_OS_UNIX
#include <array>
#include <cerrno>
#include <unistd.h>
#endif

namespace lds::app {

ControlInput::~ControlInput() = default;

void ControlInput::answer(const LineSplitter::Line& line)
{
    m_print(line.overlong ? ControlDesk::answerToOverlongLine() : m_desk.answer(line.text));
}

#ifdef Q_OS_UNIX

ControlInput::ControlInput(ControlDesk& desk, int descriptor, Print print, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_descriptor(descriptor)
    , m_print(std::move(print))
    , m_notifier(std::make_unique<QSocketNotifier>(descriptor, QSocketNotifier::Read))
{
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &ControlInput::read);
}

bool ControlInput::isPossible() { return true; }

/// One piece at a time, so that sensors are served between.
void ControlInput::read()
{
    std::array<char, ControlDesk::longestLine> bytes;
    const ssize_t count = ::read(m_descriptor, bytes.data(), bytes.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN))
        return;
    if (count > 0) {
        const auto lines = m_splitter.feed(QByteArray(bytes.data(), count));
        for (const LineSplitter::Line& line : lines)
            answer(line);
        return;
    }
    m_notifier->setEnabled(false);
    if (const auto rest = m_splitter.rest())
        answer(*rest);
}

#else

ControlInput::ControlInput(ControlDesk& desk, int descriptor, Print print, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_descriptor(descriptor)
    , m_print(std::move(print))
{}

bool ControlInput::isPossible() { return false; }

void ControlInput::read() {}

#endif

} // namespace lds::app
