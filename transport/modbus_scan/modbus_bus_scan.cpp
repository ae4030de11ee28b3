#include "modbus_bus_scan.h"

#include "modbus_rtu_framing.h"

namespace lds::modbus {

using ports::ScanEnd;
using Kind = ports::ScanFinding::Kind;

namespace {

constexpr quint8 nobody = 248; ///< Reserved: no unit may have it.
constexpr int mostLateAnswers = 3;

/// For an answer's first byte, from the end of the request: its silence and one character belong to the line.
int windowMs(const ports::SerialSettings& serial, const ScanTiming& timing)
{
    constexpr qint64 nsPerMs = 1'000'000;
    const RtuRate rate{serial.baud, serial.bitsPerCharacter()};
    const qint64 lineNs = frameSilenceNs(rate) + charactersNs(rate, 1);
    return timing.answerMs + int((lineNs + nsPerMs - 1) / nsPerMs);
}

Kind findingOf(AnswerKind answer)
{
    return answer == AnswerKind::OtherDevice ? Kind::OtherDevice : Kind::Sensor;
}

} // namespace

ModbusBusScan::ModbusBusScan(std::unique_ptr<ScanLine> line, const ScanTiming& timing)
    : m_line(std::move(line))
    , m_timing(timing)
{
    m_line->setParent(this); // follows into the scan's thread; deleted by the pointer before
    connect(m_line.get(), &ScanLine::opened, this, &ModbusBusScan::opened);
    connect(m_line.get(), &ScanLine::heard, this, &ModbusBusScan::heard);
    connect(m_line.get(), &ScanLine::failed, this, &ModbusBusScan::failed);
}

ModbusBusScan::~ModbusBusScan()
{
    m_line->disconnect(this);
    m_line->close();
}

void ModbusBusScan::doStart(const ports::ScanPlan& plan)
{
    if (m_phase != Phase::Idle)
        return;
    m_plan = plan;
    m_plan.firstUnit = std::max(plan.firstUnit, firstRtuUnit);
    m_plan.lastUnit = std::min(plan.lastUnit, lastRtuUnit);
    m_setting = 0;
    m_progress = {};
    m_progress.total = int(plan.settings.size()) * std::max(0, m_plan.lastUnit - m_plan.firstUnit + 1);
    m_phase = Phase::Opening;
    if (m_progress.total == 0)
        return finish(ScanEnd::Complete);
    openNext();
}

void ModbusBusScan::doCancel()
{
    if (m_phase != Phase::Idle)
        finish(ScanEnd::Cancelled);
}

void ModbusBusScan::finish(ScanEnd end, const QString& detail)
{
    m_phase = Phase::Idle;
    m_line->close();
    Q_EMIT finished(end, detail);
}

void ModbusBusScan::failed(const QString& detail)
{
    if (m_phase != Phase::Idle)
        finish(ScanEnd::PortFailed, detail);
}

void ModbusBusScan::openNext()
{
    m_phase = Phase::Opening;
    m_unit = m_plan.firstUnit;
    m_noisy = false;
    m_found.clear();
    m_progress.serial = serial();
    m_progress.unit = quint8(m_unit);
    Q_EMIT progressed(m_progress);
    m_line->open(m_plan.port, serial());
}

void ModbusBusScan::opened()
{
    if (m_phase == Phase::Opening)
        exchange(Phase::Listening, {}, m_timing.listenMs);
}

void ModbusBusScan::exchange(Phase phase, const QByteArray& request, int window)
{
    m_phase = phase;
    m_line->exchange(request, window, m_timing.silenceMs);
}

void ModbusBusScan::ask(Phase phase)
{
    const quint8 unit = phase == Phase::AskingNobody ? nobody : quint8(m_unit);
    const QByteArray request = scanRequest(unit);
    exchange(phase, request, windowMs(serial(), m_timing));
}

void ModbusBusScan::heard(const QByteArray& bytes)
{
    switch (m_phase) {
    case Phase::Idle:
    case Phase::Opening:
        return;
    case Phase::Listening:
        if (!bytes.isEmpty())
            reportNoise();
        m_lateAnswers = 0;
        return ask(Phase::Asking);
    case Phase::Asking:
    case Phase::AskingAgain:
        return judge(judgeScanAnswer(quint8(m_unit), bytes));
    case Phase::ListeningForNoise:
        if (bytes.isEmpty())
            return ask(Phase::AskingNobody);
        reportNoise();
        return next();
    case Phase::AskingNobody:
        if (judgeScanAnswer(nobody, bytes).kind == AnswerKind::Silence)
            report(Kind::TwoUnits, quint8(m_unit));
        else
            reportNoise();
        return next();
    }
}

void ModbusBusScan::judge(const ScanAnswer& answer)
{
    switch (answer.kind) {
    case AnswerKind::Silence:
        return next();
    case AnswerKind::Sensor:
    case AnswerKind::NotReady:
    case AnswerKind::OtherDevice:
        report(findingOf(answer.kind), answer.unit);
        return next();
    case AnswerKind::OtherUnit:
        return takeLate(answer);
    case AnswerKind::Garbage:
        if (m_phase == Phase::Asking)
            return ask(Phase::AskingAgain);
        if (m_noisy)
            return next(); // said already, and nothing can be told apart here
        return exchange(Phase::ListeningForNoise, {}, windowMs(serial(), m_timing));
    }
}

/// A unit slower than its window: its answer names it all the same. The one that was asked gets another turn.
void ModbusBusScan::takeLate(const ScanAnswer& answer)
{
    if (answer.unit >= m_plan.firstUnit && answer.unit < m_unit)
        report(findingOf(answer.late), answer.unit);
    if (++m_lateAnswers > mostLateAnswers)
        return next();
    ask(m_phase);
}

void ModbusBusScan::report(Kind kind, quint8 unit)
{
    if (m_found.contains(unit))
        return;
    m_found.insert(unit);
    Q_EMIT found({kind, serial(), unit});
}

void ModbusBusScan::reportNoise()
{
    if (!std::exchange(m_noisy, true))
        Q_EMIT found({Kind::Noise, serial(), 0});
}

void ModbusBusScan::next()
{
    ++m_progress.asked;
    m_lateAnswers = 0;
    if (m_unit < m_plan.lastUnit) {
        ++m_unit;
    } else if (++m_setting < m_plan.settings.size()) {
        return openNext();
    } else {
        Q_EMIT progressed(m_progress);
        return finish(ScanEnd::Complete);
    }
    m_progress.unit = quint8(m_unit);
    Q_EMIT progressed(m_progress);
    ask(Phase::Asking);
}

} // namespace lds::modbus
