#include "scripted_server.h"

#include <algorithm>
#include <QTimer>

namespace lds::tests {

namespace {

QByteArray word(int value)
{
    QByteArray bytes;
    bytes.append(char(value >> 8));
    bytes.append(char(value & 0xff));
    return bytes;
}

} // namespace

ScriptedServer::ScriptedServer()
{
    m_server.listen(QHostAddress::LocalHost);
    connect(&m_server, &QTcpServer::newConnection, this, [this] {
        m_socket = m_server.nextPendingConnection();
        m_buffer.clear();
        ++connections;
        connect(m_socket, &QTcpSocket::readyRead, this, &ScriptedServer::onReadyRead);
        connect(m_socket, &QTcpSocket::disconnected, m_socket, &QObject::deleteLater);
    });
}

void ScriptedServer::onReadyRead()
{
    if (sender() != m_socket)
        return;
    m_buffer += m_socket->readAll();
    while (m_buffer.size() >= 7) {
        const int length = quint8(m_buffer.at(4)) << 8 | quint8(m_buffer.at(5));
        if (m_buffer.size() < 6 + length)
            return;
        Received request;
        request.transaction = quint16(quint8(m_buffer.at(0)) << 8 | quint8(m_buffer.at(1)));
        request.unit = quint8(m_buffer.at(6));
        request.pdu = m_buffer.mid(7, length - 1);
        m_buffer.remove(0, 6 + length);
        received.append(request);
        if (!m_scripts.isEmpty())
            m_scripts.dequeue()(request);
        else if (m_always)
            m_always(request);
        else
            send(goodFrame(request));
    }
}

QByteArray ScriptedServer::goodPdu(const Received& request)
{
    QByteArray pdu = request.pdu.first(1);
    if (request.function() == 0x03) {
        pdu.append(char(2 * request.count()));
        for (int i = 0; i < request.count(); ++i)
            pdu += word(registers.value(request.first() + i));
        return pdu;
    }
    if (request.function() == 0x06) {
        registers[request.first()] = quint16(request.word(3));
        return request.pdu;
    }
    for (int i = 0; i < request.count(); ++i)
        registers[request.first() + i] = quint16(request.word(6 + 2 * i));
    return request.pdu.first(5);
}

QByteArray ScriptedServer::goodFrame(const Received& request)
{
    return frame(request.transaction, request.unit, goodPdu(request));
}

QByteArray ScriptedServer::frame(quint16 transaction, quint8 unit, const QByteArray& pdu, int protocol,
                                 int length)
{
    QByteArray bytes = word(transaction) + word(protocol) + word(length < 0 ? int(pdu.size()) + 1 : length);
    bytes.append(char(unit));
    return bytes + pdu;
}

void ScriptedServer::answer(const Received& request, const QByteArray& pdu)
{
    send(frame(request.transaction, request.unit, pdu));
}

void ScriptedServer::refuse(const Received& request, int exceptionCode)
{
    QByteArray pdu;
    pdu.append(char(request.function() | 0x80));
    pdu.append(char(exceptionCode));
    answer(request, pdu);
}

void ScriptedServer::send(const QByteArray& bytes)
{
    if (!m_socket || m_socket->state() != QAbstractSocket::ConnectedState)
        return;
    m_socket->write(bytes);
    m_socket->flush();
}

void ScriptedServer::sendByteByByte(const QByteArray& bytes)
{
    if (bytes.isEmpty())
        return;
    send(bytes.first(1));
    QTimer::singleShot(0, this, [this, rest = bytes.sliced(1)] { sendByteByByte(rest); });
}

void ScriptedServer::cut()
{
    if (m_socket)
        m_socket->disconnectFromHost();
}

int ScriptedServer::writes() const
{
    return int(std::ranges::count_if(received, [](const Received& request) { return request.isWrite(); }));
}

} // namespace lds::tests
