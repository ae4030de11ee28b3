#pragma once

#include "virtual_sensor.h"

#include <QList>
#include <QString>

namespace lds::emulator {

/// The digits of one item, or of several that make one thing (the octets of an address), as the display
/// shows them for entry: every digit has its place, "+05.000", "192.168.001.006". Widths, decimals and the
/// sign come from the item's limits in the catalog.
class EntryDigits {
public:
    EntryDigits(const QList<catalog::ItemId>& items, const VirtualSensor& sensor);

    const QString& text() const { return m_text; }
    int edited() const { return m_editable.value(m_cursor, -1); } ///< Index in text().
    QString unit() const;                                         ///< "mm", "ms" or nothing.

    void toFirst() { m_cursor = 0; }
    bool toNext(); ///< False at the last digit, which stays.
    /// The digit under the cursor up or down by one, round after 9 and 0; a sign changes either way.
    void turn(int by);
    /// What the digits stand for; may be anything that fits in them.
    QList<ItemWrite> writes() const;

private:
    struct Part {
        catalog::ItemId item;
        int start = 0; ///< In m_text.
        int length = 0;
        bool isSigned = false;
        catalog::Value resolution = 1;
    };
    void append(catalog::ItemId item, const VirtualSensor& sensor);

    QString m_text;
    QList<Part> m_parts;
    QList<int> m_editable; ///< Indices of the sign and the digits.
    int m_cursor = 0;      ///< In m_editable.
};

/// A stored length or factor as it is read on the display, with its sign: "+5.0000".
QString setValueText(catalog::ItemId item, const VirtualSensor& sensor);
/// A measured value (0.1 µm) in mm with `decimals` (0 … 4) of them, the rest cut off (§4.8.1).
QString measuredText(catalog::Value value, int decimals);

} // namespace lds::emulator
