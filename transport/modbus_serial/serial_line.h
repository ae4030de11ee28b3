#pragma once

#include "sensor_link.h"
#include "serial_settings.h"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <tl/expected.hpp>

namespace lds::modbus {

struct PortFailure {
    ports::OpenFailure failure = ports::OpenFailure::PortUnusable;
    QString detail; ///< The system's own words.
};

/// One serial port, opened: bytes go out one exchange at a time, and whatever comes in is told.
class SerialLine : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// `port` as the system opens it. When closed.
    virtual tl::expected<void, PortFailure> open(const QString& port,
                                                 const ports::SerialSettings& settings) = 0;
    virtual void close() = 0; ///< Silent. Does nothing when closed.

    /// Other settings for what follows; between exchanges. The error is the system's own text.
    virtual tl::expected<void, QString> adopt(const ports::SerialSettings& settings) = 0;

    /// Sends one request after the silence that belongs in front of it: sent(), then ended(), exactly once
    /// unless close() or lost() comes first. ended(false) may come alone: then nothing has gone out.
    /// `timeoutMs` ≥ 10 runs from the moment the bytes have been handed to the system.
    virtual void ask(quint8 unit, const QByteArray& pdu, int timeoutMs) = 0;
    /// Sends bytes as they are and at once; nothing ends by itself.
    virtual void write(const QByteArray& bytes) = 0;

Q_SIGNALS:
    void sent();                         ///< What has been heard before is no answer.
    void heard(const QByteArray& bytes); ///< All bytes received since the last time, whoever sent them.
    /// `matched`: what has been heard holds an answer of the unit asked, with the function asked for and a
    /// good CRC. Not more than that. Otherwise time is up.
    void ended(bool matched);
    void lost(const QString& detail); ///< The port is gone; the line is closed.
};

} // namespace lds::modbus
