#pragma once

#include <QString>

namespace lds::ui {

class Theme;

/// The application's style sheet on top of Fusion, in the theme's colours.
QString styleSheet(const Theme& theme);

} // namespace lds::ui
