#pragma once

#include "frame_reader.h"
#include "frame_recorder.h"
#include "modbus_pdu.h"
#include "scheduler.h"
#include "sensor_link.h"

#include <functional>
#include <optional>
#include <QModbusTcpClient>
#include <QPointer>
#include <QTcpSocket>
#include <tl/expected.hpp>

namespace lds::modbus {

/// One TCP connection that carries one request at a time, on QModbusTcpClient.
///
/// QModbus takes a message's header at its word and its PDU beyond the header's length; a half-received
/// answer stops its timer for good. So it is asked for the connection, the transaction numbers and the
/// sending, while what comes in is looked at a second time: an answer counts only when QModbus matched it
/// to the request *and* its bytes are one well-formed message that answers the request. When the stream
/// cannot be trusted any more the connection is dropped and lost() says so.
///
/// Everything happens in the thread that calls open().
class TcpConnection final : public QObject {
    Q_OBJECT

public:
    struct Exchange {
        tl::expected<Response, ports::Failure> result;
        qint64 endedNs = 0; ///< When the answer arrived, or when it was given up.
        qint64 endedWallMs = 0;
    };
    using Ended = std::function<void(const Exchange&)>;

    TcpConnection(const ports::ConnectionUrl& url, ports::Scheduler& scheduler, FrameRecorder& recorder);
    ~TcpConnection() override; ///< Closes; no signal, no Ended.

    void open(int timeoutMs); ///< Then opened() or failed(), once.
    /// Silent: no signal, no Ended. Does nothing when closed. `reason` is for the frame log.
    void close(const QString& reason = QStringLiteral("closed"));
    bool isOpen() const { return m_state == State::Open; }

    /// When open and not busy. `ended` is called exactly once unless close() comes first. Nothing is ever
    /// repeated. An answer that comes after `timeoutMs` is thrown away, whatever is under way then.
    void send(const Request& request, int timeoutMs, const Ended& ended);
    bool isBusy() const { return m_exchange.has_value(); }

Q_SIGNALS:
    void opened();
    void failed(lds::ports::OpenFailure failure, const QString& detail);
    void lost(const QString& detail); ///< Once, after opened(); the request under way has ended before.

private:
    enum class State { Closed, Opening, Open };
    struct Pending {
        Request request;
        Ended ended;
        quint16 transaction = 0;
        qint64 sentNs = 0;
        ports::Scheduler::TimerId timeout = 0;
    };

    void onStateChanged(QModbusDevice::State state);
    void onConnected();
    void onDisconnected();
    void failOpening(ports::OpenFailure failure, const QString& detail);
    void onReadyRead();
    QByteArray takeWhatQModbusRead();
    void handle(const ReceivedFrame& frame);
    void onTimeout();
    void end(tl::expected<Response, ports::Failure> result);
    void stamp();
    void drop(const QString& reason, const ports::Failure& failure);
    void release(const QString& reason);
    QTcpSocket* socket() const;

    const ports::ConnectionUrl m_url;
    ports::Scheduler& m_scheduler;
    FrameRecorder& m_recorder;
    QModbusTcpClient* m_client =
        nullptr; ///< A new one for each connection: its buffer and numbers start afresh.
    QPointer<QModbusReply> m_reply;
    FrameReader m_reader;
    std::optional<Pending> m_exchange;
    ports::Scheduler::TimerId m_openTimeout = 0;
    State m_state = State::Closed;
    qint64 m_stampNs = 0; ///< When what is being handled arrived or fell due.
    qint64 m_stampWallMs = 0;
    quint16 m_nextTransaction = 0; ///< QModbus counts from 0 and wraps, one for each message sent.
};

} // namespace lds::modbus
