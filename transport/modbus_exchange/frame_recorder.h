#pragma once

#include "connection_url.h"
#include "frame.h"
#include "item_registers.h"
#include "modbus_pdu.h"
#include "scheduler.h"

namespace lds::modbus {

/// Puts what one connection sends and receives into the frame log, with its meaning (ports::FrameMeaning).
///
/// What is received was seen whole. QModbus does not show what it sends: the bytes in front of a sent
/// message's PDU may be rebuilt, and the frame then says so. Values are told as "key=value" in the units of
/// the wire.
class FrameRecorder {
public:
    FrameRecorder(ports::FrameLog& log, const ports::Scheduler& clock, const ports::ConnectionUrl& url);

    /// Known after the probe; until then values are told as if low word first.
    void setLowWordFirst(bool lowWordFirst) { m_lowWordFirst = lowWordFirst; }

    void connecting();
    void connected();
    void disconnected(const QString& reason);
    /// `bytes` as they go over the wire, of which so many in front are rebuilt.
    void sent(const Request& request, const QByteArray& bytes, int reconstructedPrefix = 0);
    void answered(const Request& request, const Response& response, const QByteArray& bytes,
                  qint64 roundTripNs);
    void refused(const Request& request, quint8 exceptionCode, const QByteArray& bytes, qint64 roundTripNs);
    /// `what` is a stable word: "short", "length", "function", "echo", "unit", "transaction", "header",
    /// and on a serial line "noise", "late", "trailing".
    void malformed(const QString& what, const QByteArray& bytes, qint64 roundTripNs = -1);
    void noAnswer(qint64 waitedNs);

private:
    void record(ports::Direction direction, ports::FrameMeaning meaning, const QStringList& arguments,
                const QByteArray& bytes = {}, qint64 roundTripNs = -1, int reconstructedPrefix = 0);
    QStringList range(const Request& request) const;
    QString values(const Request& request, const QList<quint16>& registers) const;

    ports::FrameLog& m_log;
    const ports::Scheduler& m_clock;
    const QString m_host;
    const QString m_port; ///< TCP port, or the settings of a serial line.
    const QString m_protocol;
    const QString m_peer;
    bool m_lowWordFirst = true;
};

} // namespace lds::modbus
