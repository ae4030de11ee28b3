#pragma once

#include "sensor_session.h"

#include <QStringList>

namespace lds::ui {

/// An apply's end for a person: one line that counts, and a sentence for everything that did not go as
/// wanted.
struct ApplySummary {
    QString headline;
    QStringList sentences; ///< Empty when all is done.
    QString byTheWay;      ///< What the sensor changed by itself; empty when nothing.
};

ApplySummary summarize(const sensor::ApplyReport& report, const sensor::SensorSession& session);
/// "IP Address" for its four octets, the item's name otherwise.
QString writeName(const settings::Write& write, const sensor::SensorSession& session);

} // namespace lds::ui
