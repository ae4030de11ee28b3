#include "sensor_link.h"

#include "frame.h"

namespace lds::ports {

void SensorLink::open()
{
    QMetaObject::invokeMethod(
        this, [this] { doOpen(); }, Qt::QueuedConnection);
}

void SensorLink::close()
{
    QMetaObject::invokeMethod(
        this, [this] { doClose(); }, Qt::QueuedConnection);
}

void SensorLink::submit(const Request& request)
{
    QMetaObject::invokeMethod(
        this, [this, request] { doSubmit(request); }, Qt::QueuedConnection);
}

void SensorLink::poll(int intervalMs)
{
    QMetaObject::invokeMethod(
        this, [this, intervalMs] { doPoll(intervalMs); }, Qt::QueuedConnection);
}

void LinkDeleter::operator()(SensorLink* link) const { link->deleteLater(); }

void registerMetaTypes()
{
    qRegisterMetaType<Request>();
    qRegisterMetaType<Outcome>();
    qRegisterMetaType<LinkReport>();
    qRegisterMetaType<PollStatistics>();
    qRegisterMetaType<Failure>();
    qRegisterMetaType<Frame>();
    qRegisterMetaType<ConnectionUrl>();
    qRegisterMetaType<measurement::MeasurementBatch>("lds::measurement::MeasurementBatch");
}

} // namespace lds::ports
