#include "rtu_bus.h"

#include "fake_serial_line.h"
#include "item_registers.h"
#include "modbus_rtu_framing.h"

#include <algorithm>
#include <QTest>

using namespace lds;
using namespace lds::tests;
using modbus::Connection;
using modbus::RtuBus;
using modbus::Ticket;
using modbus::Turn;
using ports::FailureCode;

namespace {

constexpr ports::SerialSettings ours{38'400, ports::SerialParity::Even};
constexpr ports::SerialSettings others{9600, ports::SerialParity::None};

/// A bus on a line and a clock of a test.
struct BusFixture {
    BusFixture()
    {
        auto owned = std::make_unique<FakeSerialLine>(clock);
        line = owned.get();
        bus = std::make_unique<RtuBus>(std::make_unique<SharedClock>(clock), std::move(owned));
        if (!bus->open(QStringLiteral("line"), ours))
            qFatal("the line does not open");
    }

    Ticket ask(int unit, Turn turn, const std::function<void()>& then = {})
    {
        const modbus::Request request = modbus::readRequest(modbus::measurementRange());
        return bus->ask({quint8(unit), turn, request, 150, nullptr, [this, unit, then](const auto& exchange) {
                             ended.append(unit);
                             results.append(exchange.result ? FailureCode::None
                                                            : exchange.result.error().code);
                             if (then)
                                 then();
                         }});
    }
    /// Polls the unit for ever, the next when the last has ended.
    void keepPolling(int unit)
    {
        ask(unit, Turn::Poll, [this, unit] { keepPolling(unit); });
    }
    void trustAll(int units) ///< Each has been asked once, so nobody's coils are asked for any more.
    {
        for (int unit = 1; unit <= units; ++unit)
            ask(unit, Turn::Person);
        clock->advanceMs(units * 3 * line->exchangeMs);
        line->asked.clear();
        ended.clear();
        results.clear();
    }

    std::shared_ptr<ports::ManualScheduler> clock = std::make_shared<ports::ManualScheduler>();
    FakeSerialLine* line = nullptr;
    std::unique_ptr<RtuBus> bus;
    QList<int> ended;
    QList<FailureCode> results;
};

} // namespace

/// Whose turn it is on a bus, and what a silent unit costs. No port and no waiting: the clock is the test's.
class RtuBusTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sixteenUnitsArePolledInTurn();
    void aPersonGoesBeforeEverybodyElse();
    void hurryMovesForwardAndNeverBack();
    void theSlowWalkLeavesRoomForPolls();
    void aSilentUnitCostsATimeoutNowAndThen();
    void aPersonDoesNotWaitForAPauseToEnd();
    void aSilentUnitIsAskedForItsCoilsFirst();
    void timeoutsFollowFromTheSpeed();
    void aWithdrawnQuestionIsNeverSent();
    void aForgottenWriteIsNotSentAfterTheCoils();
    void listeningUsesItsOwnSettingsAndGivesThemBack();
    void listeningEndsWithSilence();
    void whatIsListenedToMakesTheUnitDoubtful();
    void lostLineEndsEverythingOnce();
};

void RtuBusTest::sixteenUnitsArePolledInTurn()
{
    BusFixture f;
    f.trustAll(16);
    for (int unit = 1; unit <= 16; ++unit)
        f.keepPolling(unit);
    f.clock->advanceMs(16 * 10 * 10);
    const QList<int> units = f.line->dataUnits();
    QVERIFY(units.size() >= 16 * 10);
    for (qsizetype i = 0; i < 16 * 10; ++i)
        QCOMPARE(units.at(i), int(1 + i % 16));
}

void RtuBusTest::aPersonGoesBeforeEverybodyElse()
{
    BusFixture f;
    f.trustAll(5);
    f.ask(1, Turn::Poll); // On the wire.
    f.ask(2, Turn::Poll);
    f.ask(3, Turn::Background);
    f.ask(4, Turn::Procedure);
    f.ask(5, Turn::Person);
    f.clock->advanceMs(100);
    QCOMPARE(f.ended, QList<int>({1, 5, 4, 3, 2}));
}

void RtuBusTest::hurryMovesForwardAndNeverBack()
{
    BusFixture f;
    f.trustAll(4);
    f.ask(1, Turn::Poll);
    f.ask(2, Turn::Person);
    const Ticket walk = f.ask(3, Turn::Background);
    const Ticket person = f.ask(4, Turn::Person);
    f.bus->hurry(walk, Turn::Person);
    f.bus->hurry(person, Turn::Poll);
    f.clock->advanceMs(100);
    QCOMPARE(f.ended, QList<int>({1, 2, 4, 3}));
}

/// Sixteen walks on a slow line would otherwise leave no room for measurements.
void RtuBusTest::theSlowWalkLeavesRoomForPolls()
{
    BusFixture f;
    f.trustAll(8);
    std::function<void(int)> walk = [&](int unit) {
        f.ask(unit, Turn::Background, [&, unit] { walk(unit); });
    };
    for (int unit = 1; unit <= 4; ++unit)
        walk(unit);
    for (int unit = 5; unit <= 8; ++unit)
        f.keepPolling(unit);
    f.clock->advanceMs(10 * 500);
    const QList<int> units = f.line->dataUnits();
    const auto polls = std::ranges::count_if(units, [](int unit) { return unit > 4; });
    QVERIFY2(polls * 10 >= units.size() * 7, qPrintable(QString::number(polls)));
    for (int unit = 1; unit <= 8; ++unit)
        QVERIFY2(units.count(unit) > 20, qPrintable(QString::number(unit)));
}

void RtuBusTest::aSilentUnitCostsATimeoutNowAndThen()
{
    BusFixture f;
    f.trustAll(16);
    f.line->silentUnits = {7};
    for (int unit = 1; unit <= 16; ++unit)
        f.keepPolling(unit);
    f.clock->advanceMs(10'000);
    f.line->asked.clear();
    f.clock->advanceMs(20'000);
    const auto ofSilent = std::ranges::count(f.line->asked, quint8(7), &FakeSerialLine::Asked::unit);
    QVERIFY2(ofSilent >= 5 && ofSilent <= 10, qPrintable(QString::number(ofSilent))); // Every 2 s or so.
    const auto others16 = f.line->asked.size() - ofSilent;
    QVERIFY2(others16 * f.line->exchangeMs >= 17'000, qPrintable(QString::number(others16)));
    // It comes back as soon as it answers.
    f.line->silentUnits.clear();
    f.clock->advanceMs(2'500);
    f.line->asked.clear();
    f.clock->advanceMs(1'600);
    QVERIFY(f.line->dataUnits().count(7) >= 9);
}

void RtuBusTest::aPersonDoesNotWaitForAPauseToEnd()
{
    BusFixture f;
    f.trustAll(1);
    f.line->silentUnits = {1};
    for (int i = 0; i < 6; ++i) {
        f.ask(1, Turn::Person);
        f.clock->advanceMs(1000);
    }
    QCOMPARE(f.ended.size(), 6);
    QCOMPARE(f.results, QList<FailureCode>(6, FailureCode::NoAnswer));
    f.line->silentUnits.clear();
    f.ask(1, Turn::Poll);
    f.clock->advanceMs(100);
    QCOMPARE(f.ended.size(), 6); // A poll waits.
    f.ask(1, Turn::Person);
    f.clock->advanceMs(100);
    QCOMPARE(f.results.size(), 8); // Who answers a person is polled, too.
    QCOMPARE(f.results.last(), FailureCode::None);
}

void RtuBusTest::aSilentUnitIsAskedForItsCoilsFirst()
{
    BusFixture f;
    f.ask(1, Turn::Person);
    f.clock->advanceMs(100);
    QCOMPARE(f.line->asked.size(), 2); // At first, somebody may have asked before the port was opened.
    QCOMPARE(f.line->asked.at(0).function, 0x01);
    f.line->silentUnits = {1};
    f.ask(1, Turn::Person);
    f.clock->advanceMs(1000);
    QCOMPARE(f.line->asked.size(), 3);
    QCOMPARE(f.line->asked.at(2).function, 0x03);
    f.line->silentUnits.clear();
    f.ask(1, Turn::Person);
    f.ask(1, Turn::Person);
    f.clock->advanceMs(1000);
    QCOMPARE(f.line->asked.size(), 6);
    QCOMPARE(f.line->asked.at(3).function, 0x01);
    QCOMPARE(f.line->asked.at(4).function, 0x03);
    QCOMPARE(f.line->asked.at(5).function, 0x03);
}

/// Request 8, answer 29 characters of 11 bits, twice the silence, 150 ms for the sensor, 20 for an adapter.
void RtuBusTest::timeoutsFollowFromTheSpeed()
{
    const QList<std::pair<int, int>> expected{
        {9600, 170 + 51}, {19'200, 170 + 26}, {38'400, 170 + 15}, {115'200, 170 + 8}, {230'400, 170 + 6}};
    for (const auto& [baud, ms] : expected) {
        auto clock = std::make_shared<ports::ManualScheduler>();
        auto owned = std::make_unique<FakeSerialLine>(clock);
        FakeSerialLine* const line = owned.get();
        RtuBus bus(std::make_unique<SharedClock>(clock), std::move(owned));
        QVERIFY(bus.open(QStringLiteral("line"), {baud, ports::SerialParity::Even}));
        bus.ask({1, Turn::Person, modbus::readRequest(modbus::measurementRange()), 150, nullptr, {}});
        bus.ask({1, Turn::Person, modbus::readRequest(modbus::measurementRange()), 150, nullptr,
                 [](const Connection::Exchange&) {}});
        clock->advanceMs(100);
        QCOMPARE(line->asked.last().function, 0x03);
        QCOMPARE(line->asked.last().timeoutMs, ms);
    }
}

void RtuBusTest::aWithdrawnQuestionIsNeverSent()
{
    BusFixture f;
    f.trustAll(3);
    const Ticket first = f.ask(1, Turn::Poll);
    const Ticket second = f.ask(2, Turn::Poll);
    f.ask(3, Turn::Poll);
    QVERIFY(!f.bus->withdraw(first)); // It is on the wire.
    QVERIFY(f.bus->withdraw(second));
    f.clock->advanceMs(100);
    QCOMPARE(f.ended, QList<int>({1, 3}));
    QCOMPARE(f.line->dataUnits(), QList<int>({1, 3}));
}

void RtuBusTest::aForgottenWriteIsNotSentAfterTheCoils()
{
    BusFixture f;
    const Ticket write = f.bus->ask({1,
                                     Turn::Person,
                                     {modbus::Function::WriteSingleRegister, 122, 1, {77}},
                                     150,
                                     nullptr,
                                     [&](const auto&) { f.ended.append(1); }});
    QCOMPARE(f.line->asked.size(), 1);
    f.bus->forget(write);
    f.clock->advanceMs(1000);
    QCOMPARE(f.line->asked.size(), 1);
    QVERIFY(f.ended.isEmpty());
}

void RtuBusTest::listeningUsesItsOwnSettingsAndGivesThemBack()
{
    BusFixture f;
    f.trustAll(1);
    QByteArray heard;
    f.line->onWrite = [&f](const QByteArray& bytes) {
        f.clock->after(5, f.line, [&f, bytes] { f.line->hear(bytes.toHex()); });
    };
    f.ask(1, Turn::Poll);
    f.bus->listen({QByteArray("frame"), others, 30, 20, [&](const RtuBus::Heard& all) { heard = *all; }});
    f.clock->advanceMs(200);
    QCOMPARE(f.line->written, QList<QByteArray>({QByteArray("frame")}));
    QCOMPARE(heard, QByteArray("frame").toHex());
    QCOMPARE(f.line->adopted, QList<ports::SerialSettings>({others}));
    f.ask(1, Turn::Poll);
    f.clock->advanceMs(200);
    QCOMPARE(f.line->adopted, QList<ports::SerialSettings>({others, ours}));
    QCOMPARE(f.results.last(), FailureCode::None);
}

void RtuBusTest::listeningEndsWithSilence()
{
    BusFixture f;
    qint64 endedNs = 0;
    const qint64 startNs = f.clock->nowNs();
    const auto listen = [&](const QByteArray& frame) {
        f.bus->listen({frame, ours, 100, 20, [&](const RtuBus::Heard&) { endedNs = f.clock->nowNs(); }});
    };
    listen(QByteArray());
    f.clock->advanceMs(1000);
    QCOMPARE((endedNs - startNs) / 1'000'000, 102); // The silence in front, rounded up, and the window.
    // A line that never stops speaking is left after a few frames.
    endedNs = 0;
    f.line->onWrite = [&f](const QByteArray&) {
        for (int i = 1; i <= 100; ++i)
            f.clock->after(i * 10, f.line, [&f] { f.line->hear(QByteArray(100, 'x')); });
    };
    listen(QByteArray("frame"));
    f.clock->advanceMs(500);
    QVERIFY(endedNs > 0);
}

void RtuBusTest::whatIsListenedToMakesTheUnitDoubtful()
{
    BusFixture f;
    f.trustAll(1);
    f.bus->listen({modbus::encodeRtuFrame(1, QByteArray::fromHex("0300730002")), ours, 30, 20, {}});
    f.clock->advanceMs(200);
    f.ask(1, Turn::Poll);
    f.clock->advanceMs(200);
    QCOMPARE(f.line->asked.size(), 2);
    QCOMPARE(f.line->asked.first().function, 0x01);
}

void RtuBusTest::lostLineEndsEverythingOnce()
{
    BusFixture f;
    f.trustAll(3);
    int told = 0;
    connect(f.bus.get(), &RtuBus::lost, this, [&](ports::OpenFailure failure) {
        ++told;
        QCOMPARE(failure, ports::OpenFailure::PortGone);
    });
    f.ask(1, Turn::Poll);
    f.ask(2, Turn::Background);
    f.ask(3, Turn::Person);
    int listened = 0;
    f.bus->listen(
        {QByteArray("x"), others, 30, 20, [&](const RtuBus::Heard& heard) { listened += heard ? 0 : 1; }});
    Q_EMIT f.line->lost(QStringLiteral("unplugged"));
    QCOMPARE(told, 1);
    QCOMPARE(f.results, QList<FailureCode>(3, FailureCode::ConnectionLost));
    QCOMPARE(listened, 1);
    QVERIFY(!f.bus->isOpen());
}

QTEST_GUILESS_MAIN(RtuBusTest)
#include "tst_rtu_bus.moc"
