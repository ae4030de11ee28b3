#pragma once

#include "line_settings.h"

#include <optional>
#include <QByteArray>
#include <QObject>

namespace lds::emulator {

/// Where a client is connected to a virtual serial line. It takes and gives bytes at once; how long they
/// take on the line is for RtuLine to say.
class LineTerminal : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// What the client has set, now; nothing when that is no speed.
    virtual std::optional<LineSettings> clientSettings() const = 0;
    /// Lost when nobody is there to receive them.
    virtual void send(const QByteArray& bytes) = 0;

Q_SIGNALS:
    void received(const QByteArray& bytes);
};

} // namespace lds::emulator
