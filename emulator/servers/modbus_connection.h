#pragma once

#include "emulator_clock.h"
#include "modbus_message_buffer.h"

#include <functional>
#include <QObject>
#include <QQueue>

class QTcpSocket;

namespace lds::emulator {

/// One client of a Modbus TCP server: takes its bytes apart, hands the messages on, and sends the answers
/// in their order. Memory per client is bounded: by one read buffer, and by the answers it does not take.
class ModbusConnection : public QObject {
    Q_OBJECT

public:
    static constexpr int idleGapMs = 100; ///< A pause that ends a message that does not add up.
    static constexpr qint64 readBufferSize = 64 * 1024;
    static constexpr qint64 largestBacklog = 64 * 1024; ///< Bytes of answers not yet taken by the client.

    /// Takes the socket over.
    ModbusConnection(QTcpSocket* socket, EmulatorClock& clock, QObject* parent);
    ~ModbusConnection() override;

    /// Sends after `delayMs`, but never before an answer queued earlier.
    void send(const QByteArray& answer, int delayMs);
    void close(); ///< What has been sent before still goes out.
    /// Takes no more requests, and closes when the answers under way have been sent.
    void closeAfterAnswers();
    void abort(); ///< At once, as when the power goes.

Q_SIGNALS:
    void bytesReceived(qint64 count);
    void messageReceived(const QByteArray& message);
    void closed();

private:
    struct Pending {
        QByteArray answer;
        qint64 dueNs;
    };

    void readArrived();
    void waitForRest(bool waiting);
    void sendDue();

    QTcpSocket* m_socket;
    EmulatorClock& m_clock;
    ModbusMessageBuffer m_buffer;
    EmulatorClock::TimerId m_gapTimer = 0;
    EmulatorClock::TimerId m_sendTimer = 0;
    QQueue<Pending> m_pending;
    qint64 m_pendingBytes = 0;
    bool m_closing = false;
    bool m_lastAnswers = false; ///< No more requests are taken.
};

} // namespace lds::emulator
