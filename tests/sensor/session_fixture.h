#pragma once

#include "catalog.h"
#include "fake_link.h"
#include "manual_scheduler.h"
#include "sensor_session.h"

#include <memory>
#include <QSignalSpy>
#include <QtTest>

namespace lds::sensor {

/// A session on a fake sensor, and a clock that only the test moves.
class SessionFixture {
public:
    explicit SessionFixture(bool viewOnly = false,
                            std::optional<catalog::SensorModel> stated = catalog::SensorModel::HlG203)
    {
        ports::registerMetaTypes();
        url.host = QStringLiteral("127.0.0.1");
        url.viewOnly = viewOnly;
        url.sensor = stated;
        session = std::make_unique<SensorSession>(url, links, scheduler);
        QObject::connect(session.get(), &SensorSession::applyFinished, session.get(),
                         [this](const ApplyReport& report) { applies.append(report); });
        QObject::connect(session.get(), &SensorSession::commandFinished, session.get(),
                         [this](const CommandReport& report) { commands.append(report); });
        QObject::connect(session.get(), &SensorSession::externallyChanged, session.get(),
                         [this](const QList<ExternalChange>& changes) { external += changes; });
        QObject::connect(session.get(), &SensorSession::conflictsFound, session.get(),
                         [this](const QList<ItemId>& items) { conflicts += items; });
    }
    ~SessionFixture()
    {
        session.reset();
        support::settle();
    }
    SessionFixture(const SessionFixture&) = delete;
    SessionFixture& operator=(const SessionFixture&) = delete;

    support::FakeSensor& sensor() { return links.sensor(url); }

    void openReady()
    {
        session->open();
        support::settle();
        QCOMPARE(session->connection(), Connection::Ready);
        sensor().forgetRequests();
    }

    /// Lets time go by in small pieces, and everything happen that falls due.
    void pass(int ms)
    {
        for (int gone = 0; gone < ms; gone += 10) {
            scheduler.advanceMs(10);
            support::settle();
        }
    }
    /// Long enough for the slow walk to come round to every setting.
    void passWalk() { pass(10'000); }

    void edit(ItemId item, Value value) { session->edit({{item, value}}); }
    Value wanted(ItemId item) const
    {
        const auto edit = session->pending().find(item);
        return edit ? edit->wanted : Value(-12345678);
    }
    void applyAndSettle()
    {
        QVERIFY(session->apply());
        support::settle();
    }
    void runAndSettle(ItemId item, Value value)
    {
        QVERIFY(session->run(item, value));
        support::settle();
    }
    /// Somebody else switches, changes or measures; the fake's own words.
    measurement::Measurement sample(Value value)
    {
        measurement::Measurement one;
        one.monotonicNs = scheduler.nowNs();
        one.wallMs = scheduler.wallMs();
        one.value = value;
        one.kind = measurement::ValueKind::Valid;
        return one;
    }

    ports::ManualScheduler scheduler;
    support::FakeLinkFactory links{scheduler};
    ports::ConnectionUrl url;
    std::unique_ptr<SensorSession> session;
    QList<ApplyReport> applies;
    QList<CommandReport> commands;
    QList<ExternalChange> external;
    QList<ItemId> conflicts;
};

/// Ten settings that no rule ties together, with other values than the factory's.
inline const QList<settings::ItemValue> tenEdits{
    {ItemId::SamplingFrequency, 2},  {ItemId::AverageTimes, 1},
    {ItemId::Span, 20000},           {ItemId::Offset, 500},
    {ItemId::DisplayDigit, 2},       {ItemId::DisplayInversion, 1},
    {ItemId::AlarmDelayCount, 77},   {ItemId::OutputDelayTimerSetting, 7},
    {ItemId::AlarmDigitalOutput, 1}, {ItemId::TeachingMode, 3},
};

inline QList<ItemId> itemsOf(const QList<settings::ItemValue>& values)
{
    QList<ItemId> items;
    for (const auto& each : values)
        items.append(each.item);
    return items;
}

inline QList<ItemId> writtenItems(const QList<WriteResult>& results)
{
    QList<ItemId> items;
    for (const WriteResult& result : results) {
        for (const settings::ItemValue& each : result.write)
            items.append(each.item);
    }
    return items;
}

} // namespace lds::sensor
