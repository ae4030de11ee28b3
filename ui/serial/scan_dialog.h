#pragma once

#include "bus_scan.h"
#include "scheduler.h"
#include "serial_ports.h"
#include "workspace.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QSpinBox;
class QTableView;
class QVBoxLayout;

namespace lds::ui {

class PortBox;
class ScanFindingsModel;

/// Looks for sensors on an RS-485 line and adds the ones that are chosen to the workspace. What it is given
/// outlives it.
class ScanDialog final : public QDialog {
    Q_OBJECT

public:
    ScanDialog(sensor::Workspace& workspace, const ports::SerialPorts* ports, ports::BusScanFactory& scans,
               ports::Scheduler& scheduler, QWidget* parent = nullptr);
    ~ScanDialog() override;

    void setPort(const QString& port);
    void done(int result) override; ///< A scan under way is cancelled.

Q_SIGNALS:
    void sensorAdded(const lds::ports::ConnectionUrl& url); ///< Connecting has begun.

private:
    void buildFields(QVBoxLayout* column);
    void buildFindings(QVBoxLayout* column);
    void buildButtons(QVBoxLayout* column);
    void start();
    void stop();
    void progressed(const ports::ScanProgress& progress);
    void found(const ports::ScanFinding& finding);
    void finished(ports::ScanEnd end, const QString& detail);
    void setScanning(bool scanning);
    void say(const QString& sentence, bool isError = false);
    void showAdvice();
    void showTicked();
    void addTicked();
    ports::ConnectionUrl urlOf(const ports::ScanFinding& finding) const;
    bool isInList(const ports::ScanFinding& finding) const;
    QString timeLeft(const ports::ScanProgress& progress) const;

    sensor::Workspace& m_workspace;
    ports::BusScanFactory& m_scans;
    ports::Scheduler& m_scheduler;
    ports::BusScanPointer m_scan;
    ScanFindingsModel* m_findings;
    PortBox* m_port;
    QLabel* m_portError;
    QWidget* m_fields = nullptr;
    QRadioButton* m_usual = nullptr;
    QRadioButton* m_every = nullptr;
    QSpinBox* m_first = nullptr;
    QSpinBox* m_last = nullptr;
    QProgressBar* m_progress;
    QLabel* m_state;
    QTableView* m_table = nullptr;
    QLabel* m_advice = nullptr;
    QPushButton* m_startStop = nullptr;
    QPushButton* m_add = nullptr;
    QString m_scannedPort;
    bool m_scanning = false;
    qint64 m_startedNs = 0;
};

} // namespace lds::ui
