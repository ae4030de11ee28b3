#include "link_fixture.h"

#include "tcp_connection.h"

#include <algorithm>
#include <QCoreApplication>

namespace lds::tests {

QList<ports::Frame> RecordingLog::frames(ports::FrameMeaning meaning) const
{
    QList<ports::Frame> some;
    for (const ports::Frame& frame : frames()) {
        if (frame.meaning == meaning)
            some.append(frame);
    }
    return some;
}

LinkFixture::LinkFixture(bool viewOnly)
{
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = server.port();
    url.viewOnly = viewOnly;
    auto scheduler = std::make_unique<ports::ManualScheduler>();
    clock = scheduler.get();
    link =
        std::make_unique<modbus::ModbusLink>(url, std::move(scheduler), log, modbus::TcpConnection::maker());
    QObject* const context = link.get();
    QObject::connect(link.get(), &ports::SensorLink::reported, context,
                     [this](const ports::LinkReport& report) { reports.append(report); });
    QObject::connect(link.get(), &ports::SensorLink::finished, context,
                     [this](const ports::Outcome& outcome) { outcomes.append(outcome); });
    QObject::connect(link.get(), &ports::SensorLink::measured, context,
                     [this](const measurement::MeasurementBatch& batch, const ports::PollStatistics& polls) {
                         measurements += batch;
                         statistics = polls;
                         ++batches;
                     });
    QObject::connect(link.get(), &ports::SensorLink::pollRefused, context,
                     [this](const ports::Failure& refusal) { refusals.append(refusal); });
}

void LinkFixture::openLink()
{
    link->open();
    QTRY_COMPARE(state(), ports::LinkState::Open);
    m_opened = server.received.size();
}

ports::RequestId LinkFixture::read(const QList<catalog::ItemId>& items, ports::Urgency urgency)
{
    ports::Request request;
    request.id = m_nextId++;
    request.kind = ports::RequestKind::Read;
    request.urgency = urgency;
    request.items = items;
    link->submit(request);
    return request.id;
}

ports::RequestId LinkFixture::write(const settings::Write& wanted, int timeoutMs)
{
    ports::Request request;
    request.id = m_nextId++;
    request.kind = ports::RequestKind::Write;
    request.write = wanted;
    request.timeoutMs = timeoutMs;
    link->submit(request);
    return request.id;
}

int LinkFixture::endings(ports::RequestId id) const
{
    return int(std::ranges::count(outcomes, id, &ports::Outcome::id));
}

ports::Outcome LinkFixture::outcome(ports::RequestId id) const
{
    const auto found = std::ranges::find(outcomes, id, &ports::Outcome::id);
    return found == outcomes.end() ? ports::Outcome() : *found;
}

void settle()
{
    for (int i = 0; i < 20; ++i)
        QCoreApplication::processEvents();
}

} // namespace lds::tests
