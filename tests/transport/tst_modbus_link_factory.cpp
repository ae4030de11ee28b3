#include "modbus_link_factory.h"

#include "link_fixture.h"

#include <QSignalSpy>

using namespace lds;
using namespace lds::tests;
using ports::LinkState;

namespace {

ports::ConnectionUrl urlOf(const ScriptedServer& server)
{
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = server.port();
    return url;
}

} // namespace

/// The link as the programs use it: in its own thread, on the real clock.
class ModbusLinkFactoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void linkLivesInTheIoThread();
    void linkReadsWritesAndPollsFromAnotherThread();
    void silentHostEndsInRealTime();
    void lostWriteIsNotRepeatedInRealTime();
    void givenUpLinkHangsUp();
    void factoryMayGoRightAfterItsLinks();
    void linksAreIndependent();
};

void ModbusLinkFactoryTest::linkLivesInTheIoThread()
{
    RecordingLog log;
    ScriptedServer server;
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer first = factory.create(urlOf(server));
    const ports::LinkPointer second = factory.create(urlOf(server));
    QVERIFY(first->thread() != QThread::currentThread());
    QCOMPARE(first->thread(), second->thread());
}

void ModbusLinkFactoryTest::linkReadsWritesAndPollsFromAnotherThread()
{
    RecordingLog log;
    ScriptedServer server;
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer link = factory.create(urlOf(server));
    QList<ports::LinkReport> reports;
    QList<ports::Outcome> outcomes;
    qsizetype samples = 0;
    connect(link.get(), &ports::SensorLink::reported, this,
            [&](const auto& report) { reports.append(report); });
    connect(link.get(), &ports::SensorLink::finished, this,
            [&](const auto& outcome) { outcomes.append(outcome); });
    connect(link.get(), &ports::SensorLink::measured, this,
            [&](const auto& batch) { samples += batch.size(); });
    link->open();
    QTRY_VERIFY(!reports.isEmpty() && reports.last().state == LinkState::Open);
    link->poll(2);
    ports::Request request;
    request.id = 7;
    request.kind = ports::RequestKind::Write;
    request.write = {{catalog::ItemId::HighSetValue, 1234}};
    link->submit(request);
    QTRY_COMPARE(outcomes.size(), 1);
    QCOMPARE(outcomes.first().status, ports::Status::Done);
    QCOMPARE(server.registers.value(400101), quint16(1234));
    QTRY_VERIFY(samples >= 20);
    link->close();
    QTRY_COMPARE(reports.last().state, LinkState::Closed);
}

void ModbusLinkFactoryTest::silentHostEndsInRealTime()
{
    RecordingLog log;
    ScriptedServer server;
    server.always(silence);
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer link = factory.create(urlOf(server));
    QList<ports::LinkReport> reports;
    connect(link.get(), &ports::SensorLink::reported, this,
            [&](const auto& report) { reports.append(report); });
    QElapsedTimer elapsed;
    elapsed.start();
    link->open();
    QTRY_VERIFY_WITH_TIMEOUT(!reports.isEmpty() && reports.last().state == LinkState::Failed, 10'000);
    QCOMPARE(reports.last().failure, ports::OpenFailure::NoAnswer);
    QVERIFY(elapsed.elapsed() >= 1900);
}

/// QModbus has a timer and repeats of its own, which no injected clock drives: 1000 ms and three times.
void ModbusLinkFactoryTest::lostWriteIsNotRepeatedInRealTime()
{
    RecordingLog log;
    ScriptedServer server;
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer link = factory.create(urlOf(server));
    bool open = false;
    QList<ports::Outcome> outcomes;
    connect(link.get(), &ports::SensorLink::reported, this,
            [&](const auto& report) { open = report.state == LinkState::Open; });
    connect(link.get(), &ports::SensorLink::finished, this,
            [&](const auto& outcome) { outcomes.append(outcome); });
    link->open();
    QTRY_VERIFY(open);
    server.always(silence);
    ports::Request request;
    request.kind = ports::RequestKind::Write;
    request.write = {{catalog::ItemId::Teaching1stPoint, 0}};
    request.timeoutMs = 2500;
    link->submit(request);
    QTRY_COMPARE_WITH_TIMEOUT(outcomes.size(), 1, 10'000);
    QCOMPARE(outcomes.first().status, ports::Status::Unknown);
    QCOMPARE(server.writes(), 1);
}

void ModbusLinkFactoryTest::givenUpLinkHangsUp()
{
    RecordingLog log;
    ScriptedServer server;
    modbus::ModbusLinkFactory factory(log);
    ports::LinkPointer link = factory.create(urlOf(server));
    link->open();
    QTRY_VERIFY(!server.received.isEmpty());
    QSignalSpy destroyed(link.get(), &QObject::destroyed);
    link.reset();
    QTRY_COMPARE(server.openConnections(), 0);
    QTRY_COMPARE(destroyed.size(), 1);
}

void ModbusLinkFactoryTest::factoryMayGoRightAfterItsLinks()
{
    for (int round = 0; round < 50; ++round) {
        RecordingLog log;
        ScriptedServer server;
        modbus::ModbusLinkFactory factory(log);
        const ports::LinkPointer idle = factory.create(urlOf(server));
        const ports::LinkPointer link = factory.create(urlOf(server));
        link->open();
        link->poll(1);
        if (round % 2 == 0)
            QTRY_VERIFY(!server.received.isEmpty());
        ports::Request request;
        request.items = {catalog::ItemId::Span};
        link->submit(request);
    }
}

void ModbusLinkFactoryTest::linksAreIndependent()
{
    RecordingLog log;
    ScriptedServer silent;
    silent.always(silence);
    ScriptedServer server;
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer stuck = factory.create(urlOf(silent));
    const ports::LinkPointer link = factory.create(urlOf(server));
    bool open = false;
    connect(link.get(), &ports::SensorLink::reported, this,
            [&](const auto& report) { open = report.state == LinkState::Open; });
    stuck->open();
    QTRY_VERIFY(!silent.received.isEmpty());
    link->open();
    QTRY_VERIFY_WITH_TIMEOUT(open, 1500);
}

QTEST_GUILESS_MAIN(ModbusLinkFactoryTest)
#include "tst_modbus_link_factory.moc"
