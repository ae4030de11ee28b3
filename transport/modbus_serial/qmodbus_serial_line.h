#pragma once

#include "scheduler.h"
#include "serial_line.h"

#include <optional>
#include <QModbusReply>
#include <QModbusRtuSerialClient>
#include <QPointer>
#include <QSerialPort>
#include <QTimer>

namespace lds::modbus {

/// A serial port on QModbusRtuSerialClient, which keeps the silence in front of a request (never less than
/// 2 ms), knows when an answer is complete and checks its CRC, unit and function. It tells neither what it
/// drops nor what stands around an answer, so every byte is looked at a second time. It also takes what comes
/// during the silence in front of a request for the answer to it, and then does not even send it: such an
/// end is told as one without an answer.
///
/// Its timer for the answer is real time, as it is the only thing that makes it free for the next request;
/// the scheduler watches over the port taking the bytes at all.
class QModbusSerialLine final : public SerialLine {
    Q_OBJECT

public:
    explicit QModbusSerialLine(ports::Scheduler& scheduler);
    ~QModbusSerialLine() override;

    tl::expected<void, PortFailure> open(const QString& port, const ports::SerialSettings& settings) override;
    void close() override;
    tl::expected<void, QString> adopt(const ports::SerialSettings& settings) override;
    void ask(quint8 unit, const QByteArray& pdu, int timeoutMs) override;
    void write(const QByteArray& bytes) override;

private:
    tl::expected<void, PortFailure> tryOpen(const QString& port, const ports::SerialSettings& settings,
                                            QSerialPort::Parity parity);
    void onReadyRead();
    QByteArray takeWhatQModbusRead();
    void onReplyFinished();
    void onPortError(QSerialPort::SerialPortError error);
    void lose(const QString& detail);
    void endReply();
    void release();
    QSerialPort* port() const;

    ports::Scheduler& m_scheduler;
    QModbusRtuSerialClient* m_client = nullptr; ///< A new one for each opening; none when closed.
    QPointer<QModbusReply> m_reply;
    bool m_asking = false;
    QTimer m_silence; ///< In front of a request; QModbus sends when its own of the same length ends.
    bool m_isPseudoTerminal = false;
    ports::Scheduler::TimerId m_stuckTimer = 0;
};

} // namespace lds::modbus
