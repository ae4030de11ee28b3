#pragma once

#include "session_types.h"

#include <QHash>

namespace lds::sensor {

/// What the sensor was last read to hold, and when.
class HeldValues {
public:
    struct Changes {
        QList<ItemId> items;         ///< Other than before, or read for the first time.
        QList<ExternalChange> moved; ///< Those that were known before.
        bool contains(ItemId item) const { return items.contains(item); }
    };

    const settings::Values& values() const { return m_values; }
    std::optional<Value> find(ItemId item) const;
    qint64 readAtNs(ItemId item) const { return m_readAtNs.value(item, -1); }
    Changes update(const settings::Values& read, qint64 atNs);

private:
    settings::Values m_values;
    QHash<ItemId, qint64> m_readAtNs;
};

} // namespace lds::sensor
