#include "json_fields.h"

#include <cmath>
#include <utility>

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

QString numberText(double number) { return QString::number(number, 'g', 16); }

/// At most 40 characters, and nothing that a terminal would take for a command.
QString printable(const QString& text)
{
    constexpr qsizetype longest = 40;
    QString shown = text.left(longest);
    for (QChar& character : shown) {
        if (!character.isPrint() && !character.isSurrogate())
            character = u'?';
    }
    return text.size() > longest ? shown + u'…' : shown;
}

} // namespace

void Complaint::add(const QString& where, const QString& what)
{
    if (m_text.isEmpty())
        m_text = where.isEmpty() ? what : u"%1: %2"_s.arg(where, what);
}

QString quoted(const QString& text) { return u"\"%1\""_s.arg(printable(text)); }

QString elementPath(const QString& listPath, qsizetype index) { return u"%1[%2]"_s.arg(listPath).arg(index); }

double checkedNumber(const QJsonValue& value, const QString& path, const NumberLimits& limits,
                     Complaint& complaint)
{
    if (!value.isDouble()) {
        complaint.add(path, u"has to be a number"_s);
        return limits.least;
    }
    const double number = value.toDouble();
    if (std::isfinite(number) && number >= limits.least && number <= limits.most)
        return number;
    complaint.add(path, u"%1 is out of range: it has to be from %2 to %3%4"_s.arg(
                            numberText(number), numberText(limits.least), numberText(limits.most),
                            QString::fromUtf8(limits.unit)));
    return limits.least;
}

JsonFields::JsonFields(const QJsonValue& value, QString path, Complaint& complaint)
    : m_object(value.toObject())
    , m_path(std::move(path))
    , m_complaint(complaint)
{
    if (!value.isObject())
        m_complaint.add(m_path, u"has to be an object, {…}"_s);
}

bool JsonFields::has(QLatin1StringView key) { return !value(key).isUndefined(); }

QJsonValue JsonFields::value(QLatin1StringView key)
{
    if (!m_asked.contains(key))
        m_asked.append(key);
    return m_object.value(key);
}

QJsonValue JsonFields::requiredValue(QLatin1StringView key)
{
    const QJsonValue found = value(key);
    if (found.isUndefined())
        complain(key, u"is missing"_s);
    return found;
}

QString JsonFields::text(QLatin1StringView key, qsizetype longest)
{
    const QJsonValue found = requiredValue(key);
    if (!found.isString())
        complain(key, u"has to be a text"_s);
    const QString text = found.toString();
    if (text.isEmpty() || text.size() > longest)
        complain(key, u"has to have from 1 to %1 characters"_s.arg(longest));
    return text;
}

double JsonFields::number(QLatin1StringView key, const NumberLimits& limits)
{
    return checkedNumber(requiredValue(key), pathOf(key), limits, m_complaint);
}

double JsonFields::number(QLatin1StringView key, const NumberLimits& limits, double otherwise)
{
    return has(key) ? number(key, limits) : otherwise;
}

qint64 JsonFields::wholeNumber(QLatin1StringView key, const NumberLimits& limits,
                               std::optional<qint64> otherwise)
{
    if (otherwise && !has(key))
        return *otherwise;
    const double found = number(key, limits);
    if (found != std::floor(found))
        complain(key, u"%1 has to be a whole number"_s.arg(numberText(found)));
    return qint64(found);
}

QJsonArray JsonFields::list(QLatin1StringView key, qsizetype most)
{
    const QJsonValue found = requiredValue(key);
    if (!found.isArray())
        complain(key, u"has to be a list, […]"_s);
    const QJsonArray list = found.toArray();
    if (list.isEmpty())
        complain(key, u"has to have at least one element"_s);
    if (list.size() > most) {
        complain(key, u"has %1 elements; at most %2 are possible"_s.arg(list.size()).arg(most));
        return {};
    }
    return list;
}

QString JsonFields::pathOf(QLatin1StringView key) const
{
    return m_path.isEmpty() ? QString(key) : u"%1.%2"_s.arg(m_path, key);
}

void JsonFields::complain(QLatin1StringView key, const QString& what) { m_complaint.add(pathOf(key), what); }

void JsonFields::rejectOthers()
{
    for (auto it = m_object.begin(); it != m_object.end() && m_complaint.isEmpty(); ++it) {
        const QString key = it.key();
        if (m_asked.contains(key))
            continue;
        QStringList known;
        for (const QLatin1StringView asked : std::as_const(m_asked))
            known.append(asked);
        const QString where = m_path.isEmpty() ? printable(key) : u"%1.%2"_s.arg(m_path, printable(key));
        m_complaint.add(where, u"is no field here; these are: %1"_s.arg(known.join(u", "_s)));
    }
}

} // namespace lds::emulator
