#pragma once

#include "sensor_session.h"

#include <QPointer>
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
    void showItem(catalog::ItemId item);             ///< Selects and scrolls to it.

Q_SIGNALS:
    void commandRequested(lds::catalog::ItemId item, lds::catalog::Value value); ///< A switch was used in a row.

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui
