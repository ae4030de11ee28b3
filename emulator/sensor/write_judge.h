#pragma once

#include "settings_memory.h"

#include <QList>
#include <QString>
#include <tl/expected.hpp>

namespace lds::emulator {

struct ItemWrite {
    catalog::ItemId item;
    catalog::Value value;
    bool operator==(const ItemWrite&) const = default;
};

/// Why a write is a data error; the text is for logs and test output, never for a screen.
struct Objection {
    catalog::ItemId item;
    QString reason;
};

/// The sensor's judgment of the writes of one message, its own reading of the manual: ranges of the type,
/// rounding at the setting resolution (§1.4), and the conditions between items, of the state that all
/// values of the message make together (§5.2.3). Answers with the values as they will be stored.
tl::expected<QList<ItemWrite>, Objection> judgeWrites(const SettingsMemory& memory,
                                                      const QList<ItemWrite>& writes);

/// The conditions that always hold between the values of a memory, in the given bank: for a state file.
tl::expected<void, Objection> judgeStored(const SettingsMemory& memory, int bank);

/// One value by itself: range, choice and resolution of the type. Answers with the rounded value.
tl::expected<catalog::Value, Objection> judgeValue(catalog::SensorModel model, ItemWrite write);

} // namespace lds::emulator
