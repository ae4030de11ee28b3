#include "fake_link.h"

#include <QCoreApplication>

namespace lds::support {

FakeLink::FakeLink(std::shared_ptr<FakeSensor> sensor, ports::Scheduler& scheduler, bool viewOnly)
    : m_sensor(std::move(sensor))
    , m_scheduler(scheduler)
    , m_viewOnly(viewOnly)
{}

FakeLink::~FakeLink() = default;

bool FakeLink::reaches(ItemId item) const
{
    return catalog::hlG2(item).modbus.has_value() && !m_sensor->m_hidden.contains(item);
}

void FakeLink::doOpen() { m_sensor->opening(this); }

void FakeLink::doClose() { m_sensor->closing(); }

void FakeLink::doSubmit(const ports::Request& request) { m_sensor->arrived(request); }

void FakeLink::doPoll(int intervalMs) { m_sensor->m_pollIntervalMs = intervalMs; }

ports::LinkPointer FakeLinkFactory::create(const ports::ConnectionUrl& url)
{
    ++m_created;
    return ports::LinkPointer(new FakeLink(find(url), m_scheduler, url.viewOnly));
}

FakeSensor& FakeLinkFactory::sensor(const ports::ConnectionUrl& url) { return *find(url); }

namespace {

QString placeOf(const ports::ConnectionUrl& url)
{
    if (url.protocol == ports::Protocol::ModbusTcp)
        return QStringLiteral("%1:%2").arg(url.host).arg(url.port);
    return QStringLiteral("%1 %2 %3 %4")
        .arg(url.host)
        .arg(url.serial.baud)
        .arg(int(url.serial.parity))
        .arg(url.unit);
}

} // namespace

FakeSensor& FakeLinkFactory::place(const ports::ConnectionUrl& url)
{
    FakeSensor& sensor = *find(url);
    sensor.allowOpenings();
    return sensor;
}

void FakeLinkFactory::move(const ports::ConnectionUrl& from, const ports::ConnectionUrl& to)
{
    m_sensors.insert(placeOf(to), m_sensors.take(placeOf(from)));
}

std::shared_ptr<FakeSensor> FakeLinkFactory::find(const ports::ConnectionUrl& url)
{
    auto& sensor = m_sensors[placeOf(url)];
    if (!sensor) {
        sensor = std::make_shared<FakeSensor>(url.sensor.value_or(catalog::SensorModel::HlG203));
        if (url.protocol == ports::Protocol::ModbusRtu)
            sensor->failOpenings(ports::OpenFailure::NoAnswer);
    }
    return sensor;
}

namespace {

class EventCounter final : public QObject {
public:
    EventCounter() { QCoreApplication::instance()->installEventFilter(this); }
    int take() { return std::exchange(m_count, 0); }

protected:
    bool eventFilter(QObject*, QEvent*) override
    {
        ++m_count;
        return false;
    }

private:
    int m_count = 0;
};

} // namespace

void settle()
{
    EventCounter delivered;
    do {
        delivered.take();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    } while (delivered.take() > 0);
}

} // namespace lds::support
