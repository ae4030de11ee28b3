#include "link_fixture.h"
#include "tcp_connection.h"

#include <QSignalSpy>
#include <QTcpServer>
#include <vector>

using namespace lds;
using namespace lds::tests;
using ports::LinkState;
using ports::OpenFailure;

class LinkOpeningTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void opensAfterReadingSpan();
    void findsTheWordOrder_data();
    void findsTheWordOrder();
    void isNoSensorWhenSpanCannotBe();
    void isNoSensorWhenItRefusesSpan_data();
    void isNoSensorWhenItRefusesSpan();
    void isNoSensorWhenItSpeaksAnotherProtocol();
    void sensorInItsMenuIsNotReady();
    void nobodyListening();
    void hostThatIsNone();
    void hostThatNeverTakesTheConnection();
    void silentHostDoesNotAnswerWithinTwoSeconds();
    void oneLostProbeIsForgiven();
    void hostThatHangsUpDoesNotAnswer();
    void cutDuringTheProbeAfterHalfAnAnswer();
    void opensAgainAfterAFailure();
    void openWhileOpenDoesNothing();
    void closeIsIdempotent();
    void closeWhileOpeningEndsIt();
    void cutWhileOpenIsLost();
    void deletingAnOpenLinkHangsUp();
};

void LinkOpeningTest::opensAfterReadingSpan()
{
    LinkFixture f;
    f.openLink();
    QCOMPARE(f.reports.size(), 2);
    QCOMPARE(f.reports.first().state, LinkState::Opening);
    QCOMPARE(f.failure(), OpenFailure::None);
    QCOMPARE(f.server.received.size(), 1);
    QCOMPARE(f.server.received.first().pdu, QByteArray::fromHex("03 0073 0002")); // 400116, 2 registers
}

void LinkOpeningTest::findsTheWordOrder_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<bool>("lowWordFirst");
    QTest::newRow("low word first") << 10'000 << 0 << true;
    QTest::newRow("high word first") << 0 << 10'000 << false;
    QTest::newRow("equal words") << 1 << 1 << true;
}

void LinkOpeningTest::findsTheWordOrder()
{
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(bool, lowWordFirst);
    LinkFixture f;
    f.server.registers[400116] = quint16(first);
    f.server.registers[400117] = quint16(second);
    f.openLink();
    QCOMPARE(f.reports.last().lowWordFirst, lowWordFirst);
    // And what is read and written afterwards follows it.
    f.server.registers[lowWordFirst ? 400101 : 400102] = 0x8ce8;
    f.server.registers[lowWordFirst ? 400102 : 400101] = 0xfffe;
    const auto id = f.read({catalog::ItemId::HighSetValue});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).values.value(catalog::ItemId::HighSetValue), -95'000);
    const auto written = f.write({{catalog::ItemId::LowSetValue, -95'001}});
    QTRY_COMPARE(f.endings(written), 1);
    QCOMPARE(f.server.registers.value(lowWordFirst ? 400103 : 400104), quint16(0x8ce7));
    QCOMPARE(f.server.registers.value(lowWordFirst ? 400104 : 400103), quint16(0xfffe));
}

void LinkOpeningTest::isNoSensorWhenSpanCannotBe()
{
    LinkFixture f;
    f.server.registers[400116] = 0;
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NotASensor);
}

void LinkOpeningTest::isNoSensorWhenItRefusesSpan_data()
{
    QTest::addColumn<int>("code");
    for (const int code : {1, 2, 3, 11})
        QTest::addRow("%d", code) << code;
}

void LinkOpeningTest::isNoSensorWhenItRefusesSpan()
{
    QFETCH(int, code);
    LinkFixture f;
    f.server.always([&f, code](const auto& request) { f.server.refuse(request, code); });
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NotASensor);
}

void LinkOpeningTest::isNoSensorWhenItSpeaksAnotherProtocol()
{
    LinkFixture f;
    f.server.always([&f](const auto&) { f.server.send("HTTP/1.1 400 Bad Request\r\n\r\n"); });
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NotASensor);
}

void LinkOpeningTest::sensorInItsMenuIsNotReady()
{
    LinkFixture f;
    f.server.always([&f](const auto& request) { f.server.refuse(request, 4); });
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NotReady);
}

void LinkOpeningTest::nobodyListening()
{
    LinkFixture f;
    f.server.stopListening();
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::Refused);
    QVERIFY(!f.reports.last().detail.isEmpty());
    QCOMPARE(f.clock->pendingTimers(), 0);
}

void LinkOpeningTest::hostThatIsNone()
{
    ports::ConnectionUrl url;
    url.host = QString(64, QLatin1Char('x')); // No label of a name is that long: nobody need be asked.
    RecordingLog log;
    modbus::ModbusLink link(url, std::make_unique<ports::ManualScheduler>(), log,
                            modbus::TcpConnection::maker());
    QSignalSpy reported(&link, &ports::SensorLink::reported);
    link.open();
    QTRY_COMPARE(reported.size(), 2);
    const auto report = reported.last().first().value<ports::LinkReport>();
    QCOMPARE(report.state, LinkState::Failed);
    QCOMPARE(report.failure, OpenFailure::HostNotFound);
}

void LinkOpeningTest::hostThatNeverTakesTheConnection()
{
    // A listener whose queue is full takes no notice of further connections.
    QTcpServer full;
    full.setListenBacklogSize(1);
    QVERIFY(full.listen(QHostAddress::LocalHost));
    full.pauseAccepting();
    std::vector<std::unique_ptr<QTcpSocket>> crowd;
    for (int i = 0; i < 8; ++i) {
        crowd.push_back(std::make_unique<QTcpSocket>());
        crowd.back()->connectToHost(full.serverAddress(), full.serverPort());
    }
    settle();
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = full.serverPort();
    auto scheduler = std::make_unique<ports::ManualScheduler>();
    ports::ManualScheduler* const clock = scheduler.get();
    RecordingLog log;
    modbus::ModbusLink link(url, std::move(scheduler), log, modbus::TcpConnection::maker());
    QList<ports::LinkReport> reports;
    connect(&link, &ports::SensorLink::reported, this, [&](const auto& report) { reports.append(report); });
    link.open();
    QTRY_COMPARE(reports.size(), 1);
    clock->advanceMs(1999);
    settle();
    QCOMPARE(reports.last().state, LinkState::Opening);
    QVERIFY(log.frames(ports::FrameMeaning::Connected).isEmpty());
    clock->advanceMs(1);
    QCOMPARE(reports.last().state, LinkState::Failed);
    QCOMPARE(reports.last().failure, OpenFailure::NoAnswer);
    settle();
    QCOMPARE(reports.size(), 2);
}

void LinkOpeningTest::silentHostDoesNotAnswerWithinTwoSeconds()
{
    LinkFixture f;
    f.server.always(silence);
    f.link->open();
    QTRY_COMPARE(f.server.received.size(), 1);
    f.clock->advanceMs(999);
    settle();
    QCOMPARE(f.state(), LinkState::Opening);
    f.clock->advanceMs(1);
    QTRY_COMPARE(f.server.received.size(), 2);
    f.clock->advanceMs(1000);
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NoAnswer);
    QCOMPARE(f.server.received.size(), 2);
    QCOMPARE(f.clock->pendingTimers(), 0);
}

void LinkOpeningTest::oneLostProbeIsForgiven()
{
    LinkFixture f;
    f.server.next(silence);
    f.link->open();
    QTRY_COMPARE(f.server.received.size(), 1);
    f.clock->advanceMs(1000);
    QTRY_COMPARE(f.state(), LinkState::Open);
}

void LinkOpeningTest::hostThatHangsUpDoesNotAnswer()
{
    LinkFixture f;
    f.server.always([&f](const auto&) { f.server.cut(); });
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NoAnswer);
    QCOMPARE(f.reports.size(), 2);
}

void LinkOpeningTest::cutDuringTheProbeAfterHalfAnAnswer()
{
    LinkFixture f;
    f.server.always([&f](const auto& request) { f.server.send(f.server.goodFrame(request).first(9)); });
    f.link->open();
    QTRY_VERIFY(!f.server.received.isEmpty());
    settle();
    f.clock->advanceMs(1000);
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::NotASensor);
    QCOMPARE(f.reports.size(), 2);
}

void LinkOpeningTest::opensAgainAfterAFailure()
{
    LinkFixture f;
    f.server.next([&f](const auto& request) { f.server.refuse(request, 4); });
    f.link->open();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    f.openLink();
    QCOMPARE(f.server.connections, 2);
    const auto id = f.read({catalog::ItemId::Span});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, ports::Status::Done);
}

void LinkOpeningTest::openWhileOpenDoesNothing()
{
    LinkFixture f;
    f.openLink();
    f.link->open();
    settle();
    QCOMPARE(f.reports.size(), 2);
    QCOMPARE(f.server.connections, 1);
}

void LinkOpeningTest::closeIsIdempotent()
{
    LinkFixture f;
    f.link->close();
    settle();
    QVERIFY(f.reports.isEmpty());
    f.openLink();
    f.link->close();
    f.link->close();
    settle();
    QCOMPARE(f.reports.size(), 3);
    QCOMPARE(f.state(), LinkState::Closed);
    QCOMPARE(f.failure(), OpenFailure::None);
    QCOMPARE(f.clock->pendingTimers(), 0);
}

void LinkOpeningTest::closeWhileOpeningEndsIt()
{
    LinkFixture f;
    f.server.always(silence);
    f.link->open();
    QTRY_COMPARE(f.server.received.size(), 1);
    f.link->close();
    QTRY_COMPARE(f.state(), LinkState::Closed);
    f.clock->advanceMs(10'000);
    settle();
    QCOMPARE(f.reports.size(), 2);
}

void LinkOpeningTest::cutWhileOpenIsLost()
{
    LinkFixture f;
    f.openLink();
    f.server.cut();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), OpenFailure::Lost);
    QVERIFY(!f.reports.last().detail.isEmpty());
    QCOMPARE(f.reports.size(), 3);
}

void LinkOpeningTest::deletingAnOpenLinkHangsUp()
{
    LinkFixture f;
    f.openLink();
    f.link.reset();
    QTRY_COMPARE(f.server.openConnections(), 0);
    QCOMPARE(f.reports.size(), 2);
}

QTEST_GUILESS_MAIN(LinkOpeningTest)
#include "tst_link_opening.moc"
