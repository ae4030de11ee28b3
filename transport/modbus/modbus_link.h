#pragma once

#include "connection.h"
#include "item_registers.h"
#include "poll_ticker.h"
#include "request_queue.h"
#include "scheduler.h"
#include "sensor_link.h"

#include <memory>
#include <optional>

namespace lds::modbus {

/// An HL-G2 over Modbus, whatever carries it (§5.2, §6.3). See ports::SensorLink for the contract.
///
/// Opening connects and reads Span, which proves the order of the words and that an HL-G2 answers. A read
/// goes out again once when nothing or nonsense comes back; a write never does. A connection on which
/// nothing has answered for Timing::silenceMs is given up, since TCP alone takes minutes to notice a
/// pulled cable.
class ModbusLink final : public ports::SensorLink {
    Q_OBJECT

public:
    struct Timing {
        int connectMs = 2000; ///< For the connection to stand.
        int probeMs = 1000;   ///< For the first read, which is tried twice.
        int requestMs = 500;  ///< For one message, unless the request says otherwise.
        int silenceMs = 5000; ///< Without any answer.
    };

    /// `scheduler` keeps the time of the thread the link will live in. `log` outlives the link.
    ModbusLink(const ports::ConnectionUrl& url, std::unique_ptr<ports::Scheduler> scheduler,
               ports::FrameLog& log, ConnectionMaker maker, const Timing& timing);
    ModbusLink(const ports::ConnectionUrl& url, std::unique_ptr<ports::Scheduler> scheduler,
               ports::FrameLog& log, ConnectionMaker maker);
    ~ModbusLink() override; ///< Closes without a signal.

    bool reaches(catalog::ItemId item) const override;

protected:
    void doOpen() override;
    void doClose() override;
    void doSubmit(const ports::Request& request) override;
    void doPoll(int intervalMs) override;

private:
    using Exchange = Connection::Exchange;
    using NextStep = void (ModbusLink::*)(const Exchange&);

    /// The request that is under way; a read may take several messages.
    struct Active {
        ports::Request request;
        QList<Request> messages;
        qsizetype next = 0;
        bool repeated = false; ///< The message at `next` has been sent twice.
        settings::Values values;
    };

    // --- Opening and closing
    void probe();
    void onProbed(const Exchange& exchange);
    void fail(ports::OpenFailure failure, const QString& detail);
    void report(const ports::LinkReport& report);
    void shutDown(ports::LinkState state, const QString& reason);

    // --- Requests
    void pump();
    void begin(const ports::Request& request);
    void sendMessage();
    void onAnswered(const Exchange& exchange);
    void finish(ports::Status status, const ports::Failure& failure, qint64 finishedNs);
    void finishRefused(const ports::Request& request, const ports::Failure& failure);
    bool isLostInSilence(const Exchange& exchange);

    // --- Polls
    void onTick(quint64 missed);
    void sendPoll();
    void onPolled(const Exchange& exchange);
    void makeUpForPoll();
    void reportPoll(const ports::Failure& failure);
    void flush();

    void exchange(const Request& request, Turn turn, int timeoutMs, NextStep next);

    const ports::ConnectionUrl m_url;
    const Timing m_timing;
    const ConnectionMaker m_maker;
    std::unique_ptr<ports::Scheduler> m_scheduler; ///< Before everything that uses it.
    FrameRecorder m_recorder;
    std::unique_ptr<Connection> m_connection; ///< Made when opening, in the link's thread.
    scheduling::RequestQueue m_queue;
    scheduling::PollTicker m_ticker;
    ports::LinkReport m_report;
    std::optional<Active> m_active;
    bool m_probeRepeated = false;
    qint64 m_lastAnswerNs = 0;
    int m_wantedPollMs = 0;     ///< Asked for while opening.
    bool m_pollOverdue = false; ///< On a shared line: the next has fallen due while one is under way.
    ports::PollStatistics m_statistics;
    ports::FailureCode m_pollRefusal = ports::FailureCode::None;
    measurement::MeasurementBatch m_batch;
};

} // namespace lds::modbus
