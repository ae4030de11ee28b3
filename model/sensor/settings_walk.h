#pragma once

#include "session_types.h"

namespace lds::sensor {

/// The slow walk through what a PLC or the keypad may change: a few items at a time, round and round.
/// The running bank is in every piece, so that a switched bank is seen at the next step.
class SettingsWalk {
public:
    static constexpr int pieceSize = 8;

    /// `items` in the order of the register table, so that a piece is one message.
    explicit SettingsWalk(const QList<ItemId>& items = {});

    QList<ItemId> next(); ///< Empty when there is nothing to walk through.

private:
    QList<ItemId> m_items;
    bool m_watchesBank = false;
    qsizetype m_at = 0;
};

} // namespace lds::sensor
