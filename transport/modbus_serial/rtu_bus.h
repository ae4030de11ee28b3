#pragma once

#include "bus_queue.h"
#include "connection.h"
#include "rtu_answer.h"
#include "serial_line.h"
#include "unit_record.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace lds::modbus {

/// One open serial port with all that use it: the links of up to 16 sensors (BusMember), and scans. One
/// exchange is on the wire at a time; BusQueue says whose. Lives in the links' thread; get one from
/// RtuBusPool and keep it for as long as the port is to stay open.
///
/// RTU has no transaction number, so a late answer looks like the answer to the next read of the same unit.
/// It is never taken for it: once a unit has been silent, or bytes could not be understood, the unit is
/// doubtful, and before anything else it is asked for its coils (function 01), which is asked for nowhere
/// else. A sensor answers in order, so the answer proves that nothing older is under way.
/// docs/architecture.md ("A line without transaction numbers") has the reasoning.
///
/// For a scan, listen() asks with the settings it wants, whatever the links use, and gives the raw bytes:
///
///     bus->listen({encodeRtuFrame(unit, pdu), settings, windowMs, silenceMs, [](const Heard& heard) { … }});
///
/// It takes its turn with the slow walk, one listen() at a time between the exchanges of the links, and the
/// links' settings are back before their next exchange.
class RtuBus final : public QObject {
    Q_OBJECT

public:
    using Heard = tl::expected<QByteArray, PortFailure>;

    struct Question {
        quint8 unit = 1;
        Turn turn = Turn::Poll;
        Request request;
        int answeringMs = 0; ///< The sensor's time until it begins to answer; the line's own is added.
        FrameRecorder* recorder = nullptr; ///< Until leave().
        Connection::Ended ended;           ///< Once, unless withdrawn or forgotten.
    };
    struct Listening {
        QByteArray frame; ///< As it goes over the wire, CRC included; empty to listen only.
        ports::SerialSettings settings;
        int windowMs = 0; ///< For the first byte, from the end of the request on the line.
        /// Without a byte, after which the answer has ended. Take an adapter's 16 ms into account.
        int silenceMs = 0;
        std::function<void(const Heard&)> ended; ///< Once, unless forgotten. At most a few frames.
    };

    RtuBus(std::unique_ptr<ports::Scheduler> scheduler, std::unique_ptr<SerialLine> line);
    ~RtuBus() override; ///< Closes; nobody is told.

    tl::expected<void, PortFailure> open(const QString& port, const ports::SerialSettings& settings);
    void close(); ///< Silent; the port is free afterwards.
    bool isOpen() const { return m_open; }
    const ports::SerialSettings& settings() const { return m_settings; } ///< Of the links.

    Ticket ask(const Question& question); ///< When open.
    Ticket listen(const Listening& listening);
    bool withdraw(Ticket ticket); ///< Whether it had not begun; then it has not been and will not be sent.
    void hurry(Ticket ticket, Turn turn);
    /// Nobody will be told how it ends. What is on the wire runs its course.
    void forget(Ticket ticket);
    /// Before a recorder that was in a question dies.
    void leave(const FrameRecorder& recorder);

Q_SIGNALS:
    /// The port is gone and closed; every exchange has ended before.
    void lost(lds::ports::OpenFailure failure, const QString& detail);

private:
    enum class State : quint8 {
        Idle,
        AskingCoils, ///< In front of a question to a doubtful unit.
        Asking,
        BeforeListening,
        Listening,
        Settling, ///< Waiting until nobody speaks.
    };
    struct Job {
        Ticket ticket = 0;
        std::optional<Question> question;
        std::optional<Listening> listening;
    };

    Ticket add(Job job, quint8 unit, Turn turn);
    void pump();
    void begin(Job job);
    void waitForPause();

    void askCoils();
    void askData();
    void send(const Request& request);
    void onHeard(const QByteArray& bytes);
    void onSent();
    void unasked(const QByteArray& bytes);
    void onEnded(bool matched);
    void onCoilsEnded(bool matched);
    void onDataEnded(bool matched);
    void record(const QList<RtuStray>& strays);
    void giveUp(const ports::Failure& failure);
    void tell(const Job& job, const tl::expected<Response, ports::Failure>& result);

    void beginListening();
    void sendListening();
    void waitForSilence();
    void onSilence();
    void finishListening(const Heard& heard);

    void goOn();
    void waitUntilQuiet();
    bool adopt(const ports::SerialSettings& settings, QString* detail);
    void onLost(const QString& detail);
    void stamp();
    void startTimer(qint64 delayNs, void (RtuBus::*callback)());

    std::unique_ptr<ports::Scheduler> m_scheduler;
    std::unique_ptr<SerialLine> m_line;
    bool m_open = false;
    ports::SerialSettings m_settings;
    ports::SerialSettings m_lineSettings; ///< What the port has now; differs for the time of a listen().
    BusQueue m_queue;
    UnitRecord m_units;
    std::map<Ticket, Job> m_jobs; ///< Waiting.
    Job m_current;                ///< Under way; without question and listening when forgotten or none.
    State m_state = State::Idle;
    QByteArray m_heard; ///< Since the request under way went out.
    Request m_sent;     ///< The request on the wire.
    int m_currentUnit = 0;
    FrameRecorder* m_lastRecorder = nullptr; ///< For what comes unasked.
    qint64 m_sentNs = 0;
    qint64 m_lastHeardNs = 0;
    qint64 m_settlingEndsNs = 0;
    qint64 m_stampNs = 0;
    qint64 m_stampWallMs = 0;
    ports::Scheduler::TimerId m_timer = 0; ///< Of the state.
    ports::Scheduler::TimerId m_pauseTimer = 0;
    Ticket m_nextTicket = 1;
};

} // namespace lds::modbus
