#include "trend_ticks.h"

#include "trend_texts.h"
#include "value_text.h"

#include <array>
#include <cmath>
#include <QDateTime>
#include <QLocale>

namespace lds::ui {

namespace {

constexpr qint64 ms = 1'000'000;
constexpr qint64 second = 1000 * ms;
constexpr qint64 minute = 60 * second;
constexpr qint64 hour = 60 * minute;
constexpr qint64 day = 24 * hour;

constexpr std::array timeSteps{
    1 * ms,     2 * ms,     5 * ms,      10 * ms,     20 * ms,     50 * ms,     100 * ms,    200 * ms,
    500 * ms,   1 * second, 2 * second,  5 * second,  10 * second, 15 * second, 30 * second, 1 * minute,
    2 * minute, 5 * minute, 10 * minute, 15 * minute, 30 * minute, 1 * hour,    2 * hour,    3 * hour,
    6 * hour,   12 * hour,  1 * day,     2 * day,     5 * day,     10 * day,
};

qint64 timeStep(qint64 lengthNs, int most)
{
    for (const qint64 step : timeSteps) {
        if (lengthNs / step < most)
            return step;
    }
    return timeSteps.back();
}

qint64 floorTo(qint64 value, qint64 step)
{
    const qint64 rest = value % step;
    return value - rest - (rest < 0 ? step : 0);
}

/// Decimals in mm that a step of 0.1 µm units needs; two at least, so that labels keep their width.
int decimalsFor(qint64 step)
{
    int decimals = 4;
    for (qint64 unit = 10; decimals > 2 && step % unit == 0; unit *= 10)
        --decimals;
    return decimals;
}

QDateTime localTime(qint64 wallNs) { return QDateTime::fromMSecsSinceEpoch(floorTo(wallNs, ms) / ms); }

QString timeTickText(qint64 wallNs, qint64 step)
{
    const QDateTime time = localTime(wallNs);
    if (time.time() == QTime(0, 0))
        return QLocale().toString(time.date(), QLocale::ShortFormat);
    if (step >= minute)
        return time.toString(QStringLiteral("HH:mm"));
    return clockText(wallNs, step);
}

} // namespace

qint64 niceStep(double least)
{
    qint64 power = 1;
    while (true) {
        for (const qint64 factor : {1, 2, 5}) {
            if (double(factor * power) >= least)
                return factor * power;
        }
        power *= 10;
    }
}

QList<ValueTick> valueTicks(const TrendValueScale::Range& range, int most)
{
    const qint64 step = niceStep(range.span() / double(most));
    const int decimals = decimalsFor(step);
    QList<ValueTick> ticks;
    for (auto value = qint64(std::ceil(range.low / double(step))) * step; double(value) <= range.high;
         value += step) {
        QString text =
            settings::lengthText(catalog::Value(value), decimals, settings::TextStyle::Typographic);
        if (text.startsWith(QLatin1Char('+')))
            text.remove(0, 1); // an axis needs no sign where there is nothing to tell apart
        ticks.append({catalog::Value(value), text});
    }
    return ticks;
}

QList<TimeTick> timeTicks(const TrendSpan& span, qint64 wallOffsetNs, int most)
{
    const qint64 step = timeStep(span.lengthNs(), most);
    const qint64 wallFrom = span.fromNs + wallOffsetNs;
    // Hours are round in the local time zone, not in UTC.
    const qint64 zone = qint64(localTime(wallFrom).offsetFromUtc()) * second;
    QList<TimeTick> ticks;
    for (qint64 wall = floorTo(wallFrom + zone + step - 1, step) - zone; wall <= span.toNs + wallOffsetNs;
         wall += step)
        ticks.append({wall - wallOffsetNs, timeTickText(wall, step)});
    return ticks;
}

QString clockText(qint64 wallNs, qint64 resolutionNs)
{
    QString text = localTime(wallNs).toString(QStringLiteral("HH:mm:ss.zzz"));
    const int cut = resolutionNs % second == 0       ? 4
                    : resolutionNs % (100 * ms) == 0 ? 2
                    : resolutionNs % (10 * ms) == 0  ? 1
                                                     : 0;
    text.chop(cut);
    return text;
}

QString durationText(qint64 ns)
{
    const auto number = [](double value, int decimals) {
        QString text = QLocale::c().toString(value, 'f', decimals);
        while (text.contains(QLatin1Char('.')) &&
               (text.endsWith(QLatin1Char('0')) || text.endsWith(QLatin1Char('.'))))
            text.chop(1);
        return text;
    };
    const auto rounded = [ns](qint64 unit) { return (ns + unit / 2) / unit * unit; };
    if (ns < second)
        return TrendTexts::tr("%1 ms").arg(number(double(ns) / double(ms), 0));
    if (rounded(100 * ms) < minute)
        return TrendTexts::tr("%1 s").arg(number(double(ns) / double(second), 1));
    const auto two = [&](qint64 big, const char* one, qint64 small, const char* both) {
        const qint64 whole = rounded(small);
        const qint64 rest = whole % big / small;
        return rest == 0 ? TrendTexts::tr(one).arg(whole / big)
                         : TrendTexts::tr(both).arg(whole / big).arg(rest);
    };
    if (rounded(second) < hour)
        return two(minute, QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 min"), second,
                   QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 min %2 s"));
    if (rounded(minute) < day)
        return two(hour, QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 h"), minute,
                   QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 h %2 min"));
    return two(day, QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 d"), hour,
               QT_TRANSLATE_NOOP("lds::ui::TrendTexts", "%1 d %2 h"));
}

} // namespace lds::ui
