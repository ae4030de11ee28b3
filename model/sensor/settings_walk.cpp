#include "settings_walk.h"

namespace lds::sensor {

SettingsWalk::SettingsWalk(const QList<ItemId>& items)
    : m_items(items)
    , m_watchesBank(items.contains(ItemId::BankSwitching))
{
    m_items.removeAll(ItemId::BankSwitching);
}

QList<ItemId> SettingsWalk::next()
{
    if (m_at >= m_items.size())
        m_at = 0;
    QList<ItemId> piece = m_items.mid(m_at, pieceSize);
    m_at += pieceSize;
    if (m_watchesBank)
        piece.prepend(ItemId::BankSwitching);
    return piece;
}

} // namespace lds::sensor
