#pragma once

#include "catalog.h"

#include <QCoreApplication>
#include <QString>

namespace lds::ui {

/// The translation context of all sentences.
struct Sentences {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::Sentences)
};

/// "from −9.5000 to +9.5000 mm": what an item takes, inside a sentence.
QString limitsText(const catalog::SettingItem& item, catalog::SensorModel model);

/// "no such address", "value out of range": a Modbus error code (§5.2.2) in words.
QString exceptionWords(int code);

} // namespace lds::ui
