#pragma once

#include "recent_connections.h"
#include "serial_ports.h"
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
    /// `ports` may be nullptr; else it outlives the dialog.
    ConnectDialog(sensor::Workspace& workspace, RecentConnections recent,
                  const ports::SerialPorts* ports = nullptr, QWidget* parent = nullptr);

    void done(int result) override;

Q_SIGNALS:
    void scanRequested(const QString& port); ///< The dialog has closed.

private:
    void buildRecent(QVBoxLayout* column);
    void start();
    void follow();
    void connected();
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
    QList<ports::ConnectionUrl> m_further;     ///< To be connected when the first one stands.
    bool m_isNew = false;                      ///< It is in the list only for this attempt.
};

} // namespace lds::ui
