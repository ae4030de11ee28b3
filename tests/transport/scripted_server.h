#pragma once

#include <functional>
#include <QByteArray>
#include <QList>
#include <QMap>
#include <QPointer>
#include <QQueue>
#include <QTcpServer>
#include <QTcpSocket>

namespace lds::tests {

/// A Modbus TCP server on loopback that does what a test tells it, byte by byte. It knows nothing of the
/// product's codec: its bytes are made by hand, so that a misreading does not agree with itself.
class ScriptedServer final : public QObject {
    Q_OBJECT

public:
    struct Received {
        quint16 transaction = 0;
        quint8 unit = 0;
        QByteArray pdu;
        int function() const { return quint8(pdu.at(0)); }
        int first() const { return 400001 + word(1); } ///< As the manual prints it.
        int count() const { return word(3); }
        int word(int index) const { return quint8(pdu.at(index)) << 8 | quint8(pdu.at(index + 1)); }
        bool isWrite() const { return function() == 0x06 || function() == 0x10; }
    };
    using Script = std::function<void(const Received&)>;

    ScriptedServer();

    quint16 port() const { return m_server.serverPort(); }
    /// By printed number; the others read as 0. A start: Span 1.0000, low word first.
    QMap<int, quint16> registers{{400116, 10000}, {400117, 0}};

    void next(const Script& script) { m_scripts.enqueue(script); } ///< For the next request without a script.
    void always(const Script& script) { m_always = script; }       ///< For all requests beyond those.
    void answerWell() { m_always = {}; }                           ///< The start: as a sensor does.

    void answer(const Received& request, const QByteArray& pdu); ///< With the right header.
    void refuse(const Received& request, int exceptionCode);
    QByteArray goodPdu(const Received& request); ///< And does what a write asks.
    QByteArray goodFrame(const Received& request);
    static QByteArray frame(quint16 transaction, quint8 unit, const QByteArray& pdu, int protocol = 0,
                            int length = -1);
    void send(const QByteArray& bytes);
    void sendByteByByte(const QByteArray& bytes); ///< One more each time the event loop comes round.
    void cut();
    void stopListening() { m_server.close(); }

    QList<Received> received;
    int connections = 0; ///< That were ever made.
    int openConnections() const { return m_socket ? 1 : 0; }
    int writes() const;

private:
    void onReadyRead();

    QTcpServer m_server;
    QPointer<QTcpSocket> m_socket;
    QByteArray m_buffer;
    QQueue<Script> m_scripts;
    Script m_always;
};

inline const ScriptedServer::Script silence = [](const ScriptedServer::Received&) {};

} // namespace lds::tests
