#pragma once

#include "sensor_session.h"

#include <QList>
#include <QWidget>

namespace lds::ui {

class ActionButton;
class Pill;
class WindowActions;

/// The row of buttons on top: what is done most, the one blue button, and whether the sensor's memory
/// holds what it works with. With little width the side buttons shrink to their icons.
class ToolRow final : public QWidget {
    Q_OBJECT

public:
    explicit ToolRow(const WindowActions& actions, QWidget* parent = nullptr);
    /// The permanent sign of saved or not; nullptr: no sensor, no sign.
    void showSaved(const sensor::SensorSession* session);
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void fit();
    int widthOfTheRest() const; ///< All but the shrinking buttons.

    QList<ActionButton*> m_shrinking; ///< In the order in which they give up their texts.
    Pill* m_saved;
};

} // namespace lds::ui
