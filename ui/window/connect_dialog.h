#pragma once

#include "recent_connections.h"
#include "workspace.h"

#include <QDialog>
#include <QPointer>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace lds::ui {

class ConnectionForm;

/// Asks for a connection, makes it, and stays open until it stands: what goes wrong is said here, with
/// everything that was entered still in its fields.
class ConnectDialog final : public QDialog {
    Q_OBJECT

public:
    ConnectDialog(sensor::Workspace& workspace, RecentConnections recent, QWidget* parent = nullptr);

    void done(int result) override;

private:
    void buildRecent(QVBoxLayout* column);
    void start();
    void follow();
    void giveUp(); ///< Takes back a sensor that never answered.
    void showFailure(const QString& sentence);
    void setConnecting(bool connecting);

    sensor::Workspace& m_workspace;
    RecentConnections m_recent;
    ConnectionForm* m_form;
    QListWidget* m_recentList = nullptr;
    QProgressBar* m_progress;
    QLabel* m_state;
    QPushButton* m_connect;
    QPointer<sensor::SensorSession> m_session; ///< The one being connected.
    bool m_isNew = false;                      ///< It is in the list only for this attempt.
};

} // namespace lds::ui
