#include "trend_notice.h"

#include "sentences.h"
#include "trend_texts.h"
#include "trend_ticks.h"

namespace lds::ui {

using sensor::Connection;
using sensor::SensorSession;

namespace {

QString disconnectedDetail(const SensorSession& session)
{
    const bool hasData = !session.trend().isEmpty();
    switch (session.connection()) {
    case Connection::Closed:
    case Connection::Reconnecting:
        if (session.linkReport().failure != ports::OpenFailure::None && !hasData)
            return openFailureSentence(session.linkReport(), session.url());
        break;
    case Connection::Opening:
    case Connection::Reading:
    case Connection::Ready:
        if (!hasData)
            return TrendTexts::tr("The line starts with the first value.");
        break;
    }
    if (!hasData)
        return TrendTexts::tr("Connect to the sensor to watch its measured value here.");
    const auto& trend = session.trend();
    const qint64 wallMs = trend.at(trend.size() - 1).wallMs;
    return TrendTexts::tr("Nothing measured since %1.").arg(clockText(wallMs * 1'000'000, 1'000'000'000));
}

TrendLimit limitOf(const SensorSession& session, catalog::ItemId id, const QString& name)
{
    const catalog::SettingItem& item = session.catalog().item(id);
    const auto text = [&](catalog::Value value) {
        return settings::valueText(item, session.model(), value, settings::TextStyle::Typographic);
    };
    TrendLimit limit;
    limit.held = session.held(id);
    if (limit.held)
        limit.heldText = QStringLiteral("%1 %2").arg(name, text(*limit.held));
    if (const auto edit = session.pending().find(id)) {
        limit.wanted = edit->wanted;
        limit.wantedText = TrendTexts::tr("%1 %2, not applied yet").arg(name, text(edit->wanted));
    }
    return limit;
}

} // namespace

TrendNotice noticeFor(const SensorSession* session)
{
    if (!session)
        return {TrendTexts::tr("No sensor"),
                TrendTexts::tr("Connect to a sensor to watch its measured value here.")};
    if (session->connection() != Connection::Ready)
        return {connectionWord(session->connection()), disconnectedDetail(*session)};
    if (session->isSensorNotReady())
        return {TrendTexts::tr("Sensor not ready"),
                TrendTexts::tr("It is in its menu, or saving. The line goes on when it measures again.")};
    if (session->trend().isEmpty())
        return {TrendTexts::tr("Waiting for the first value"),
                TrendTexts::tr("The line starts as soon as the sensor answers.")};
    const auto& latest = session->latest();
    if (latest && !(latest->state & measurement::LaserBit))
        return {TrendTexts::tr("Laser stopped"), TrendTexts::tr("Switch the laser on to go on measuring.")};
    return {};
}

TrendLimits limitsOf(const SensorSession& session)
{
    TrendLimits limits;
    limits.high = limitOf(session, catalog::ItemId::HighSetValue, QStringLiteral("HIGH"));
    limits.low = limitOf(session, catalog::ItemId::LowSetValue, QStringLiteral("LOW"));
    limits.stale = session.isStale();
    // ± the measurement range: a window of that width leaves nothing out.
    const catalog::Value range = session.catalog().model(session.model()).measurementRange;
    limits.sayLittle = limits.high.held && limits.low.held && *limits.high.held - *limits.low.held >= range;
    return limits;
}

} // namespace lds::ui
