#include "modbus_connection.h"

#include <QTcpSocket>

namespace lds::emulator {

ModbusConnection::ModbusConnection(QTcpSocket* socket, EmulatorClock& clock, QObject* parent)
    : QObject(parent)
    , m_socket(socket)
    , m_clock(clock)
{
    m_socket->setParent(this);
    m_socket->setReadBufferSize(readBufferSize);
    m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(m_socket, &QTcpSocket::readyRead, this, &ModbusConnection::readArrived);
    connect(m_socket, &QTcpSocket::disconnected, this, &ModbusConnection::closed);
}

ModbusConnection::~ModbusConnection() { m_socket->disconnect(this); }

void ModbusConnection::readArrived()
{
    const QByteArray bytes = m_socket->readAll();
    if (m_closing || m_lastAnswers || bytes.isEmpty())
        return;
    QList<QByteArray> messages;
    const auto state = m_buffer.feed(bytes, messages);
    if (state == ModbusMessageBuffer::State::Overlong) {
        close();
        return;
    }
    waitForRest(state == ModbusMessageBuffer::State::Waiting);
    Q_EMIT bytesReceived(bytes.size());
    for (const QByteArray& message : std::as_const(messages)) {
        if (m_closing || m_lastAnswers)
            return;
        Q_EMIT messageReceived(message);
    }
}

void ModbusConnection::waitForRest(bool waiting)
{
    m_clock.cancel(m_gapTimer);
    m_gapTimer = 0;
    if (waiting)
        m_gapTimer = m_clock.after(idleGapMs, this, [this] { m_buffer.discard(); });
}

void ModbusConnection::send(const QByteArray& answer, int delayMs)
{
    if (m_closing)
        return;
    m_pending.enqueue({answer, m_clock.nowNs() + delayMs * 1'000'000LL});
    m_pendingBytes += answer.size();
    if (m_pendingBytes + m_socket->bytesToWrite() > largestBacklog) {
        abort(); // does not take its answers: nothing more to be sent
        return;
    }
    if (m_sendTimer == 0)
        sendDue();
}

void ModbusConnection::sendDue()
{
    m_sendTimer = 0;
    while (!m_pending.isEmpty() && m_pending.head().dueNs <= m_clock.nowNs()) {
        const QByteArray answer = m_pending.dequeue().answer;
        m_pendingBytes -= answer.size();
        m_socket->write(answer);
    }
    if (m_pending.isEmpty()) {
        if (m_lastAnswers)
            close();
        return;
    }
    const qint64 leftNs = m_pending.head().dueNs - m_clock.nowNs();
    m_sendTimer = m_clock.after(int((leftNs + 999'999) / 1'000'000), this, [this] { sendDue(); });
}

void ModbusConnection::close()
{
    m_closing = true;
    m_pending.clear();
    m_pendingBytes = 0;
    m_socket->disconnectFromHost();
}

void ModbusConnection::closeAfterAnswers()
{
    m_lastAnswers = true;
    // Later: a request may be being carried out right now, its answer still to come.
    const auto closeWhenAnswered = [this] {
        if (m_pending.isEmpty() && !m_closing)
            close();
    };
    QMetaObject::invokeMethod(this, closeWhenAnswered, Qt::QueuedConnection);
}

void ModbusConnection::abort()
{
    m_closing = true;
    m_pending.clear();
    m_pendingBytes = 0;
    m_socket->abort();
}

} // namespace lds::emulator
