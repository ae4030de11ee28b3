#include "tcp_connection.h"

#include "answer_failure.h"
#include "modbus_tcp_framing.h"

#include <QModbusReply>
#include <QNetworkProxy>

namespace lds::modbus {

namespace {

using ports::Failure;
using ports::FailureCode;
using ports::OpenFailure;

/// Long beyond every timeout of ours, which runs on the injected clock.
constexpr int qmodbusTimeoutMs = 24 * 60 * 60 * 1000;

OpenFailure openFailureOf(QAbstractSocket::SocketError error)
{
    switch (error) {
    case QAbstractSocket::HostNotFoundError:
    case QAbstractSocket::UnknownSocketError: // The socket was not even asked: QModbus found no host in the
                                              // name.
        return OpenFailure::HostNotFound;
    case QAbstractSocket::ConnectionRefusedError:
        return OpenFailure::Refused;
    default:
        return OpenFailure::NoAnswer; // No route, no network: nobody answers.
    }
}

} // namespace

TcpConnection::TcpConnection(const ports::ConnectionUrl& url, ports::Scheduler& scheduler,
                             FrameRecorder& recorder)
    : m_url(url)
    , m_scheduler(scheduler)
    , m_recorder(recorder)
{}

TcpConnection::~TcpConnection() { TcpConnection::close(QStringLiteral("closed")); }

ConnectionMaker TcpConnection::maker()
{
    return [](const ports::ConnectionUrl& url, ports::Scheduler& scheduler, FrameRecorder& recorder) {
        return std::make_unique<TcpConnection>(url, scheduler, recorder);
    };
}

void TcpConnection::open(int timeoutMs)
{
    Q_ASSERT(m_state == State::Closed);
    m_state = State::Opening;
    m_nextTransaction = 0;
    m_reader.clear();
    m_client = new QModbusTcpClient(this);
    m_client->setNumberOfRetries(0); // A repeated "teach this point" is a wrong window.
    m_client->setTimeout(qmodbusTimeoutMs);
    const bool bare6 = m_url.host.contains(QLatin1Char(':'));
    m_client->setConnectionParameter(QModbusDevice::NetworkAddressParameter,
                                     bare6 ? QLatin1Char('[') + m_url.host + QLatin1Char(']') : m_url.host);
    m_client->setConnectionParameter(QModbusDevice::NetworkPortParameter, m_url.port);
    socket()->setProxy(QNetworkProxy::NoProxy); // A sensor is on the machine's network, never behind a proxy.
    connect(m_client, &QModbusDevice::stateChanged, this, &TcpConnection::onStateChanged);
    // Connected after QModbus's own slot, so it runs after it: what that slot read and matched is there.
    connect(socket(), &QIODevice::readyRead, this, &TcpConnection::onReadyRead);

    m_recorder.connecting();
    m_openTimeout = m_scheduler.after(timeoutMs, this, [this, timeoutMs] {
        failOpening(OpenFailure::NoAnswer, QStringLiteral("no connection within %1 ms").arg(timeoutMs));
    });
    m_client->connectDevice(); // Every failure, at once or later, comes as a change of state.
}

void TcpConnection::close(const QString& reason)
{
    if (m_state == State::Closed)
        return;
    if (m_exchange)
        m_scheduler.cancel(m_exchange->timeout);
    m_exchange.reset();
    release(reason);
}

void TcpConnection::send(const Request& request, Turn, int timeoutMs, const Ended& ended)
{
    Q_ASSERT(isOpen() && !m_exchange);
    m_exchange = Pending{request, ended, m_nextTransaction, m_scheduler.nowNs(), 0};
    const QByteArray pdu = encodeRequest(request);
    const QModbusRequest raw(QModbusPdu::FunctionCode(request.function), pdu.sliced(1));
    m_recorder.sent(request, encodeFrame(m_nextTransaction, m_url.unit, pdu), headerSize);
    m_reply = m_client->sendRawRequest(raw, m_url.unit);
    if (!m_reply) {
        stamp();
        drop(m_client->errorString(), Failure{FailureCode::ConnectionLost, 0, m_client->errorString()});
        return;
    }
    ++m_nextTransaction;
    m_exchange->timeout = m_scheduler.after(timeoutMs, this, [this] { onTimeout(); });
}

void TcpConnection::onStateChanged(QModbusDevice::State state)
{
    if (state == QModbusDevice::ConnectedState)
        onConnected();
    else if (state == QModbusDevice::UnconnectedState)
        onDisconnected();
}

void TcpConnection::onConnected()
{
    m_scheduler.cancel(m_openTimeout);
    m_state = State::Open;
    socket()->startTransaction(); // See takeWhatQModbusRead().
    m_recorder.connected();
    Q_EMIT opened();
}

void TcpConnection::onDisconnected()
{
    const QAbstractSocket::SocketError error = socket()->error();
    const QString words =
        error == QAbstractSocket::UnknownSocketError ? m_client->errorString() : socket()->errorString();
    if (m_state == State::Opening)
        failOpening(openFailureOf(error), words);
    else if (m_state == State::Open) {
        stamp();
        drop(words, Failure{FailureCode::ConnectionLost, 0, words});
    }
}

void TcpConnection::failOpening(OpenFailure failure, const QString& detail)
{
    release(detail);
    Q_EMIT failed(failure, detail);
}

void TcpConnection::onReadyRead()
{
    if (!isOpen())
        return;
    stamp();
    m_reader.append(takeWhatQModbusRead());
    while (isOpen()) {
        const auto frame = m_reader.next();
        if (!frame) {
            const QString what = QStringLiteral("header");
            m_recorder.malformed(what, m_reader.incomplete());
            drop(QStringLiteral("what arrived is not Modbus TCP"), malformed(what));
            return;
        }
        if (!*frame)
            return;
        handle(**frame);
    }
}

/// The bytes QModbus has just read, taken a second time. Every read on the socket is part of a transaction
/// of QIODevice, which keeps the bytes until it is rolled back.
QByteArray TcpConnection::takeWhatQModbusRead()
{
    QTcpSocket* const device = socket();
    const qint64 unread = device->bytesAvailable();
    device->rollbackTransaction();
    const QByteArray bytes = device->read(device->bytesAvailable() - unread);
    device->startTransaction();
    return bytes;
}

void TcpConnection::handle(const ReceivedFrame& frame)
{
    // Late, or sent without being asked for: even an answer to a request that has not gone out yet.
    if (!m_exchange || frame.header.transaction != m_exchange->transaction || !m_reply ||
        !m_reply->isFinished()) {
        m_recorder.malformed(QStringLiteral("transaction"), frame.bytes);
        return;
    }
    const Request& request = m_exchange->request;
    const qint64 roundTripNs = m_stampNs - m_exchange->sentNs;
    if (frame.header.unit != m_url.unit) { // §5.2.3: returned as it was sent
        m_recorder.malformed(QStringLiteral("unit"), frame.bytes, roundTripNs);
        end(tl::unexpected(malformed(QStringLiteral("unit"))));
        return;
    }
    const auto response = decodeResponse(request, frame.pdu());
    if (response) {
        m_recorder.answered(request, *response, frame.bytes, roundTripNs);
        end(*response);
    } else if (response.error().error == ResponseError::Refused) {
        const quint8 code = response.error().exceptionCode;
        m_recorder.refused(request, code, frame.bytes, roundTripNs);
        end(tl::unexpected(Failure{refusalOf(code), code, QString()}));
    } else {
        const QString what = wordOf(response.error().error);
        m_recorder.malformed(what, frame.bytes, roundTripNs);
        end(tl::unexpected(malformed(what)));
    }
}

void TcpConnection::onTimeout()
{
    stamp();
    const qint64 waitedNs = m_stampNs - m_exchange->sentNs;
    if (m_reader.incomplete().isEmpty()) {
        m_recorder.noAnswer(waitedNs);
        const QString detail = QStringLiteral("no answer within %1 ms").arg(waitedNs / 1'000'000);
        end(tl::unexpected(Failure{FailureCode::NoAnswer, 0, detail}));
        return;
    }
    // The rest may come in front of the next answer, or never: whatever follows would be read askew.
    const QString what = QStringLiteral("short");
    m_recorder.malformed(what, m_reader.incomplete(), waitedNs);
    drop(QStringLiteral("an answer was cut short"), malformed(what));
}

void TcpConnection::end(tl::expected<Response, Failure> result)
{
    const Pending exchange = *std::exchange(m_exchange, std::nullopt);
    m_scheduler.cancel(exchange.timeout);
    // At once: QModbus keeps the replies it is not rid of, and finishes them again when the connection
    // closes.
    delete m_reply;
    exchange.ended(Exchange{std::move(result), m_stampNs, m_stampWallMs});
}

/// Taken before anything is decoded or told: a measurement carries this time.
void TcpConnection::stamp()
{
    m_stampNs = m_scheduler.nowNs();
    m_stampWallMs = m_scheduler.wallMs();
}

void TcpConnection::drop(const QString& reason, const Failure& failure)
{
    release(reason);
    if (m_exchange)
        end(tl::unexpected(failure));
    Q_EMIT lost(OpenFailure::Lost, reason);
}

void TcpConnection::release(const QString& reason)
{
    m_state = State::Closed;
    m_scheduler.cancel(m_openTimeout);
    delete m_reply;
    m_client->disconnect(this);
    socket()->disconnect(this);
    m_client->disconnectDevice();
    m_client->deleteLater(); // Often in the middle of one of its signals.
    m_client = nullptr;
    m_recorder.disconnected(reason);
}

QTcpSocket* TcpConnection::socket() const { return qobject_cast<QTcpSocket*>(m_client->device()); }

} // namespace lds::modbus
