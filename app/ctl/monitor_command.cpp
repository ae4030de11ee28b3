#include "monitor_command.h"

#include "console.h"
#include "sentences.h"
#include "texts.h"
#include "value_report.h"
#include "value_text.h"

#include <QDateTime>

namespace lds::ctl {

using sensor::SensorSession;

namespace {

/// Keys of the sensor-state coils that are set (§5.2.5).
QStringList stateWords(quint16 state)
{
    QStringList words;
    for (const catalog::Coil& coil : catalog::Catalog::hlG2().coils().first(16)) {
        if ((state & (1U << (coil.number - 1))) && !coil.reserved())
            words += QString::fromLatin1(coil.key);
    }
    return words;
}

QString timeText(const measurement::Measurement& sample)
{
    return QDateTime::fromMSecsSinceEpoch(sample.wallMs, Qt::UTC).toString(Qt::ISODateWithMs);
}

/// All digits the wire has, whatever the type's display shows; empty when there is no value.
QString valueText(const measurement::Measurement& sample)
{
    constexpr int wireDecimals = 4;
    return sample.hasValue() ? settings::lengthText(sample.value, wireDecimals) : QString();
}

QString kindWord(const measurement::Measurement& sample)
{
    if (sample.hasValue())
        return sample.isFrozen() ? QStringLiteral("frozen") : QStringLiteral("valid");
    return sentinelWord(sample.value);
}

bool hasIntensity(const measurement::Measurement& sample)
{
    return sample.intensity != catalog::sentinel::noIntensity;
}

QJsonObject toJson(const measurement::Measurement& sample)
{
    return {
        {QStringLiteral("time"), timeText(sample)},
        {QStringLiteral("value"), sample.value},
        {QStringLiteral("text"), valueText(sample)},
        {QStringLiteral("kind"), kindWord(sample)},
        {QStringLiteral("state"), QJsonArray::fromStringList(stateWords(sample.state))},
        {QStringLiteral("intensity"), hasIntensity(sample) ? QJsonValue(sample.intensity) : QJsonValue()}};
}

} // namespace

bool MonitorCommand::prepare()
{
    connect(&session(), &SensorSession::measured, this, &MonitorCommand::onMeasured);
    connect(&session(), &SensorSession::readinessChanged, this, &MonitorCommand::onReadinessChanged);
    if (line().csvFile.isEmpty())
        return true;
    m_csv.setFileName(line().csvFile);
    if (m_csv.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Text) &&
        writeCsv({QStringLiteral("time"), QStringLiteral("value_mm"), QStringLiteral("kind"),
                  QStringLiteral("state"), QStringLiteral("intensity")}))
        return true;
    console().message(
        Texts::tr("Cannot write %1: %2. Choose another file.").arg(line().csvFile, m_csv.errorString()));
    finish(ExitCode::Usage);
    return false;
}

void MonitorCommand::onReady()
{
    m_startedNs = scheduler().nowNs();
    if (line().durationMs)
        scheduler().after(*line().durationMs, this, [this] { end(ExitCode::Done); });
}

void MonitorCommand::interrupt()
{
    if (!isFinished())
        end(ExitCode::Done);
}

void MonitorCommand::onMeasured()
{
    if (isFinished())
        return;
    const measurement::TrendStore& trend = session().trend();
    for (std::size_t index = 0; index < trend.size() && !isFinished(); ++index)
        print(trend.at(index));
    if (!trend.isEmpty())       // clearing tells measured() again
        session().clearTrend(); // printed; a command line may run for days
}

void MonitorCommand::print(const measurement::Measurement& sample)
{
    const QString value = sample.hasValue() ? valueText(sample) + QStringLiteral(" mm") : kindWord(sample);
    const QString intensity = hasIntensity(sample) ? QString::number(sample.intensity) : QStringLiteral("-");
    const QStringList state = stateWords(sample.state);
    if (line().json)
        console().jsonLine(toJson(sample));
    else
        console().line(QStringLiteral("%1  %2  %3  %4")
                           .arg(timeText(sample), value.rightJustified(13), intensity.rightJustified(4),
                                state.join(u',')));
    if (m_csv.isOpen() && !writeCsv({timeText(sample), valueText(sample), kindWord(sample), state.join(u' '),
                                     hasIntensity(sample) ? intensity : QString()})) {
        console().message(
            Texts::tr("Cannot write %1: %2. What was written before is in it; make room or choose "
                      "another file.")
                .arg(m_csv.fileName(), m_csv.errorString()));
        end(ExitCode::Refused);
    }
}

/// No cell holds a comma, a quote or a line break.
bool MonitorCommand::writeCsv(const QStringList& cells)
{
    const QByteArray text = cells.join(u',').toUtf8() + '\n';
    return m_csv.write(text) == text.size() && m_csv.flush();
}

void MonitorCommand::onReadinessChanged()
{
    if (isFinished() || m_startedNs == 0 || session().isSensorNotReady() == m_saidNotReady)
        return;
    m_saidNotReady = session().isSensorNotReady();
    console().message(m_saidNotReady ? ui::failureSentence({ports::FailureCode::NotReady, 0, {}}, nullptr)
                                     : Texts::tr("The sensor answers again."));
}

void MonitorCommand::onLost(const QString& sentence)
{
    console().message(sentence);
    end(ExitCode::Refused);
}

void MonitorCommand::end(ExitCode code)
{
    if (isFinished())
        return;
    const ports::PollStatistics& polls = session().pollStatistics();
    const double seconds = m_startedNs == 0 ? 0 : double(scheduler().nowNs() - m_startedNs) / 1e9;
    if (line().json) {
        console().jsonLine(
            {{QStringLiteral("summary"), QJsonObject{{QStringLiteral("answered"), qint64(polls.answered)},
                                                     {QStringLiteral("lost"), qint64(polls.lost)},
                                                     {QStringLiteral("dropped"), qint64(polls.dropped)},
                                                     {QStringLiteral("seconds"), seconds}}}});
    }
    console().message(Texts::tr("%1 answered, %2 lost, %3 left out because the line was busy, in %4 s.")
                          .arg(polls.answered)
                          .arg(polls.lost)
                          .arg(polls.dropped)
                          .arg(seconds, 0, 'f', 1));
    finish(code);
}

} // namespace lds::ctl
