#pragma once

#include "communication_change.h"

#include <QDialog>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace lds::ui {

/// Changes address, speed and parity of one sensor on RS-485, with every step in sight; says where the sensor
/// is when something went wrong, and offers the way back. What it is given outlives it, except the session.
class ChangeCommunicationDialog final : public QDialog {
    Q_OBJECT

public:
    ChangeCommunicationDialog(sensor::SensorSession& session, const sensor::Workspace& workspace,
                              ports::LinkFactory& links, ports::Scheduler& scheduler,
                              QWidget* parent = nullptr);

    procedures::CommunicationChange& change() { return m_change; }
    void done(int result) override; ///< Only when nothing runs; else it asks to stop.

Q_SIGNALS:
    void moved(const lds::ports::ConnectionUrl& url); ///< The sensor is reached there from now on.

private:
    using State = procedures::CommunicationChange::State;
    struct StepLine {
        State step;
        QLabel* icon;
        QLabel* text;
    };

    void buildFields(QVBoxLayout* column);
    void buildSteps(QVBoxLayout* column);
    void buildButtons(QVBoxLayout* column);
    void start();
    void refresh();
    void showSteps();
    void showSentence();
    void showButtons();
    ports::SerialSettings serial() const;
    quint8 unit() const;

    QPointer<sensor::SensorSession> m_session;
    procedures::CommunicationChange m_change;
    QWidget* m_fields = nullptr;
    QSpinBox* m_unit = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_parity = nullptr;
    QLabel* m_problem = nullptr; ///< Beside the fields: why it cannot begin.
    QList<StepLine> m_lines;
    QLabel* m_sentence = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_search = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_start = nullptr;
};

} // namespace lds::ui
