#include "rtu_link_fixture.h"

#include "bus_member.h"
#include "qt_scheduler.h"

#include <algorithm>

namespace lds::tests {

QList<ports::Frame> KeptFrames::with(ports::FrameMeaning meaning) const
{
    QList<ports::Frame> some = frames;
    some.removeIf([meaning](const ports::Frame& frame) { return frame.meaning != meaning; });
    return some;
}

RtuSubject::RtuSubject(const ports::ConnectionUrl& url, ports::FrameLog& log,
                       const std::shared_ptr<modbus::RtuBusPool>& pool)
    : link(std::make_unique<modbus::ModbusLink>(
          url, std::make_unique<ports::QtScheduler>(), log, modbus::BusMember::maker(pool),
          modbus::ModbusLink::Timing{.connectMs = 0, .probeMs = 60, .requestMs = 60, .silenceMs = 5000}))
{
    QObject* const context = link.get();
    QObject::connect(link.get(), &ports::SensorLink::reported, context,
                     [this](const ports::LinkReport& report) { reports.append(report); });
    QObject::connect(link.get(), &ports::SensorLink::finished, context,
                     [this](const ports::Outcome& outcome) { outcomes.append(outcome); });
    QObject::connect(link.get(), &ports::SensorLink::measured, context,
                     [this](const measurement::MeasurementBatch& batch, const ports::PollStatistics& polls) {
                         measurements += batch;
                         statistics = polls;
                     });
}

ports::RequestId RtuSubject::read(const QList<catalog::ItemId>& items, ports::Urgency urgency)
{
    ports::Request request;
    request.id = m_nextId++;
    request.urgency = urgency;
    request.items = items;
    link->submit(request);
    return request.id;
}

ports::RequestId RtuSubject::write(const settings::Write& wanted, int timeoutMs)
{
    ports::Request request;
    request.id = m_nextId++;
    request.kind = ports::RequestKind::Write;
    request.write = wanted;
    request.timeoutMs = timeoutMs;
    link->submit(request);
    return request.id;
}

int RtuSubject::endings(ports::RequestId id) const
{
    return int(std::ranges::count(outcomes, id, &ports::Outcome::id));
}

ports::Outcome RtuSubject::outcome(ports::RequestId id) const
{
    const auto found = std::ranges::find(outcomes, id, &ports::Outcome::id);
    return found == outcomes.end() ? ports::Outcome() : *found;
}

RtuLinkFixture::RtuLinkFixture(const QList<int>& units, bool viewOnly)
    : m_viewOnly(viewOnly)
{
    pool = std::make_shared<modbus::RtuBusPool>(std::make_unique<ListedPorts>(listed));
    line.units = QSet<int>(units.begin(), units.end());
    for (const int unit : units)
        add(url(unit));
}

ports::ConnectionUrl RtuLinkFixture::url(int unit) const
{
    ports::ConnectionUrl result;
    result.protocol = ports::Protocol::ModbusRtu;
    result.host = line.port();
    result.serial = {230'400, ports::SerialParity::Even};
    result.unit = quint8(unit);
    result.viewOnly = m_viewOnly;
    return result;
}

RtuSubject& RtuLinkFixture::add(const ports::ConnectionUrl& url)
{
    subjects.push_back(std::make_unique<RtuSubject>(url, log, pool));
    return *subjects.back();
}

void RtuLinkFixture::openAll()
{
    for (const auto& subject : subjects)
        subject->link->open();
    for (const auto& subject : subjects)
        QTRY_COMPARE(subject->state(), ports::LinkState::Open);
}

} // namespace lds::tests
