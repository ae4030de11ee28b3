#pragma once

#include "serial_settings.h"

#include <QByteArray>
#include <QObject>
#include <QString>

namespace lds::modbus {

/// A serial line as a scan needs it: bytes out, whatever comes in. One thing at a time; every call ends with
/// exactly one signal, never inside the call, unless close() comes first.
class ScanLine : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Opens the port, or gives the open one other settings. Then opened() or failed().
    virtual void open(const QString& port, const ports::SerialSettings& serial) = 0;
    /// Sends `request`, nothing when it is empty, and listens: for `windowMs` from the end of the request on
    /// the line if nothing comes, else until nothing has come for `silenceMs`. Then heard() or failed(). At
    /// most a few frames are kept.
    virtual void exchange(const QByteArray& request, int windowMs, int silenceMs) = 0;
    /// Gives the port back; no signal comes afterwards.
    virtual void close() = 0;

Q_SIGNALS:
    void opened();
    void heard(const QByteArray& bytes);
    void failed(const QString& detail); ///< The system's own words; the line is closed then.
};

} // namespace lds::modbus
