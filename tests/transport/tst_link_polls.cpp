#include "link_fixture.h"

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::FailureCode;
using ports::LinkState;
using Received = ScriptedServer::Received;

class LinkPollsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pollIsOneMessage();
    void sampleIsStampedWhenItArrives();
    void ticksWhileBusyAreDroppedNotQueued();
    void requestsGoBeforePolls();
    void lostPollIsCountedAndNotRepeated();
    void malformedPollGivesNoSample();
    void refusalIsToldOnceAndWhenItEnds();
    void fastPollsComeTogether();
    void stoppingHandsOverWhatIsThere();
    void pollAskedForWhileOpeningBegins();
    void pollBeforeOpeningIsForgotten();
    void closingEndsPolling();
    void countsBeginAgainWithEachOpening();
};

void LinkPollsTest::pollIsOneMessage()
{
    LinkFixture f;
    f.server.registers[400011] = 0xc410; // Laser, LO, and reserved bits
    f.server.registers[400020] = 0x3039;
    f.server.registers[400022] = 700;
    f.openLink();
    f.link->poll(10);
    settle();
    f.clock->advanceMs(0);
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.sinceOpening(), 1);
    QCOMPARE(f.server.received.last().pdu, QByteArray::fromHex("03 000a 000c")); // 400011–400022
    QCOMPARE(f.measurements.first().value, 12'345);
    QCOMPARE(f.measurements.first().state, quint16(measurement::LaserBit | measurement::LowBit));
    QCOMPARE(f.measurements.first().intensity, quint16(700));
    for (int poll = 2; poll <= 5; ++poll) {
        f.clock->advanceMs(10);
        QTRY_COMPARE(f.measurements.size(), poll);
        QCOMPARE(f.sinceOpening(), poll);
    }
    QCOMPARE(f.statistics.answered, quint64(5));
    QCOMPARE(f.statistics.lost, quint64(0));
    QCOMPARE(f.statistics.dropped, quint64(0));
}

void LinkPollsTest::sampleIsStampedWhenItArrives()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    f.link->poll(1000);
    settle();
    f.clock->advanceMs(0);
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(7);
    const qint64 now = f.clock->nowNs();
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.measurements.first().monotonicNs, now);
    QCOMPARE(f.measurements.first().wallMs, f.clock->wallMs());
}

void LinkPollsTest::ticksWhileBusyAreDroppedNotQueued()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto id = f.write({{ItemId::SetValueSaving, 0}}, 15'000);
    QTRY_VERIFY(f.serverHas(1));
    f.link->poll(10);
    settle();
    f.clock->advanceMs(95); // Ticks at 0, 10, … 90
    settle();
    QCOMPARE(f.sinceOpening(), 1);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(id), 1);
    settle();
    QCOMPARE(f.sinceOpening(), 1);
    f.clock->advanceMs(5);
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.sinceOpening(), 2);
    QCOMPARE(f.statistics.dropped, quint64(10));
    QCOMPARE(f.statistics.answered, quint64(1));
}

void LinkPollsTest::requestsGoBeforePolls()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    f.link->poll(10);
    settle();
    f.clock->advanceMs(0);
    QTRY_VERIFY(f.serverHas(1));
    const auto background = f.read({ItemId::Span}, ports::Urgency::Background);
    const auto person = f.write({{ItemId::KeyLock, 1}});
    settle();
    f.clock->advanceMs(20);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(background), 1);
    QCOMPARE(f.outcomes.first().id, person);
    QCOMPARE(f.sinceOpening(), 3);
    QVERIFY(f.server.received.at(2).isWrite());
}

void LinkPollsTest::lostPollIsCountedAndNotRepeated()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    f.link->poll(1000);
    settle();
    f.clock->advanceMs(0);
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(500);
    settle();
    QCOMPARE(f.sinceOpening(), 1);
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.statistics.lost, quint64(1));
    QCOMPARE(f.statistics.answered, quint64(1));
    QVERIFY(f.refusals.isEmpty());
}

void LinkPollsTest::malformedPollGivesNoSample()
{
    LinkFixture f;
    f.openLink();
    f.server.next(
        [&f](const Received& request) { f.server.answer(request, QByteArray::fromHex("03 02 1234")); });
    f.link->poll(10);
    settle();
    f.clock->advanceMs(0);
    QTRY_VERIFY(f.serverHas(1));
    settle();
    QVERIFY(f.measurements.isEmpty());
    f.clock->advanceMs(10);
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.statistics.lost, quint64(1));
}

void LinkPollsTest::refusalIsToldOnceAndWhenItEnds()
{
    LinkFixture f;
    f.openLink();
    f.server.always([&f](const Received& request) { f.server.refuse(request, 4); });
    f.link->poll(10);
    settle();
    for (int poll = 0; poll < 5; ++poll) {
        f.clock->advanceMs(10);
        settle();
    }
    QTRY_VERIFY(f.serverHas(5));
    QCOMPARE(f.refusals.size(), 1);
    QCOMPARE(f.refusals.first().code, FailureCode::NotReady);
    QCOMPARE(f.refusals.first().wireCode, 4);
    QVERIFY(f.measurements.isEmpty());
    QCOMPARE(f.state(), LinkState::Open);
    f.server.answerWell();
    f.clock->advanceMs(10);
    QTRY_COMPARE(f.measurements.size(), 1);
    QCOMPARE(f.refusals.size(), 2);
    QCOMPARE(f.refusals.last().code, FailureCode::None);
}

void LinkPollsTest::fastPollsComeTogether()
{
    LinkFixture f;
    f.openLink();
    f.link->poll(1);
    settle();
    for (int poll = 1; poll <= 10; ++poll) {
        f.clock->advanceMs(poll == 1 ? 0 : 1);
        QTRY_VERIFY(f.serverHas(poll));
        settle();
    }
    QTRY_COMPARE(f.measurements.size(), 10);
    QCOMPARE(f.batches, 2);
}

void LinkPollsTest::stoppingHandsOverWhatIsThere()
{
    LinkFixture f;
    f.openLink();
    f.link->poll(1);
    settle();
    f.clock->advanceMs(0);
    QTRY_VERIFY(f.serverHas(1));
    settle();
    f.link->poll(0);
    QTRY_COMPARE(f.measurements.size(), 1);
    f.clock->advanceMs(100);
    settle();
    QCOMPARE(f.sinceOpening(), 1);
}

void LinkPollsTest::pollAskedForWhileOpeningBegins()
{
    LinkFixture f;
    f.link->open();
    f.link->poll(10);
    QTRY_COMPARE(f.state(), LinkState::Open);
    f.clock->advanceMs(0);
    QTRY_COMPARE(f.measurements.size(), 1);
}

void LinkPollsTest::pollBeforeOpeningIsForgotten()
{
    LinkFixture f;
    f.link->poll(10);
    settle();
    f.openLink();
    f.clock->advanceMs(100);
    settle();
    QCOMPARE(f.sinceOpening(), 0);
}

void LinkPollsTest::closingEndsPolling()
{
    LinkFixture f;
    f.openLink();
    f.link->poll(10);
    settle();
    f.clock->advanceMs(0);
    QTRY_COMPARE(f.measurements.size(), 1);
    f.link->close();
    QTRY_COMPARE(f.state(), LinkState::Closed);
    f.openLink();
    f.clock->advanceMs(100);
    settle();
    QCOMPARE(f.sinceOpening(), 0);
    QCOMPARE(f.clock->pendingTimers(), 0);
}

void LinkPollsTest::countsBeginAgainWithEachOpening()
{
    LinkFixture f;
    for (int round = 0; round < 2; ++round) {
        f.openLink();
        f.link->poll(10);
        settle();
        f.clock->advanceMs(0);
        QTRY_COMPARE(f.measurements.size(), round + 1);
        QCOMPARE(f.statistics.answered, quint64(1));
        f.link->close();
        QTRY_COMPARE(f.state(), LinkState::Closed);
    }
}

QTEST_GUILESS_MAIN(LinkPollsTest)
#include "tst_link_polls.moc"
