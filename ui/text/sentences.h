#pragma once

#include "frame.h"
#include "sensor_session.h"

#include <QString>

/// What happened, where, and what to do about it, in the person's language. One sentence for each code of
/// the core, so that no page words the same trouble differently.
namespace lds::ui {

QString parseFailureSentence(const catalog::SettingItem& item, catalog::SensorModel model,
                             const settings::ParseFailure& failure, const QString& text);
/// `state` lets the sentence name the numbers ("HIGH − LOW is 0.0100 mm and must be more than 0.0200 mm …").
QString refusalSentence(const settings::Refusal& refusal, catalog::SensorModel model,
                        const settings::Values& state);
/// Why a request failed and what to do; `item` may be nullptr.
QString failureSentence(const ports::Failure& failure, const catalog::SettingItem* item);
/// Why a connection is not there and what to check.
QString openFailureSentence(const ports::LinkReport& report, const ports::ConnectionUrl& url);
QString connectionWord(sensor::Connection connection); ///< "Connected", "Reconnecting…", …
QString savedWord(sensor::Saved saved); ///< "Saved", "Not saved in the sensor", "Not known whether saved"
/// "read 400101–400171", "refused: value out of range", …
QString frameSentence(const ports::Frame& frame);
/// Why an item cannot be changed or reached here; empty when it can.
QString unreachableReason(const catalog::SettingItem& item, const sensor::SensorSession& session);

} // namespace lds::ui
