#pragma once

#include "sensor_session.h"
#include "setting_row.h"

#include <QPointer>
#include <QString>

class QWidget;

namespace lds::ui {

/// What the delegate and the tree ask of an editor in a row. The widget is one, too: see rowEditor().
class RowEditor {
public:
    RowEditor(const SettingRow& row, sensor::SensorSession& session)
        : m_row(row)
        , m_session(&session)
    {}
    virtual ~RowEditor() = default;

    virtual QString text() const = 0;
    /// Puts back what was typed before and is no value.
    virtual void restore(const QString& text) = 0;
    /// What is wrong with the text and what to do; empty when it can be committed.
    virtual QString error() const = 0;
    /// Makes the text a pending edit. Only without an error().
    virtual void commit() = 0;
    /// Shows again what is wrong, where the person looks.
    virtual void insist() = 0;

    bool isAcceptable() const { return error().isEmpty(); }
    const SettingRow& row() const { return m_row; }
    /// The person gave up: nothing of it is to be kept.
    bool isAbandoned() const { return m_abandoned; }
    void abandon() { m_abandoned = true; }

protected:
    /// Sentences about the row's items: rules that all edits and this one together would break.
    QString brokenRules(const settings::Write& write) const;
    sensor::SensorSession* session() const { return m_session; }

private:
    const SettingRow& m_row;
    QPointer<sensor::SensorSession> m_session;
    bool m_abandoned = false;
};

RowEditor* rowEditor(QWidget* widget); ///< nullptr when the widget is none.

} // namespace lds::ui
