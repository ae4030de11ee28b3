#pragma once

#include <optional>
#include <QJsonArray>
#include <QJsonObject>
#include <QLatin1StringView>
#include <QList>
#include <QString>

namespace lds::emulator {

/// The first thing that is wrong with a file. Reading goes on with harmless values after it.
class Complaint {
public:
    void add(const QString& where, const QString& what);
    bool isEmpty() const { return m_text.isEmpty(); }
    const QString& text() const { return m_text; } ///< "motion.speed: is missing"

private:
    QString m_text;
};

/// The numbers a field may hold, both ends included.
struct NumberLimits {
    double least;
    double most;
    const char* unit = ""; ///< As it stands behind a number: " mm".
};

/// What a file wrote, in quotation marks and fit for a line of text: short, and nothing but print.
QString quoted(const QString& text);
/// "workpieces[2]"
QString elementPath(const QString& listPath, qsizetype index);
/// A number inside its limits; `least` and a complaint otherwise.
double checkedNumber(const QJsonValue& value, const QString& path, const NumberLimits& limits,
                     Complaint& complaint);

/// The fields of one object of a file. What is missing, of a wrong type or out of bounds goes to the
/// complaint under its full path, and so does, at the end, every field nobody asked for.
class JsonFields {
public:
    /// `path`: empty for the whole file.
    JsonFields(const QJsonValue& value, QString path, Complaint& complaint);

    bool has(QLatin1StringView key);
    QJsonValue value(QLatin1StringView key); ///< Undefined when missing, which is not complained about.
    QJsonValue requiredValue(QLatin1StringView key);
    /// Between 1 and `longest` characters.
    QString text(QLatin1StringView key, qsizetype longest);
    double number(QLatin1StringView key, const NumberLimits& limits);
    double number(QLatin1StringView key, const NumberLimits& limits, double otherwise);
    /// A number without a fraction.
    qint64 wholeNumber(QLatin1StringView key, const NumberLimits& limits, std::optional<qint64> otherwise);
    /// At least one element and at most `most`.
    QJsonArray list(QLatin1StringView key, qsizetype most);

    QString pathOf(QLatin1StringView key) const;
    void complain(QLatin1StringView key, const QString& what);
    /// Complains about the first field that nobody asked for.
    void rejectOthers();

private:
    QJsonObject m_object;
    QString m_path;
    Complaint& m_complaint;
    QList<QLatin1StringView> m_asked;
};

} // namespace lds::emulator
