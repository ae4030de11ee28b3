#include "qmodbus_serial_line.h"

#include "serial_timing.h"

#include <QFileInfo>
#include <QSerialPortInfo>

namespace lds::modbus {

using ports::OpenFailure;
using ports::SerialParity;

namespace {

/// For a port to take the bytes of a request, beyond the time for its answer.
constexpr int stuckMs = 2000;

QSerialPort::Parity parityOf(SerialParity parity)
{
    switch (parity) {
    case SerialParity::None:
        return QSerialPort::NoParity;
    case SerialParity::Even:
        return QSerialPort::EvenParity;
    case SerialParity::Odd:
        break;
    }
    return QSerialPort::OddParity;
}

QSerialPort::StopBits stopBitsOf(const ports::SerialSettings& settings)
{
    return settings.stopBits() == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop;
}

/// A file the person may not use, as opposed to one that somebody else uses. Where ports are no files only
/// the latter happens.
bool isForbidden(const QString& port)
{
    const QFileInfo file(QSerialPortInfo(port).isNull() ? port : QSerialPortInfo(port).systemLocation());
    return file.exists() && !(file.isReadable() && file.isWritable());
}

PortFailure failureOf(QSerialPort::SerialPortError error, const QString& port, const QString& detail)
{
    switch (error) {
    case QSerialPort::DeviceNotFoundError:
        return {OpenFailure::NoSuchPort, detail};
    case QSerialPort::PermissionError:
        return {isForbidden(port) ? OpenFailure::PortNotPermitted : OpenFailure::PortBusy, detail};
    default:
        return {OpenFailure::PortUnusable, detail};
    }
}

} // namespace

QModbusSerialLine::QModbusSerialLine(ports::Scheduler& scheduler)
    : m_scheduler(scheduler)
{
    m_silence.setSingleShot(true);
    m_silence.setTimerType(Qt::PreciseTimer);
    connect(&m_silence, &QTimer::timeout, this, &SerialLine::sent);
}

QModbusSerialLine::~QModbusSerialLine() { QModbusSerialLine::close(); }

tl::expected<void, PortFailure> QModbusSerialLine::open(const QString& port,
                                                        const ports::SerialSettings& settings)
{
    Q_ASSERT(!m_client);
    m_isPseudoTerminal = QFileInfo(port).canonicalFilePath().startsWith(QLatin1StringView("/dev/pts/"));
    const QSerialPort::Parity parity = parityOf(settings.parity);
    auto opened = tryOpen(port, settings, parity);
    // A pseudo-terminal has no parity. The C library says so only when nothing else changes: then it is
    // opened without, which makes no difference to the bytes.
    if (!opened && m_isPseudoTerminal && opened.error().failure == OpenFailure::PortUnusable &&
        parity != QSerialPort::NoParity)
        opened = tryOpen(port, settings, QSerialPort::NoParity);
    return opened;
}

tl::expected<void, PortFailure> QModbusSerialLine::tryOpen(const QString& name,
                                                           const ports::SerialSettings& settings,
                                                           QSerialPort::Parity parity)
{
    m_client = new QModbusRtuSerialClient(this);
    m_client->setNumberOfRetries(0); // A repeated "teach this point" is a wrong window.
    m_client->setConnectionParameter(QModbusDevice::SerialPortNameParameter, name);
    m_client->setConnectionParameter(QModbusDevice::SerialBaudRateParameter, settings.baud);
    m_client->setConnectionParameter(QModbusDevice::SerialDataBitsParameter, QSerialPort::Data8);
    m_client->setConnectionParameter(QModbusDevice::SerialParityParameter, parity);
    m_client->setConnectionParameter(QModbusDevice::SerialStopBitsParameter, stopBitsOf(settings));
    if (!m_client->connectDevice()) {
        const PortFailure failure = failureOf(port()->error(), name, port()->errorString());
        release();
        return tl::unexpected(failure);
    }
    // Connected after QModbus's own slot, so it runs after it: what that slot read and matched is there.
    connect(port(), &QIODevice::readyRead, this, &QModbusSerialLine::onReadyRead);
    connect(port(), &QSerialPort::errorOccurred, this, &QModbusSerialLine::onPortError);
    port()->startTransaction(); // See takeWhatQModbusRead().
    return {};
}

void QModbusSerialLine::close()
{
    if (m_client)
        release();
}

tl::expected<void, QString> QModbusSerialLine::adopt(const ports::SerialSettings& settings)
{
    const qint64 silenceUs = frameSilenceNs(rateOf(settings)) / 1000;
    m_client->setInterFrameDelay(int(silenceUs));
    const bool adopted = port()->setBaudRate(settings.baud) && port()->setStopBits(stopBitsOf(settings)) &&
                         (port()->setParity(parityOf(settings.parity)) || m_isPseudoTerminal);
    if (!adopted)
        return tl::unexpected(port()->errorString());
    return {};
}

void QModbusSerialLine::ask(quint8 unit, const QByteArray& pdu, int timeoutMs)
{
    Q_ASSERT(m_client && !m_asking);
    m_asking = true;
    m_client->setTimeout(timeoutMs);
    const QModbusRequest request(QModbusPdu::FunctionCode(quint8(pdu.at(0))), pdu.sliced(1));
    m_reply = m_client->sendRawRequest(request, unit);
    if (!m_reply) {
        const QString detail = m_client->errorString();
        QMetaObject::invokeMethod(
            m_client, [this, detail] { lose(detail); }, Qt::QueuedConnection);
        return;
    }
    connect(m_reply, &QModbusReply::finished, this, &QModbusSerialLine::onReplyFinished);
    m_silence.start(m_client->interFrameDelay() / 1000); // After QModbus's, so it ends after it.
    m_stuckTimer = m_scheduler.after(timeoutMs + stuckMs, this,
                                     [this] { lose(QStringLiteral("the port does not send")); });
}

void QModbusSerialLine::write(const QByteArray& bytes)
{
    port()->clear(QSerialPort::Input); // As QModbus does in front of a request.
    port()->write(bytes);
}

void QModbusSerialLine::onReadyRead()
{
    const QByteArray bytes = takeWhatQModbusRead();
    const QPointer<QModbusRtuSerialClient> client = m_client;
    if (!bytes.isEmpty())
        Q_EMIT heard(bytes);
    if (!client || client != m_client || !m_asking || !m_reply || !m_reply->isFinished())
        return;
    const bool wasSent = !m_silence.isActive();
    endReply();
    Q_EMIT ended(wasSent);
}

/// The bytes QModbus has just read, taken a second time. Every read on the port is part of a transaction of
/// QIODevice, which keeps the bytes until it is rolled back.
QByteArray QModbusSerialLine::takeWhatQModbusRead()
{
    QSerialPort* const device = port();
    const qint64 unread = device->bytesAvailable();
    device->rollbackTransaction();
    const QByteArray bytes = device->read(device->bytesAvailable() - unread);
    device->startTransaction();
    return bytes;
}

/// An answer is told when its bytes have been, see onReadyRead(); here only the end of the waiting counts.
void QModbusSerialLine::onReplyFinished()
{
    if (!m_asking || !m_reply || m_reply->error() != QModbusDevice::TimeoutError)
        return;
    endReply();
    Q_EMIT ended(false);
}

/// QModbus stays connected to a port that is gone, and never gives up waiting for it.
void QModbusSerialLine::onPortError(QSerialPort::SerialPortError error)
{
    switch (error) {
    case QSerialPort::NoError:
    case QSerialPort::TimeoutError:
    case QSerialPort::UnsupportedOperationError: // adopt() has told.
        return;
    default:
        break;
    }
    const QString detail = port()->errorString();
    disconnect(port(), &QSerialPort::errorOccurred, this, nullptr); // It may not stop saying so.
    // Not in the middle of the port's own work.
    QMetaObject::invokeMethod(
        m_client, [this, detail] { lose(detail); }, Qt::QueuedConnection);
}

void QModbusSerialLine::lose(const QString& detail)
{
    release();
    Q_EMIT lost(detail);
}

/// QModbus keeps the replies it is not rid of, and finishes them again when the port closes.
void QModbusSerialLine::endReply()
{
    m_scheduler.cancel(std::exchange(m_stuckTimer, 0));
    m_asking = false;
    m_silence.stop();
    if (m_reply) {
        m_reply->disconnect(this);
        m_reply->deleteLater(); // This may be one of its signals.
        m_reply = nullptr;
    }
}

void QModbusSerialLine::release()
{
    endReply();
    m_client->disconnect(this);
    port()->disconnect(this);
    if (port()->isTransactionStarted())
        port()->commitTransaction();
    m_client->disconnectDevice();
    m_client->deleteLater(); // Often in the middle of one of its signals.
    m_client = nullptr;
}

QSerialPort* QModbusSerialLine::port() const { return qobject_cast<QSerialPort*>(m_client->device()); }

} // namespace lds::modbus
