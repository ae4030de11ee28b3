#pragma once

#include "fake_sensor.h"
#include "scheduler.h"

#include <memory>
#include <QMap>

namespace lds::support {

/// A link to a FakeSensor, in the caller's thread.
class FakeLink final : public ports::SensorLink {
    Q_OBJECT

public:
    FakeLink(std::shared_ptr<FakeSensor> sensor, ports::Scheduler& scheduler, bool viewOnly);
    ~FakeLink() override;

    bool reaches(ItemId item) const override;
    qint64 nowNs() const { return m_scheduler.nowNs(); }
    qint64 wallMs() const { return m_scheduler.wallMs(); }
    bool isViewOnly() const { return m_viewOnly; }

protected:
    void doOpen() override;
    void doClose() override;
    void doSubmit(const ports::Request& request) override;
    void doPoll(int intervalMs) override;

private:
    std::shared_ptr<FakeSensor> m_sensor;
    ports::Scheduler& m_scheduler;
    bool m_viewOnly;
};

/// Makes links to fake sensors, one sensor for each host and port, over RS-485 for each port, settings and
/// unit; sensors outlive their links, so that they can be prepared before a session opens and asked after
/// it has closed. On a serial line nobody answers where no sensor has been placed.
class FakeLinkFactory final : public ports::LinkFactory {
public:
    explicit FakeLinkFactory(ports::Scheduler& scheduler)
        : m_scheduler(scheduler)
    {}

    ports::LinkPointer create(const ports::ConnectionUrl& url) override;
    /// The sensor behind that host and port, made when it is asked for first.
    FakeSensor& sensor(const ports::ConnectionUrl& url);
    int created() const { return m_created; }
    /// Puts the sensor of one URL behind another; nobody answers at the former any more.
    void move(const ports::ConnectionUrl& from, const ports::ConnectionUrl& to);
    /// Makes somebody answer on a serial line.
    FakeSensor& place(const ports::ConnectionUrl& url);

private:
    std::shared_ptr<FakeSensor> find(const ports::ConnectionUrl& url);

    ports::Scheduler& m_scheduler;
    QMap<QString, std::shared_ptr<FakeSensor>> m_sensors;
    int m_created = 0;
};

/// Lets everything that is posted happen, and what follows from it, without waiting for anything.
void settle();

} // namespace lds::support
