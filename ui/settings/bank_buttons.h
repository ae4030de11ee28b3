#pragma once

#include "sensor_session.h"

#include <QPointer>
#include <QWidget>

class QPushButton;

namespace lds::ui {

/// The banks side by side, the one in use pressed. A click only asks: which one is shown as in use is
/// what the sensor says.
class BankButtons final : public QWidget {
    Q_OBJECT

public:
    explicit BankButtons(QWidget* parent = nullptr);
    void setSession(sensor::SensorSession* session);

Q_SIGNALS:
    void requested(lds::catalog::Value bank); ///< Another bank than the current one was clicked.

private:
    void build();
    void refresh();

    QPointer<sensor::SensorSession> m_session;
    QList<QPushButton*> m_buttons;
};

} // namespace lds::ui
