#include "held_values.h"

namespace lds::sensor {

std::optional<Value> HeldValues::find(ItemId item) const
{
    const auto found = m_values.constFind(item);
    return found == m_values.constEnd() ? std::nullopt : std::optional(*found);
}

HeldValues::Changes HeldValues::update(const settings::Values& read, qint64 atNs)
{
    Changes changes;
    for (auto it = read.constBegin(); it != read.constEnd(); ++it) {
        const std::optional<Value> before = find(it.key());
        m_readAtNs.insert(it.key(), atNs);
        if (before == it.value())
            continue;
        m_values.insert(it.key(), it.value());
        changes.items.append(it.key());
        if (before)
            changes.moved.append({it.key(), *before, it.value()});
    }
    return changes;
}

} // namespace lds::sensor
