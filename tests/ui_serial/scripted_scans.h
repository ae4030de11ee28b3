#pragma once

#include "bus_scan.h"

#include <QPointer>

namespace lds::ui {

/// A scan that does what the test says, in the test's thread.
class ScriptedScan final : public ports::BusScan {
public:
    ports::ScanPlan plan;
    int cancels = 0;

protected:
    void doStart(const ports::ScanPlan& next) override { plan = next; }
    void doCancel() override
    {
        ++cancels;
        Q_EMIT finished(ports::ScanEnd::Cancelled, {});
    }
};

class ScriptedScans final : public ports::BusScanFactory {
public:
    ports::BusScanPointer createScan() override
    {
        latest = new ScriptedScan;
        return ports::BusScanPointer(latest);
    }
    QPointer<ScriptedScan> latest;
};

/// Ports that come and go as the test likes.
class ScriptedPorts final : public ports::SerialPorts {
public:
    QList<ports::SerialPortDescription> list() const override { return now; }
    QList<ports::SerialPortDescription> now;
};

} // namespace lds::ui
