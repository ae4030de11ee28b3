#pragma once

#include "catalog.h"

#include <optional>
#include <QList>
#include <QString>

namespace lds::ctl {

/// What a key of the command line stands for: one item, or the items that are written together.
struct Target {
    QString key;                  ///< "highSetValue", "ipAddress"
    QList<catalog::ItemId> items; ///< One; four for an address, first octet first.
    bool isGroup() const { return items.size() > 1; }
};

/// Nothing when there is no such key. Besides the catalog's keys, the name of a write group ("ipAddress").
std::optional<Target> findTarget(const QString& key);

/// The group an item is written with; empty when it stands alone.
QString groupKeyOf(catalog::ItemId item);

/// "Unknown key …, did you mean …?": a known key near to what was typed is suggested.
QString unknownKeyMessage(const QString& key);

} // namespace lds::ctl
