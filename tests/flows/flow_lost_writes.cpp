#include "demo_sensor.h"
#include "frame.h"
#include "modbus_link_factory.h"
#include "qt_scheduler.h"
#include "sensor_session.h"

#include <memory>
#include <QSignalSpy>
#include <QTest>

using namespace lds;
using catalog::ItemId;
using catalog::Role;
using catalog::Value;
using emulator::Fault;
using emulator::FaultOn;
using emulator::SensorStation;

namespace {

class NoLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override {}
};

/// The real session and link against the virtual sensor on a real socket, and answers that go missing.
class Bench {
public:
    Bench()
    {
        device.start();
        if (!QTest::qWaitFor([this] { return device.port() != 0; }))
            qFatal("the virtual sensor does not start");
        ports::ConnectionUrl url;
        url.host = QStringLiteral("127.0.0.1");
        url.port = device.port();
        url.sensor = catalog::SensorModel::HlG203;
        session = std::make_unique<sensor::SensorSession>(url, links, scheduler);
        session->open();
    }
    bool becomesReady()
    {
        return QTest::qWaitFor([this] { return session->canWrite(); }, 20'000);
    }
    /// Write requests of both functions that reached the sensor, carried out or not.
    int writeRequests()
    {
        return device.ask([](SensorStation& station) {
            return station.modbusServer().requestCount(0x06) + station.modbusServer().requestCount(0x10);
        });
    }
    void lose(Fault fault)
    {
        device.runAndWait(
            [fault](SensorStation& station) { station.modbusServer().injectFault(fault, FaultOn::Writes); });
    }
    /// Writes as the role is written: settings through the plan, everything else at once.
    bool write(ItemId item, Value value)
    {
        const bool isSetting = catalog::hlG2(item).role == Role::Setting;
        QSignalSpy applied(session.get(), &sensor::SensorSession::applyFinished);
        QSignalSpy commanded(session.get(), &sensor::SensorSession::commandFinished);
        if (isSetting)
            session->edit({{item, value}});
        if (!(isSetting ? session->apply() : session->run(item, value)))
            return false;
        return QTest::qWaitFor([&] { return applied.size() + commanded.size() == 1; }, 20'000);
    }

    emulator::DemoSensor device{catalog::SensorModel::HlG203};
    NoLog log;
    ports::QtScheduler scheduler;
    modbus::ModbusLinkFactory links{log};
    std::unique_ptr<sensor::SensorSession> session;
};

} // namespace

/// A lost reply to a write is never answered by writing again, whatever the item's role: asserted where it
/// counts, at the sensor.
class LostWritesFlow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLostReplyIsNeverAnsweredByWritingAgain_data()
    {
        struct Case {
            const char* name;
            ItemId item;
            Value value;
        };
        const Case cases[] = {
            {"setting of one register", ItemId::EcoMode, 0},
            {"setting of two registers", ItemId::HighSetValue, 12'345},
            {"switch", ItemId::KeyLock, 1},
            {"procedure", ItemId::BrightnessTuning, 0},
            {"command", ItemId::MeasuredValueResetting, 0},
        };
        const QList<std::pair<const char*, Fault>> faults = {
            {"not carried out", Fault::IgnoreRequest},        {"answer dropped", Fault::DropAnswer},
            {"answer cut short", Fault::CutAnswer},           {"other transaction", Fault::WrongTransaction},
            {"connection closed", Fault::CloseAfterCarryOut},
        };
        QTest::addColumn<ItemId>("item");
        QTest::addColumn<Value>("value");
        QTest::addColumn<Fault>("fault");
        for (const Case& each : cases) {
            for (const auto& [name, fault] : faults)
                QTest::addRow("%s, %s", each.name, name) << each.item << each.value << fault;
        }
    }
    void aLostReplyIsNeverAnsweredByWritingAgain()
    {
        QFETCH(ItemId, item);
        QFETCH(Value, value);
        QFETCH(Fault, fault);
        Bench bench;
        QVERIFY(bench.becomesReady());
        QCOMPARE(bench.writeRequests(), 0);

        bench.lose(fault);
        QVERIFY(bench.write(item, value));
        QVERIFY(bench.becomesReady()); // after reconnecting, where the fault broke the connection

        // Requests go one after the other: had the lost one been sent again, it would stand before this one.
        bench.session->revertAll();
        QVERIFY(bench.write(ItemId::LaserStop, 1));
        QCOMPARE(bench.writeRequests(), 2);
    }
};

QTEST_GUILESS_MAIN(LostWritesFlow)
#include "flow_lost_writes.moc"
