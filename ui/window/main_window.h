#pragma once

#include "bus_scan.h"
#include "message_log.h"
#include "serial_ports.h"
#include "workspace.h"

#include <memory>
#include <QMainWindow>

class QDockWidget;
class QSettings;

namespace lds::ui {

/// The window: toolbar, sensors, readout, pages, status. What it is given must outlive it.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(sensor::Workspace& workspace, MessageLog& log, ports::Scheduler& scheduler,
               QSettings& settings);
    ~MainWindow() override;

    enum class Page { Settings, Trend, Messages };
    void showPage(Page page);
    /// Offers "Try with a virtual sensor"; demoRequested() follows when it is chosen.
    void offerDemo();
    /// A dock of the program's own, to be found in the View menu; hidden unless it was left open.
    void addDock(QDockWidget* dock);
    /// What RS-485 needs: the ports to choose from, scans of a line, and links for the guided change of a
    /// sensor's settings on it. Without it there is neither scan nor guided change, and ports are typed.
    void setSerial(const ports::SerialPorts& ports, ports::BusScanFactory& scans, ports::LinkFactory& links);
    void openConnectDialog();
    void openScan(const QString& port = {});
    void openChangeCommunication();
    void openReview();

Q_SIGNALS:
    void demoRequested();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    void connectActions();
    void connectCommandActions();
    void connectViewActions();
    void watchSession(sensor::SensorSession* session);
    void setSession(sensor::SensorSession* session);
    void showPeer();
    void updateActions();
    void updateLaser();
    void updateTitle();
    bool finishEditing(); ///< False when an open editor holds text that is no value.
    void openRename();
    void removeCurrent();
    void chooseType();
    void runOnCurrent(catalog::ItemId item, catalog::Value value);
    void jumpTo(catalog::ItemId item);
    void showAbout();
    void restore();
    void store();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui
