#include "readout_state.h"

#include "item_text.h"
#include "sentences.h"

#include <QCoreApplication>
#include <QStringList>

namespace lds::ui {

using catalog::ItemId;
using measurement::Measurement;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::Readout)
};

QString valueText(const Measurement& sample, const sensor::SensorSession& session)
{
    const auto& item = session.catalog().item(ItemId::MeasuredValue);
    if (sample.errorCode != 0)
        return displayValue(session.catalog().item(ItemId::ErrorCode), session.model(), sample.errorCode);
    if (!sample.hasValue())
        return displayValue(item, session.model(), sample.value);
    const auto digit = session.held(ItemId::DisplayDigit);
    const int decimals = digit ? displayDecimals(*digit) : session.catalog().model(session.model()).decimals;
    return settings::lengthText(sample.value, decimals, settings::TextStyle::Typographic);
}

Judgment judgmentOf(quint16 state)
{
    if (state & measurement::HighBit)
        return Judgment::High;
    if (state & measurement::LowBit)
        return Judgment::Low;
    return state & measurement::GoBit ? Judgment::Go : Judgment::None;
}

/// The manual's letters (§2.2, "Hold mode icons").
QString holdModeLetter(std::optional<catalog::Value> mode)
{
    switch (mode.value_or(0)) {
    case 1:
        return QStringLiteral("P");
    case 2:
        return QStringLiteral("B");
    case 3:
        return QStringLiteral("PP");
    default:
        return {};
    }
}

/// The first detail bit that is set in one of the self-monitoring registers (§4.13), in words.
QString detailText(const sensor::SensorSession& session, ItemId item, quint16 bits)
{
    for (int bit = 0; bit < 16; ++bit) {
        if (bits >> bit & 1)
            return displayValue(session.catalog().item(item), session.model(), 1 << bit);
    }
    return {};
}

QString withDetail(const QString& word, const QString& detail)
{
    return detail.isEmpty() ? word : word + QStringLiteral(": ") + detail;
}

QString connectionNotice(const sensor::SensorSession& session)
{
    switch (session.connection()) {
    case sensor::Connection::Closed:
        return Words::tr("Not connected");
    case sensor::Connection::Opening:
        return Words::tr("Connecting…");
    case sensor::Connection::Reading:
        return Words::tr("Reading settings…");
    case sensor::Connection::Reconnecting:
        return Words::tr("Connection lost, reconnecting…");
    case sensor::Connection::Ready:
        break;
    }
    return session.isSensorNotReady() ? Words::tr("The sensor is in its menu or busy") : QString();
}

QString sampleNotice(const Measurement& sample, const sensor::SensorSession& session)
{
    if (sample.errorCode != 0 || (sample.state & measurement::ErrorBit))
        return withDetail(Words::tr("Error"), detailText(session, ItemId::SelfMonitoringError, sample.error));
    if (!(sample.state & measurement::LaserBit))
        return Words::tr("The laser is stopped");
    const QString why = detailText(session, ItemId::SelfMonitoringNotification, sample.notification);
    if (sample.isFrozen())
        return withDetail(Words::tr("Alarm, value frozen"), why);
    if (sample.state & measurement::AlarmBit)
        return withDetail(Words::tr("Alarm"), why);
    if (sample.kind == measurement::ValueKind::Over || sample.kind == measurement::ValueKind::Under)
        return Words::tr("Outside the display range");
    if (!sample.hasValue())
        return withDetail(Words::tr("No value yet"), why);
    if (sample.state & measurement::CautionBit)
        return withDetail(Words::tr("Caution"),
                          detailText(session, ItemId::SelfMonitoringCaution, sample.caution));
    return why;
}

void takeSample(ReadoutState& state, const Measurement& sample, const sensor::SensorSession& session)
{
    state.value = valueText(sample, session);
    state.isNumber = sample.hasValue() && sample.errorCode == 0;
    if (!state.isLive)
        return; // the last value stays to be seen, its flags do not pretend to hold
    state.isFrozen = sample.isFrozen();
    state.judgment = judgmentOf(sample.state);
    state.laser = sample.state & measurement::LaserBit;
    state.hold = sample.state & measurement::HoldBit;
    state.zero = sample.state & measurement::ZeroBit;
    if (sample.intensity <= 1023)
        state.intensity = sample.intensity;
}

} // namespace

int displayDecimals(catalog::Value displayDigit)
{
    constexpr int most = 4;
    return qBound(0, most - int(displayDigit), most);
}

ReadoutState readoutState(const sensor::SensorSession* session)
{
    ReadoutState state;
    if (!session) {
        state.notice = Words::tr("No sensor");
        return state;
    }
    state.notice = connectionNotice(*session);
    state.isLive = state.notice.isEmpty() && session->latest().has_value();
    if (state.isLive)
        takeSample(state, *session->latest(), *session);
    else if (!session->trend().isEmpty())
        takeSample(state, session->trend().at(session->trend().size() - 1), *session);
    if (session->isReady()) {
        state.keyLock = session->held(ItemId::KeyLock).value_or(0) != 0;
        state.bank = session->held(ItemId::BankSwitching).value_or(0);
        state.holdModeLetter = holdModeLetter(session->held(ItemId::HoldMode));
    }
    if (state.isLive) {
        state.notice = sampleNotice(*session->latest(), *session);
        state.pace = Words::tr("%1 per s · %2 lost")
                         .arg(qRound(session->measurementRate()))
                         .arg(session->pollStatistics().lost);
    } else if (state.notice.isEmpty()) {
        state.notice = Words::tr("Waiting for the first value…");
    }
    return state;
}

QString spokenText(const ReadoutState& state)
{
    QStringList parts;
    if (!state.value.isEmpty())
        parts += state.isNumber ? state.value + QStringLiteral(" mm") : state.value;
    if (!state.isLive) {
        if (!parts.isEmpty())
            parts.prepend(Words::tr("last value"));
        parts += state.notice;
        return parts.join(QStringLiteral(", "));
    }
    switch (state.judgment) {
    case Judgment::High:
        parts += QStringLiteral("HI");
        break;
    case Judgment::Go:
        parts += QStringLiteral("GO");
        break;
    case Judgment::Low:
        parts += QStringLiteral("LO");
        break;
    case Judgment::None:
        parts += Words::tr("no judgment");
        break;
    }
    parts += state.laser ? Words::tr("laser on") : Words::tr("laser off");
    if (state.bank > 0)
        parts += Words::tr("bank %1").arg(state.bank);
    if (state.hold)
        parts += Words::tr("hold");
    if (state.zero)
        parts += Words::tr("zero set");
    if (!state.holdModeLetter.isEmpty())
        parts += Words::tr("hold mode %1").arg(state.holdModeLetter);
    if (state.keyLock)
        parts += Words::tr("keys locked");
    if (!state.notice.isEmpty())
        parts += state.notice;
    return parts.join(QStringLiteral(", "));
}

} // namespace lds::ui
