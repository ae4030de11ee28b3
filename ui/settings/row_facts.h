#pragma once

#include "sensor_session.h"
#include "setting_row.h"

#include <optional>
#include <QString>

namespace lds::ui {

/// What one row of the settings says about one sensor, read from the session when asked. A short-lived
/// value: make one, ask, drop it. All texts are in the person's language.
class RowFacts {
public:
    RowFacts(const SettingRow& row, const sensor::SensorSession& session)
        : m_row(row)
        , m_session(session)
    {}

    // --- What the sensor holds
    bool isKnown() const; ///< Every item of the row has been read.
    /// Shown though it may not be what the sensor holds now (not connected).
    bool isStale() const { return isKnown() && m_session.isStale(); }
    QString heldText() const; ///< Without unit; empty when not known.
    QString
    missingWord() const; ///< "not reachable over Modbus", "not read yet"; empty when known or never readable.

    // --- What is wanted
    bool isEdited() const;
    bool hasConflict() const;
    QString wantedText() const; ///< The edit, or what is held; without unit.
    /// For an item of the row: the edit, or what is held.
    std::optional<catalog::Value> wanted(const catalog::SettingItem& item) const;
    QString baseText() const; ///< What the sensor held when the edit was made.
    /// The rules the row's items would break if all edits were applied, as sentences.
    QStringList problemSentences(const QList<settings::Refusal>& problems) const;
    /// The same for other values than the pending ones, in `state`.
    QStringList problemSentences(const QList<settings::Refusal>& problems,
                                 const settings::Values& state) const;

    // --- What it is
    QString unit() const;
    QString range() const;
    QString defaultText() const; ///< Empty when the manual names none.
    bool hasDefault() const;
    settings::Write defaults() const;
    bool isNumber() const; ///< Right-aligned with tabular figures; choices are words.

    // --- What can be done
    QString whyNot() const;  ///< Why the row cannot be reached or changed here; empty when it can.
    bool isEditable() const; ///< A pending edit can be made.
    bool isUsable() const;   ///< A switch, command or procedure can be used now.

    static settings::Values
    wantedValues(const sensor::SensorSession& session); ///< Held, overlaid with the edits.

private:
    QString joined(const QList<QString>& parts) const;
    QString text(const QList<catalog::Value>& values) const;

    const SettingRow& m_row;
    const sensor::SensorSession& m_session;
};

} // namespace lds::ui
