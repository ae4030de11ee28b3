#pragma once

#include "workspace.h"

#include <functional>

class QWidget;

namespace lds::ui {

/// What would be lost if these sensors were left now, one line a sensor; empty when nothing.
QStringList lossesOf(const QList<sensor::SensorSession*>& sessions);

/// Asks before edits or unsaved settings are left behind. Cancel is the default. `leave` runs when the
/// person goes on; it runs at once when nothing would be lost.
void askBeforeLeaving(QWidget* window, const QList<sensor::SensorSession*>& sessions, const QString& title,
                      const QString& action, std::function<void()> leave);

} // namespace lds::ui
