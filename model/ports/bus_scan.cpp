#include "bus_scan.h"

namespace lds::ports {

void BusScan::start(const ScanPlan& plan)
{
    QMetaObject::invokeMethod(
        this, [this, plan] { doStart(plan); }, Qt::QueuedConnection);
}

void BusScan::cancel()
{
    QMetaObject::invokeMethod(
        this, [this] { doCancel(); }, Qt::QueuedConnection);
}

void BusScanDeleter::operator()(BusScan* scan) const { scan->deleteLater(); }

} // namespace lds::ports
