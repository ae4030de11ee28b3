#pragma once

#include "modbus_link.h"
#include "rtu_bus_pool.h"
#include "scripted_line.h"

#include <memory>
#include <QTest>
#include <vector>

namespace lds::tests {

class KeptFrames final : public ports::FrameLog {
public:
    void record(const ports::Frame& frame) override { frames.append(frame); }
    QList<ports::Frame> with(ports::FrameMeaning meaning) const;
    QList<ports::Frame> frames;
};

/// The ports a test says there are.
class ListedPorts final : public ports::SerialPorts {
public:
    explicit ListedPorts(std::shared_ptr<QList<ports::SerialPortDescription>> listed)
        : m_listed(std::move(listed))
    {}
    QList<ports::SerialPortDescription> list() const override { return *m_listed; }

private:
    std::shared_ptr<QList<ports::SerialPortDescription>> m_listed;
};

/// A link over a bus with what it told.
class RtuSubject {
public:
    RtuSubject(const ports::ConnectionUrl& url, ports::FrameLog& log,
               const std::shared_ptr<modbus::RtuBusPool>& pool);

    std::unique_ptr<modbus::ModbusLink> link;
    QList<ports::LinkReport> reports;
    QList<ports::Outcome> outcomes;
    measurement::MeasurementBatch measurements;
    ports::PollStatistics statistics;

    ports::RequestId read(const QList<catalog::ItemId>& items,
                          ports::Urgency urgency = ports::Urgency::Person);
    ports::RequestId write(const settings::Write& write, int timeoutMs = 0);
    int endings(ports::RequestId id) const;
    ports::Outcome outcome(ports::RequestId id) const;
    ports::LinkState state() const
    {
        return reports.isEmpty() ? ports::LinkState::Closed : reports.last().state;
    }
    ports::OpenFailure failure() const
    {
        return reports.isEmpty() ? ports::OpenFailure::None : reports.last().failure;
    }

private:
    ports::RequestId m_nextId = 1;
};

/// Links in the test's own thread, on one scripted line and the real clock.
class RtuLinkFixture {
public:
    explicit RtuLinkFixture(const QList<int>& units = {1}, bool viewOnly = false);

    ScriptedLine line;
    KeptFrames log;
    std::shared_ptr<QList<ports::SerialPortDescription>> listed =
        std::make_shared<QList<ports::SerialPortDescription>>();
    std::shared_ptr<modbus::RtuBusPool> pool;
    std::vector<std::unique_ptr<RtuSubject>> subjects;

    ports::ConnectionUrl url(int unit) const;
    RtuSubject& add(const ports::ConnectionUrl& url);
    RtuSubject& subject() { return *subjects.front(); }
    void openAll(); ///< Until all are Open, or the test fails.

private:
    bool m_viewOnly = false;
};

} // namespace lds::tests
