#include "rtu_bus.h"

#include "answer_failure.h"
#include "serial_timing.h"

#include <algorithm>

namespace lds::modbus {

using ports::Failure;
using ports::FailureCode;
using ports::OpenFailure;

namespace {

constexpr qint64 nsPerMs = 1'000'000;
constexpr qint64 longestSettlingNs = 1'000 * nsPerMs; ///< A line that is never quiet is tried all the same.
constexpr qsizetype mostHeard = 4 * longestRtuFrame;

const Request& coilsRequest()
{
    static const Request request{Function::ReadCoils, 0, 1, {}};
    return request;
}

} // namespace

RtuBus::RtuBus(std::unique_ptr<ports::Scheduler> scheduler, std::unique_ptr<SerialLine> line)
    : m_scheduler(std::move(scheduler))
    , m_line(std::move(line))
{
    connect(m_line.get(), &SerialLine::heard, this, &RtuBus::onHeard);
    connect(m_line.get(), &SerialLine::sent, this, &RtuBus::onSent);
    connect(m_line.get(), &SerialLine::ended, this, &RtuBus::onEnded);
    connect(m_line.get(), &SerialLine::lost, this, &RtuBus::onLost);
}

RtuBus::~RtuBus() { close(); }

tl::expected<void, PortFailure> RtuBus::open(const QString& port, const ports::SerialSettings& settings)
{
    Q_ASSERT(!m_open);
    const auto opened = m_line->open(port, settings);
    m_open = opened.has_value();
    m_settings = settings;
    m_lineSettings = settings;
    return opened;
}

void RtuBus::close()
{
    if (!m_open)
        return;
    m_open = false;
    m_state = State::Idle;
    m_scheduler->cancel(m_timer);
    m_scheduler->cancel(m_pauseTimer);
    m_queue = BusQueue();
    m_jobs.clear();
    m_current = Job();
    m_line->close();
}

// --- Whose turn it is

Ticket RtuBus::ask(const Question& question)
{
    Q_ASSERT(m_open);
    return add(Job{0, question, std::nullopt}, question.unit, question.turn);
}

Ticket RtuBus::listen(const Listening& listening)
{
    Q_ASSERT(m_open);
    return add(Job{0, std::nullopt, listening}, 0, Turn::Background); // 0: no unit's pause holds it up.
}

Ticket RtuBus::add(Job job, quint8 unit, Turn turn)
{
    const Ticket ticket = m_nextTicket++;
    job.ticket = ticket;
    m_jobs.emplace(ticket, std::move(job));
    m_queue.add(ticket, unit, turn);
    pump();
    return ticket;
}

bool RtuBus::withdraw(Ticket ticket)
{
    m_jobs.erase(ticket);
    return m_queue.remove(ticket);
}

void RtuBus::hurry(Ticket ticket, Turn turn)
{
    m_queue.hurry(ticket, turn);
    pump(); // It may have waited for a pause to end.
}

void RtuBus::forget(Ticket ticket)
{
    if (withdraw(ticket) || m_current.ticket != ticket)
        return;
    if (m_current.question) {
        m_current.question->recorder = nullptr;
        m_current.question->ended = {};
    }
    if (m_current.listening)
        m_current.listening->ended = {};
}

void RtuBus::leave(const FrameRecorder& recorder)
{
    if (m_lastRecorder == &recorder)
        m_lastRecorder = nullptr;
    if (m_current.question && m_current.question->recorder == &recorder)
        m_current.question->recorder = nullptr;
}

void RtuBus::pump()
{
    if (!m_open || m_state != State::Idle)
        return;
    m_scheduler->cancel(std::exchange(m_pauseTimer, 0));
    if (const auto ticket = m_queue.take(m_units, m_scheduler->nowNs())) {
        auto job = m_jobs.extract(*ticket);
        begin(std::move(job.mapped()));
    } else {
        waitForPause();
    }
}

void RtuBus::waitForPause()
{
    const auto due = m_queue.nextDueNs(m_units);
    if (!due)
        return;
    const qint64 waitNs = qMax<qint64>(0, *due - m_scheduler->nowNs());
    m_pauseTimer = m_scheduler->after(int((waitNs + nsPerMs - 1) / nsPerMs), this, [this] {
        m_pauseTimer = 0;
        pump();
    });
}

void RtuBus::begin(Job job)
{
    m_current = std::move(job);
    if (m_current.listening) {
        m_currentUnit =
            m_current.listening->frame.isEmpty() ? broadcastUnit : quint8(m_current.listening->frame.at(0));
        beginListening();
        return;
    }
    m_currentUnit = m_current.question->unit;
    QString detail;
    if (!adopt(m_settings, &detail)) {
        m_line->close();
        onLost(detail);
    } else if (m_units.isDoubtful(m_currentUnit)) {
        askCoils();
    } else {
        askData();
    }
}

// --- Questions

void RtuBus::askCoils()
{
    m_state = State::AskingCoils;
    send(coilsRequest());
}

void RtuBus::askData()
{
    m_state = State::Asking;
    send(m_current.question->request);
}

void RtuBus::send(const Request& request)
{
    const Question& question = *m_current.question;
    m_sent = request;
    m_heard.clear();
    m_sentNs = m_scheduler->nowNs();
    m_lastRecorder = question.recorder;
    m_line->ask(question.unit, encodeRequest(request), timeoutMs(m_settings, request, question.answeringMs));
}

void RtuBus::onHeard(const QByteArray& bytes)
{
    m_lastHeardNs = m_scheduler->nowNs();
    switch (m_state) {
    case State::Idle: // A second answer, or one that has come too late.
        m_units.doubt(quint8(m_currentUnit));
        unasked(bytes);
        break;
    case State::Settling:
    case State::BeforeListening:
        unasked(bytes);
        break;
    case State::AskingCoils:
    case State::Asking:
        if (m_heard.size() < mostHeard)
            m_heard += bytes;
        break;
    case State::Listening:
        m_heard += bytes;
        waitForSilence();
        break;
    }
}

/// Bytes from the silence in front of a request: noise, or somebody who was asked before.
void RtuBus::onSent()
{
    if (!m_heard.isEmpty())
        unasked(std::exchange(m_heard, {}));
    m_sentNs = m_scheduler->nowNs();
    if (m_current.question && m_current.question->recorder)
        m_current.question->recorder->sent(m_sent,
                                           encodeRtuFrame(m_current.question->unit, encodeRequest(m_sent)));
}

void RtuBus::unasked(const QByteArray& bytes)
{
    if (m_lastRecorder)
        m_lastRecorder->malformed(QStringLiteral("late"), bytes);
}

void RtuBus::onEnded(bool matched)
{
    stamp();
    if (m_state == State::AskingCoils)
        onCoilsEnded(matched);
    else if (m_state == State::Asking)
        onDataEnded(matched);
}

/// Any answer to Read Coils will do, a refusal and that of an earlier Read Coils included: what the unit was
/// asked for before has been answered before.
void RtuBus::onCoilsEnded(bool matched)
{
    const RtuVerdict verdict = judgeCoils(m_heard, quint8(m_currentUnit));
    record(verdict.strays);
    FrameRecorder* const recorder = m_current.question->recorder;
    if (verdict.kind != RtuVerdict::Kind::Answer || !matched) {
        giveUp(verdict.kind == RtuVerdict::Kind::Silent
                   ? Failure{FailureCode::NoAnswer, 0, QString()}
                   : malformed(verdict.what.isEmpty() ? QStringLiteral("late") : verdict.what));
        return;
    }
    const auto response = decodeResponse(m_sent, verdict.pdu());
    const qint64 roundTripNs = m_stampNs - m_sentNs;
    if (recorder && response)
        recorder->answered(m_sent, *response, verdict.frame, roundTripNs);
    else if (recorder && response.error().error == ResponseError::Refused)
        recorder->refused(m_sent, response.error().exceptionCode, verdict.frame, roundTripNs);
    else if (recorder)
        recorder->malformed(wordOf(response.error().error), verdict.frame, roundTripNs);
    m_units.trust(quint8(m_currentUnit));
    m_units.answered(quint8(m_currentUnit));
    if (m_current.question->ended) {
        askData();
        return;
    }
    m_current = Job(); // Forgotten meanwhile: a write of somebody who has left is not sent after him.
    m_state = State::Idle;
    pump();
}

void RtuBus::onDataEnded(bool matched)
{
    const RtuVerdict verdict = judgeData(m_heard, quint8(m_currentUnit));
    record(verdict.strays);
    if (verdict.kind == RtuVerdict::Kind::Silent) {
        giveUp(Failure{FailureCode::NoAnswer, 0, QString()});
        return;
    }
    if (verdict.kind == RtuVerdict::Kind::Spoiled) {
        giveUp(malformed(verdict.what));
        return;
    }
    FrameRecorder* const recorder = m_current.question->recorder;
    const auto response = decodeResponse(m_sent, verdict.pdu());
    const qint64 roundTripNs = m_stampNs - m_sentNs;
    const bool refused = !response && response.error().error == ResponseError::Refused;
    if (!matched || (!response && !refused)) {
        const QString what = response || refused ? QStringLiteral("late") : wordOf(response.error().error);
        if (recorder)
            recorder->malformed(what, verdict.frame, roundTripNs);
        giveUp(malformed(what));
        return;
    }
    m_units.answered(quint8(m_currentUnit));
    m_state = State::Idle;
    const Job job = std::exchange(m_current, Job());
    const Request request = m_sent;
    // The silence in front of the next exchange passes while a poll is told. Others first say what they want
    // next: the rest of a long read goes before polls, too.
    if (job.question->turn == Turn::Poll && m_lineSettings == m_settings)
        pump();
    const quint8 code = refused ? response.error().exceptionCode : quint8(0);
    if (recorder && refused)
        recorder->refused(request, code, verdict.frame, roundTripNs);
    else if (recorder)
        recorder->answered(request, *response, verdict.frame, roundTripNs);
    tl::expected<Response, Failure> result;
    if (refused)
        result = tl::unexpected(Failure{refusalOf(code), code, QString()});
    else
        result = *response;
    tell(job, result);
}

void RtuBus::record(const QList<RtuStray>& strays)
{
    if (!m_current.question->recorder)
        return;
    for (const RtuStray& stray : strays)
        m_current.question->recorder->malformed(stray.what, stray.bytes);
}

void RtuBus::giveUp(const Failure& failure)
{
    m_units.doubt(quint8(m_currentUnit));
    m_units.silent(quint8(m_currentUnit), m_stampNs);
    Failure told = failure;
    if (failure.code == FailureCode::NoAnswer) {
        const qint64 waitedNs = m_stampNs - m_sentNs;
        told.detail = QStringLiteral("no answer within %1 ms").arg(waitedNs / nsPerMs);
        if (m_current.question->recorder)
            m_current.question->recorder->noAnswer(waitedNs);
    }
    m_state = State::Settling;
    tell(std::exchange(m_current, Job()), tl::unexpected(told));
}

void RtuBus::tell(const Job& job, const tl::expected<Response, Failure>& result)
{
    if (job.question->ended)
        job.question->ended({result, m_stampNs, m_stampWallMs});
    goOn();
}

// --- Listening

void RtuBus::beginListening()
{
    m_state = State::BeforeListening;
    QString detail;
    if (!adopt(m_current.listening->settings, &detail)) {
        finishListening(tl::unexpected(PortFailure{OpenFailure::PortUnusable, detail}));
        return;
    }
    m_heard.clear();
    startTimer(frameSilenceNs(rateOf(m_lineSettings)), &RtuBus::sendListening);
}

void RtuBus::sendListening()
{
    const Listening& listening = *m_current.listening;
    m_state = State::Listening;
    m_heard.clear();
    if (!listening.frame.isEmpty()) {
        m_units.doubt(quint8(m_currentUnit)); // Its answer may come when the listening has ended.
        m_line->write(listening.frame);
    }
    if (m_state != State::Listening)
        return; // Lost in the attempt.
    const qint64 onTheLineNs = charactersNs(rateOf(m_lineSettings), listening.frame.size());
    startTimer(onTheLineNs + listening.windowMs * nsPerMs, &RtuBus::onSilence);
}

void RtuBus::waitForSilence()
{
    if (m_heard.size() >= mostHeard)
        onSilence();
    else
        startTimer(m_current.listening->silenceMs * nsPerMs, &RtuBus::onSilence);
}

void RtuBus::onSilence() { finishListening(m_heard); }

void RtuBus::finishListening(const Heard& heard)
{
    m_scheduler->cancel(std::exchange(m_timer, 0));
    const Job job = std::exchange(m_current, Job());
    m_state = m_heard.size() >= mostHeard ? State::Settling : State::Idle;
    stamp();
    if (job.listening->ended)
        job.listening->ended(heard);
    goOn();
}

// --- The line

/// After an exchange has been told. When it went wrong the line is first left alone until it is quiet; what
/// comes meanwhile is dropped.
void RtuBus::goOn()
{
    if (m_state != State::Settling) {
        pump();
        return;
    }
    m_settlingEndsNs = m_stampNs + longestSettlingNs;
    waitUntilQuiet();
}

void RtuBus::waitUntilQuiet()
{
    const qint64 nowNs = m_scheduler->nowNs();
    const qint64 quietAtNs = qMin(qMax(m_lastHeardNs, m_sentNs) + quietNs(m_settings), m_settlingEndsNs);
    if (quietAtNs > nowNs) {
        startTimer(quietAtNs - nowNs, &RtuBus::waitUntilQuiet);
        return;
    }
    m_state = State::Idle;
    pump();
}

bool RtuBus::adopt(const ports::SerialSettings& settings, QString* detail)
{
    if (m_lineSettings == settings)
        return true;
    const auto adopted = m_line->adopt(settings);
    if (adopted)
        m_lineSettings = settings;
    else
        *detail = adopted.error();
    return adopted.has_value();
}

void RtuBus::onLost(const QString& detail)
{
    stamp();
    m_open = false;
    m_state = State::Idle;
    m_scheduler->cancel(std::exchange(m_timer, 0));
    m_scheduler->cancel(std::exchange(m_pauseTimer, 0));
    m_queue = BusQueue();
    std::map<Ticket, Job> jobs = std::exchange(m_jobs, {});
    if (m_current.question || m_current.listening)
        jobs.emplace(m_current.ticket, std::exchange(m_current, Job()));
    for (const auto& [ticket, job] : jobs) {
        if (job.question && job.question->ended)
            job.question->ended(
                {tl::unexpected(Failure{FailureCode::ConnectionLost, 0, detail}), m_stampNs, m_stampWallMs});
        if (job.listening && job.listening->ended)
            job.listening->ended(tl::unexpected(PortFailure{OpenFailure::PortGone, detail}));
    }
    Q_EMIT lost(OpenFailure::PortGone, detail);
}

/// Taken before anything is decoded or told: a measurement carries this time.
void RtuBus::stamp()
{
    m_stampNs = m_scheduler->nowNs();
    m_stampWallMs = m_scheduler->wallMs();
}

void RtuBus::startTimer(qint64 delayNs, void (RtuBus::*callback)())
{
    m_scheduler->cancel(m_timer);
    m_timer = m_scheduler->after(int((delayNs + nsPerMs - 1) / nsPerMs), this, [this, callback] {
        m_timer = 0;
        (this->*callback)();
    });
}

} // namespace lds::modbus
