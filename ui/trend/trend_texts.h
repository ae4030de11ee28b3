#pragma once

#include <QCoreApplication>

namespace lds::ui {

/// Translates the texts of the trend's parts that are no QObjects.
struct TrendTexts {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::TrendTexts)
};

} // namespace lds::ui
