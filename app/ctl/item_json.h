#pragma once

#include "catalog.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

namespace lds::ctl {

/// Everything the catalog knows of an item, as the manual prints it: the Modbus number 400101, not the
/// address on the wire. null where there is none. Texts are the English source texts.
QJsonObject itemJson(const catalog::SettingItem& item);
QJsonArray catalogJson(const catalog::Catalog& catalog);

/// Stable words for JSON: "setting", "length", "RW", …
QString roleWord(catalog::Role role);
QString kindWord(catalog::Kind kind);
QString accessWord(catalog::Access access); ///< "R", "W", "RW"; empty for none.

} // namespace lds::ctl
