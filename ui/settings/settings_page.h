#pragma once

#include "sensor_session.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

/// The settings of one sensor by menu number: what it holds beside what is wanted, filter, details.
class SettingsPage final : public QWidget {
    Q_OBJECT

public:
    explicit SettingsPage(QWidget* parent = nullptr);
    ~SettingsPage() override;

    void setSession(sensor::SensorSession* session); ///< nullptr: nothing connected.
    void focusFilter();
    void showItem(catalog::ItemId item); ///< Selects and scrolls to it, whatever the filter says.
    /// Makes what stands in an open editor a pending edit. Call it before applying or closing. False when
    /// there is text that is no value: the page shows it and says what to do.
    bool finishEditing();

Q_SIGNALS:
    /// A switch, a command or a bank button was used. The page does not run it; it may need a question.
    void commandRequested(lds::catalog::ItemId item, lds::catalog::Value value);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui
