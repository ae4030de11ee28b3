#pragma once

#include "sensor_session.h"

#include <QString>

namespace lds::ui {

/// What is asked before a command that cannot be taken back.
struct CommandQuestion {
    QString title;
    QString consequence; ///< What will happen and what is lost.
    QString action;      ///< The button's word.
};

/// Initialisation, bank copy and communication reset; zero setting and the like are done at once.
bool needsQuestion(catalog::ItemId item);
CommandQuestion commandQuestion(catalog::ItemId item, catalog::Value value,
                                const sensor::SensorSession& session);
/// Why nothing can be written or run now and what to do; empty when it can.
QString whyNotNow(const sensor::SensorSession& session);
QString underWayText(const catalog::SettingItem& item);
QString doneText(const catalog::SettingItem& item, catalog::Value value, catalog::SensorModel model);

} // namespace lds::ui
