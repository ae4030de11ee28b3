#pragma once

#include "manual_scheduler.h"
#include "modbus_link.h"
#include "scripted_server.h"

#include <QMutex>
#include <QTest>

namespace lds::tests {

/// Keeps every frame; may be fed from any thread.
class RecordingLog final : public ports::FrameLog {
public:
    void record(const ports::Frame& frame) override
    {
        const QMutexLocker locker(&m_mutex);
        m_frames.append(frame);
    }
    QList<ports::Frame> frames() const
    {
        const QMutexLocker locker(&m_mutex);
        return m_frames;
    }
    QList<ports::Frame> frames(ports::FrameMeaning meaning) const;

private:
    mutable QMutex m_mutex;
    QList<ports::Frame> m_frames;
};

/// A link in the test's own thread, on a real socket to a scripted server and on a clock that stands
/// still: no timeout comes before the test moves it.
class LinkFixture {
public:
    explicit LinkFixture(bool viewOnly = false);

    ScriptedServer server;
    RecordingLog log;
    ports::ManualScheduler* clock = nullptr; ///< Owned by the link.
    std::unique_ptr<modbus::ModbusLink> link;

    QList<ports::LinkReport> reports;
    QList<ports::Outcome> outcomes;
    QList<measurement::Measurement> measurements;
    int batches = 0;
    ports::PollStatistics statistics;
    QList<ports::Failure> refusals;

    void openLink(); ///< Until Open, or the test fails.
    ports::LinkState state() const
    {
        return reports.isEmpty() ? ports::LinkState::Closed : reports.last().state;
    }
    ports::OpenFailure failure() const
    {
        return reports.isEmpty() ? ports::OpenFailure::None : reports.last().failure;
    }

    ports::RequestId read(const QList<catalog::ItemId>& items,
                          ports::Urgency urgency = ports::Urgency::Person);
    ports::RequestId write(const settings::Write& write, int timeoutMs = 0);
    /// How often the request has ended.
    int endings(ports::RequestId id) const;
    ports::Outcome outcome(ports::RequestId id) const;
    /// Has the server got this many requests beyond the probe's?
    bool serverHas(int requests) const { return server.received.size() >= m_opened + requests; }
    qsizetype sinceOpening() const { return server.received.size() - m_opened; }

private:
    ports::RequestId m_nextId = 1;
    qsizetype m_opened = 0;
};

/// Lets everything posted happen.
void settle();

} // namespace lds::tests
