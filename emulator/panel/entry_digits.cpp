#include "entry_digits.h"

#include <algorithm>
#include <cstdlib>

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

/// Decimals of the wire unit: 0.1 µm in mm, and 1/10000 of a factor.
constexpr int wireDecimals = 4;

bool hasDecimals(Kind kind) { return kind == Kind::Length || kind == Kind::Factor; }

int digitCount(Value value) { return int(QString::number(std::abs(value)).size()); }

Value powerOfTen(int exponent) { return exponent > 0 ? 10 * powerOfTen(exponent - 1) : 1; }

/// Of an item on this type of sensor: 4 with a resolution of 0.1 µm, 3 with 1 µm, 2 with 10 µm.
int decimalsOf(const SettingItem& item, const Limits& limits)
{
    return hasDecimals(item.kind) ? wireDecimals - (digitCount(limits.resolution) - 1) : 0;
}

/// `value` in units of the last decimal: 5000 with three decimals is "05.000" at six characters.
QString fixed(qint64 value, int integerDigits, int decimals)
{
    QString digits = QString::number(std::abs(value)).rightJustified(integerDigits + decimals, u'0');
    if (decimals > 0)
        digits.insert(digits.size() - decimals, u'.');
    return digits;
}

QChar separatorBefore(const SettingItem& item) { return item.kind == Kind::Octet ? u'.' : u'/'; }

} // namespace

EntryDigits::EntryDigits(const QList<ItemId>& items, const VirtualSensor& sensor)
{
    for (const ItemId item : items)
        append(item, sensor);
}

void EntryDigits::append(ItemId id, const VirtualSensor& sensor)
{
    const SettingItem& item = hlG2(id);
    const Limits& limits = item.limitsFor(sensor.model());
    const int decimals = decimalsOf(item, limits);
    const Value largest = std::max(std::abs(limits.minimum), std::abs(limits.maximum));
    const int integerDigits = digitCount(largest / powerOfTen(hasDecimals(item.kind) ? wireDecimals : 0));
    const Value value = sensor.memory().value(id);

    if (!m_text.isEmpty())
        m_text += separatorBefore(item);
    Part part{id, int(m_text.size()), 0, limits.minimum < 0, std::max<Value>(1, limits.resolution)};
    if (part.isSigned)
        m_text += value < 0 ? u'-' : u'+';
    m_text += fixed(value / part.resolution, integerDigits, decimals);
    part.length = int(m_text.size()) - part.start;
    for (int index = part.start; index < m_text.size(); ++index) {
        if (m_text[index] != u'.')
            m_editable.append(index);
    }
    m_parts.append(part);
}

QString EntryDigits::unit() const
{
    const Kind kind = hlG2(m_parts.first().item).kind;
    return kind == Kind::Length ? u"mm"_s : kind == Kind::Duration ? u"ms"_s : QString();
}

bool EntryDigits::toNext()
{
    if (m_cursor + 1 >= m_editable.size())
        return false;
    ++m_cursor;
    return true;
}

void EntryDigits::turn(int by)
{
    QChar& character = m_text[edited()];
    if (character.isDigit())
        character = QChar(u'0' + (character.digitValue() + by + 10) % 10);
    else
        character = character == u'-' ? u'+' : u'-';
}

QList<ItemWrite> EntryDigits::writes() const
{
    QList<ItemWrite> result;
    for (const Part& part : m_parts) {
        QString digits = m_text.mid(part.start, part.length);
        digits.remove(u'.');
        // Nine digits at most, so that no entry overflows.
        result.append({part.item, digits.toInt() * part.resolution});
    }
    return result;
}

QString setValueText(ItemId id, const VirtualSensor& sensor)
{
    const SettingItem& item = hlG2(id);
    const Limits& limits = item.limitsFor(sensor.model());
    const Value value = sensor.memory().value(id);
    const QString digits = fixed(value / std::max<Value>(1, limits.resolution), 1, decimalsOf(item, limits));
    return (value < 0 ? u'-' : u'+') + digits;
}

QString measuredText(Value value, int decimals)
{
    const Value cut = value / powerOfTen(wireDecimals - decimals); // towards zero
    return (cut < 0 ? u'-' : u'+') + fixed(cut, 1, decimals);
}

} // namespace lds::emulator
