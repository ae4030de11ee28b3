#include "modbus_link.h"

namespace lds::modbus {

using ports::Failure;
using ports::FailureCode;
using ports::LinkState;
using ports::OpenFailure;
using ports::Status;

namespace {

/// Faster polls than this go to the session together, so that a fast sensor does not cost an event each.
constexpr int batchMs = 5;

bool mayRepeat(const Failure& failure)
{
    return failure.code == FailureCode::NoAnswer || failure.code == FailureCode::Malformed;
}

/// A refusal says that nothing was done; everything else leaves that open.
Status statusOf(const Failure& failure)
{
    switch (failure.code) {
    case FailureCode::None:
        return Status::Done;
    case FailureCode::NoAnswer:
    case FailureCode::Malformed:
    case FailureCode::ConnectionLost:
        return Status::Unknown;
    default:
        return Status::Refused;
    }
}

OpenFailure openFailureOf(const Failure& failure)
{
    switch (failure.code) {
    case FailureCode::NoAnswer:
    case FailureCode::ConnectionLost: // Accepted and hung up without a word.
        return OpenFailure::NoAnswer;
    case FailureCode::NotReady:
        return OpenFailure::NotReady;
    default:
        return OpenFailure::NotASensor;
    }
}

} // namespace

ModbusLink::ModbusLink(const ports::ConnectionUrl& url, std::unique_ptr<ports::Scheduler> scheduler,
                       ports::FrameLog& log, ConnectionMaker maker, const Timing& timing)
    : m_url(url)
    , m_timing(timing)
    , m_maker(std::move(maker))
    , m_scheduler(std::move(scheduler))
    , m_recorder(log, *m_scheduler, url)
    , m_ticker(*m_scheduler, this, [this](quint64 missed) { onTick(missed); })
{}

ModbusLink::ModbusLink(const ports::ConnectionUrl& url, std::unique_ptr<ports::Scheduler> scheduler,
                       ports::FrameLog& log, ConnectionMaker maker)
    : ModbusLink(url, std::move(scheduler), log, std::move(maker), Timing())
{}

ModbusLink::~ModbusLink() = default;

bool ModbusLink::reaches(catalog::ItemId item) const { return catalog::hlG2(item).modbus.has_value(); }

// --- Opening and closing

void ModbusLink::doOpen()
{
    if (m_report.state == LinkState::Opening || m_report.state == LinkState::Open)
        return;
    if (!m_connection) {
        m_connection = m_maker(m_url, *m_scheduler, m_recorder);
        connect(m_connection.get(), &Connection::opened, this, &ModbusLink::probe);
        connect(m_connection.get(), &Connection::failed, this, &ModbusLink::fail);
        connect(m_connection.get(), &Connection::lost, this,
                [this](OpenFailure failure, const QString& detail) {
                    if (m_report.state == LinkState::Open) // While opening, the probe's end has told already.
                        fail(failure, detail);
                });
    }
    m_statistics = {};
    m_queue.resetDroppedPolls();
    m_pollRefusal = FailureCode::None;
    m_wantedPollMs = 0;
    m_pollOverdue = false;
    m_probeRepeated = false;
    report({LinkState::Opening, OpenFailure::None, QString(), true});
    m_connection->open(m_timing.connectMs);
}

void ModbusLink::probe()
{
    const Request request = readRequest(packReads({catalog::ItemId::Span}).constFirst());
    exchange(request, Turn::Procedure, m_timing.probeMs, &ModbusLink::onProbed);
}

void ModbusLink::onProbed(const Exchange& exchange)
{
    if (!exchange.result) {
        const Failure& failure = exchange.result.error();
        if (mayRepeat(failure) && m_connection->isOpen() && !std::exchange(m_probeRepeated, true))
            probe();
        else
            fail(openFailureOf(failure), failure.detail);
        return;
    }
    const QList<quint16>& words = exchange.result->registers;
    const auto lowWordFirst = lowWordFirstBySpan(words.at(0), words.at(1));
    if (!lowWordFirst) {
        fail(OpenFailure::NotASensor, QStringLiteral("registers %1 and %2 hold no span: %3, %4")
                                          .arg(printedRegister(exchange.result->address))
                                          .arg(printedRegister(exchange.result->address + 1))
                                          .arg(words.at(0))
                                          .arg(words.at(1)));
        return;
    }
    m_recorder.setLowWordFirst(*lowWordFirst);
    m_lastAnswerNs = exchange.endedNs;
    report({LinkState::Open, OpenFailure::None, QString(), *lowWordFirst});
    if (m_wantedPollMs > 0)
        m_ticker.start(m_wantedPollMs);
}

void ModbusLink::fail(OpenFailure failure, const QString& detail)
{
    shutDown(LinkState::Failed, detail);
    report({LinkState::Failed, failure, detail, m_report.lowWordFirst});
}

void ModbusLink::doClose()
{
    if (m_report.state == LinkState::Closed)
        return;
    shutDown(LinkState::Closed, QStringLiteral("closed"));
    report({LinkState::Closed, OpenFailure::None, QString(), m_report.lowWordFirst});
}

/// Ends the connection, the polling and every request. `state` stands before the first signal goes out,
/// so that whoever hears one finds a link that takes nothing any more.
void ModbusLink::shutDown(LinkState state, const QString& reason)
{
    m_report.state = state;
    m_ticker.stop();
    m_wantedPollMs = 0;
    if (m_connection)
        m_connection->close(reason);
    flush();
    const Failure failure{FailureCode::ConnectionLost, 0, QString()};
    const qint64 nowNs = m_scheduler->nowNs();
    const QList<ports::Request> waiting = m_queue.clear();
    if (m_active)
        finish(Status::Unknown, failure, nowNs);
    for (const ports::Request& request : waiting)
        Q_EMIT finished({request.id, request.kind, Status::Unknown, {}, failure, nowNs});
}

void ModbusLink::report(const ports::LinkReport& report)
{
    m_report = report;
    Q_EMIT reported(report);
}

// --- Requests

void ModbusLink::doSubmit(const ports::Request& request)
{
    if (request.kind == ports::RequestKind::Write && m_url.viewOnly) {
        finishRefused(request, Failure{FailureCode::ViewOnly, 0, QString()});
    } else if (m_report.state != LinkState::Open) {
        finishRefused(request, Failure{FailureCode::NotConnected, 0, QString()});
    } else {
        m_queue.add(request);
        m_connection->hurry(turnOf(request.urgency)); // What is under way stands in its way.
        pump();
    }
}

void ModbusLink::pump()
{
    // A request may end without a message, and a connection may end with one: look again each time.
    while (m_report.state == LinkState::Open && m_connection->isOpen()) {
        const auto work = m_queue.take();
        if (!work)
            return;
        if (const auto* request = std::get_if<ports::Request>(&*work))
            begin(*request);
        else
            sendPoll();
    }
}

void ModbusLink::begin(const ports::Request& request)
{
    QList<Request> messages;
    Failure failure;
    if (request.kind == ports::RequestKind::Read) {
        for (const RegisterRange& range : packReads(request.items))
            messages.append(readRequest(range));
        if (messages.isEmpty())
            failure = {FailureCode::NotReachable, 0, QStringLiteral("nothing that can be read")};
    } else if (const auto message = encodeWrite(request.write, m_report.lowWordFirst)) {
        messages.append(*message);
    } else {
        failure = message.error();
    }
    if (failure.code != FailureCode::None) {
        m_queue.finished();
        finishRefused(request, failure);
        return;
    }
    m_active = Active{request, messages, 0, false, {}};
    sendMessage();
}

void ModbusLink::sendMessage()
{
    const ports::Request& request = m_active->request;
    exchange(m_active->messages.at(m_active->next), turnOf(request.urgency),
             request.timeoutMs > 0 ? request.timeoutMs : m_timing.requestMs, &ModbusLink::onAnswered);
}

void ModbusLink::onAnswered(const Exchange& exchange)
{
    const bool isRead = m_active->request.kind == ports::RequestKind::Read;
    if (!exchange.result) {
        const Failure failure = exchange.result.error();
        if (isRead && mayRepeat(failure) && m_connection->isOpen() && !m_active->repeated) {
            m_active->repeated = true;
            sendMessage();
            return;
        }
        finish(statusOf(failure), failure, exchange.endedNs);
        if (!isLostInSilence(exchange))
            pump();
        return;
    }
    m_lastAnswerNs = exchange.endedNs;
    if (isRead) {
        const Request& message = m_active->messages.at(m_active->next);
        m_active->values.insert(decodeItems(m_active->request.items, {message.address, message.count},
                                            exchange.result->registers, m_report.lowWordFirst));
        m_active->repeated = false;
        if (++m_active->next < m_active->messages.size()) {
            sendMessage();
            return;
        }
    }
    finish(Status::Done, Failure(), exchange.endedNs);
    pump();
}

void ModbusLink::finish(Status status, const Failure& failure, qint64 finishedNs)
{
    const Active active = *std::exchange(m_active, std::nullopt);
    m_queue.finished();
    const settings::Values values = status == Status::Done ? active.values : settings::Values();
    Q_EMIT finished({active.request.id, active.request.kind, status, values, failure, finishedNs});
}

void ModbusLink::finishRefused(const ports::Request& request, const Failure& failure)
{
    Q_EMIT finished({request.id, request.kind, Status::Refused, {}, failure, m_scheduler->nowNs()});
}

/// Whether this was one timeout too many: then the connection has been given up.
bool ModbusLink::isLostInSilence(const Exchange& exchange)
{
    if (exchange.result || exchange.result.error().code != FailureCode::NoAnswer) {
        m_lastAnswerNs = exchange.endedNs;
        return false;
    }
    const qint64 silentMs = (exchange.endedNs - m_lastAnswerNs) / 1'000'000;
    if (silentMs < m_timing.silenceMs)
        return false;
    fail(OpenFailure::Lost, QStringLiteral("no answer for %1 ms").arg(silentMs));
    return true;
}

// --- Polls

void ModbusLink::doPoll(int intervalMs)
{
    if (m_report.state == LinkState::Opening) {
        m_wantedPollMs = intervalMs;
    } else if (intervalMs <= 0) {
        m_ticker.stop();
        flush();
    } else if (m_report.state == LinkState::Open) {
        m_ticker.start(intervalMs);
    }
}

void ModbusLink::onTick(quint64 missed)
{
    m_queue.countDropped(missed);
    if (!m_connection->isShared()) {
        if (m_queue.addPoll())
            pump();
    } else if (!m_connection->isBusy(Turn::Poll)) {
        sendPoll();
    } else if (std::exchange(m_pollOverdue, true)) {
        m_queue.countDropped(1);
    }
}

void ModbusLink::sendPoll()
{
    static const Request request = readRequest(measurementRange());
    m_pollOverdue = false;
    exchange(request, Turn::Poll, m_timing.requestMs, &ModbusLink::onPolled);
}

void ModbusLink::onPolled(const Exchange& exchange)
{
    if (!m_connection->isShared())
        m_queue.finished();
    if (exchange.result) {
        ++m_statistics.answered;
        m_lastAnswerNs = exchange.endedNs;
        measurement::Measurement sample =
            decodeMeasurement(exchange.result->registers, m_report.lowWordFirst);
        sample.monotonicNs = exchange.endedNs;
        sample.wallMs = exchange.endedWallMs;
        m_batch.append(sample);
        reportPoll(Failure());
        if (!m_ticker.isRunning() || m_batch.size() * m_ticker.intervalMs() >= batchMs)
            flush();
    } else {
        ++m_statistics.lost;
        flush();
        if (statusOf(exchange.result.error()) == Status::Refused)
            reportPoll(exchange.result.error());
        if (isLostInSilence(exchange))
            return;
    }
    if (m_connection->isShared())
        makeUpForPoll();
    else
        pump();
}

/// On a busy bus a poll may take longer than the interval. Waiting for the next tick would leave the bus
/// idle, at worst for half the time; one poll at most is made up for.
void ModbusLink::makeUpForPoll()
{
    if (m_pollOverdue && m_ticker.isRunning() && m_connection->isOpen())
        sendPoll();
}

/// Says when polls begin to be refused, when the reason changes, and when they succeed again.
void ModbusLink::reportPoll(const Failure& failure)
{
    if (std::exchange(m_pollRefusal, failure.code) != failure.code)
        Q_EMIT pollRefused(failure);
}

void ModbusLink::flush()
{
    if (m_batch.isEmpty())
        return;
    m_statistics.dropped = m_queue.droppedPolls();
    Q_EMIT measured(std::exchange(m_batch, {}), m_statistics);
}

void ModbusLink::exchange(const Request& request, Turn turn, int timeoutMs, NextStep next)
{
    m_connection->send(request, turn, timeoutMs,
                       [this, next](const Exchange& exchange) { (this->*next)(exchange); });
}

} // namespace lds::modbus
