#pragma once

#include "connection_url.h"
#include "theme.h"

#include <optional>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace lds::app {

/// What the command line of lds-studio asks for.
struct StudioOptions {
    std::optional<catalog::SensorModel> demo; ///< Connect to an embedded virtual sensor of this type.
    QList<ports::ConnectionUrl> connections;
    QString tourFolder; ///< Render the main screens into it and leave; empty: no.
    std::optional<ui::ThemeMode> theme;
    QString information; ///< --help, --version: print this and leave.
};

/// `arguments` with the program's name first, as main() gets them. The error is a sentence for standard
/// error that says what is wrong and what would be right.
tl::expected<StudioOptions, QString> parseStudioOptions(const QStringList& arguments);

} // namespace lds::app
