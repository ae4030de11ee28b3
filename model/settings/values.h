#pragma once

#include "item_id.h"
#include "setting_item.h"

#include <QList>
#include <QMap>

namespace lds::settings {

using catalog::ItemId;
using catalog::Value;

/// Values by item, sparse: an item that is absent is not known. Implicitly shared, so it crosses
/// threads as a value.
using Values = QMap<ItemId, Value>;

struct ItemValue {
    ItemId item;
    Value value;
    friend bool operator==(const ItemValue&, const ItemValue&) = default;
};

/// Values that go out in one message: one item, or the items of one WriteGroup (an IP address).
using Write = QList<ItemValue>;

} // namespace lds::settings
