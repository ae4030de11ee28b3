#pragma once

#include "connection.h"
#include "frame_reader.h"

#include <optional>
#include <QModbusTcpClient>
#include <QPointer>
#include <QTcpSocket>

namespace lds::modbus {

/// One TCP connection that carries one request at a time, on QModbusTcpClient.
///
/// QModbus takes a message's header at its word and its PDU beyond the header's length; a half-received
/// answer stops its timer for good. So it is asked for the connection, the transaction numbers and the
/// sending, while what comes in is looked at a second time: an answer counts only when QModbus matched it
/// to the request *and* its bytes are one well-formed message that answers the request. When the stream
/// cannot be trusted any more the connection is dropped and lost() says so.
///
/// An answer that comes after its timeout is thrown away, whatever is under way then: the transaction
/// number tells.
class TcpConnection final : public Connection {
    Q_OBJECT

public:
    TcpConnection(const ports::ConnectionUrl& url, ports::Scheduler& scheduler, FrameRecorder& recorder);
    ~TcpConnection() override; ///< Closes; no signal, no Ended.

    static ConnectionMaker maker();

    void open(int timeoutMs) override;
    void close(const QString& reason) override;
    bool isOpen() const override { return m_state == State::Open; }
    /// The turn means nothing: whatever waits, waits in the link.
    void send(const Request& request, Turn turn, int timeoutMs, const Ended& ended) override;
    bool isBusy(Turn) const override { return m_exchange.has_value(); }

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
