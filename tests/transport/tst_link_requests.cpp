#include "link_fixture.h"

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::FailureCode;
using ports::LinkState;
using ports::Status;
using ports::Urgency;

namespace {

QList<ItemId> everyItem()
{
    QList<ItemId> items;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        items.append(item.id);
    return items;
}

} // namespace

class LinkRequestsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everythingIsReadInTwoMessages();
    void oneRequestIsOnTheWireAtATime();
    void urgentRequestsGoFirst();
    void writesGoOutOnce_data();
    void writesGoOutOnce();
    void lostWriteIsUnknownAndNotRepeated_data();
    void lostWriteIsUnknownAndNotRepeated();
    void lostReadIsRepeatedOnce();
    void readLostTwiceIsUnknown();
    void requestMayTakeItsOwnTime();
    void refusalsCarryTheirCode_data();
    void refusalsCarryTheirCode();
    void refusedReadIsNotRepeated();
    void refusalInTheMiddleOfAReadGivesNoValues();
    void whatHasNoRegisterIsNotReachable();
    void localRefusalDoesNotHoldUpTheOthers();
    void viewOnlyNeverWrites();
    void notConnectedIsSaidAtOnce();
    void cutEndsEveryRequestOnce();
    void cutAtEveryByteOfAnAnswerEndsTheRequestOnce();
    void closeEndsEveryRequestOnce();
    void longSilenceIsALostConnection();
    void reachesWhatHasARegister();
};

void LinkRequestsTest::everythingIsReadInTwoMessages()
{
    LinkFixture f;
    for (int number = 400101; number <= 400170; ++number) {
        if (number != 400116 && number != 400117)
            f.server.registers[number] = quint16(number % 7);
    }
    f.openLink();
    const auto id = f.read(everyItem());
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Done);
    QCOMPARE(f.sinceOpening(), 2);
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        const bool readable = item.modbus && item.isReadable();
        QVERIFY2(f.outcome(id).values.contains(item.id) == readable, item.key);
        if (readable && item.size != 4 && item.kind != catalog::Kind::Bits)
            QCOMPARE(f.outcome(id).values.value(item.id), f.server.registers.value(item.modbus->number));
    }
}

void LinkRequestsTest::oneRequestIsOnTheWireAtATime()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto first = f.read({ItemId::Span});
    const auto second = f.read({ItemId::Hysteresis});
    QTRY_VERIFY(f.serverHas(1));
    settle();
    QCOMPARE(f.sinceOpening(), 1);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(second), 1);
    QCOMPARE(f.outcomes.first().id, first);
    QCOMPARE(f.sinceOpening(), 2);
}

void LinkRequestsTest::urgentRequestsGoFirst()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto first = f.read({ItemId::Span}, Urgency::Background);
    QTRY_VERIFY(f.serverHas(1));
    const auto background = f.read({ItemId::Span}, Urgency::Background);
    const auto procedure = f.read({ItemId::Span}, Urgency::Procedure);
    const auto person = f.read({ItemId::Span}, Urgency::Person);
    settle();
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.outcomes.size(), 4);
    QList<ports::RequestId> order;
    for (const ports::Outcome& outcome : f.outcomes)
        order.append(outcome.id);
    QCOMPARE(order, (QList<ports::RequestId>{first, person, procedure, background}));
}

void LinkRequestsTest::writesGoOutOnce_data()
{
    QTest::addColumn<settings::Write>("write");
    QTest::addColumn<QByteArray>("pdu");
    QTest::newRow("one register") << settings::Write{{ItemId::KeyLock, 1}}
                                  << QByteArray::fromHex("06 006b 0001");
    QTest::newRow("two registers") << settings::Write{{ItemId::HighSetValue, 70'000}}
                                   << QByteArray::fromHex("10 0064 0002 04 1170 0001");
    QTest::newRow("mask") << settings::Write{{ItemId::SubnetMask4thOctet, 0},
                                             {ItemId::SubnetMask1stOctet, 255},
                                             {ItemId::SubnetMask2ndOctet, 254},
                                             {ItemId::SubnetMask3rdOctet, 253}}
                          << QByteArray::fromHex("10 009e 0004 08 0000 00fd 00fe 00ff");
    QTest::newRow("command") << settings::Write{{ItemId::SetValueSaving, 0}}
                             << QByteArray::fromHex("06 0035 0000");
}

void LinkRequestsTest::writesGoOutOnce()
{
    QFETCH(settings::Write, write);
    QFETCH(QByteArray, pdu);
    LinkFixture f;
    f.openLink();
    const auto id = f.write(write);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Done);
    QCOMPARE(f.outcome(id).kind, ports::RequestKind::Write);
    QVERIFY(f.outcome(id).values.isEmpty());
    QCOMPARE(f.server.writes(), 1);
    QCOMPARE(f.server.received.last().pdu, pdu);
}

void LinkRequestsTest::lostWriteIsUnknownAndNotRepeated_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::newRow("silence") << QByteArray();
    QTest::newRow("another function") << QByteArray::fromHex("03 02 0001");
    QTest::newRow("another register") << QByteArray::fromHex("06 006c 0001");
    QTest::newRow("another value") << QByteArray::fromHex("06 006b 0000");
    QTest::newRow("cut short") << QByteArray::fromHex("06 006b");
    QTest::newRow("too long") << QByteArray::fromHex("06 006b 0001 00");
}

void LinkRequestsTest::lostWriteIsUnknownAndNotRepeated()
{
    QFETCH(QByteArray, answer);
    LinkFixture f;
    f.openLink();
    f.server.next([&](const auto& request) {
        if (!answer.isEmpty())
            f.server.answer(request, answer);
    });
    const auto id = f.write({{ItemId::KeyLock, 1}});
    QTRY_VERIFY(f.serverHas(1));
    settle();
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Unknown);
    QCOMPARE(f.outcome(id).failure.code, answer.isEmpty() ? FailureCode::NoAnswer : FailureCode::Malformed);
    f.clock->advanceMs(4000);
    settle();
    QCOMPARE(f.server.writes(), 1);
    QCOMPARE(f.endings(id), 1);
    // And the connection goes on.
    const auto next = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(next), 1);
    QCOMPARE(f.outcome(next).values.value(ItemId::Span), 10'000);
}

void LinkRequestsTest::lostReadIsRepeatedOnce()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Done);
    QCOMPARE(f.outcome(id).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.sinceOpening(), 2);
}

void LinkRequestsTest::readLostTwiceIsUnknown()
{
    LinkFixture f;
    f.openLink();
    f.server.always(silence);
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(500);
    QTRY_VERIFY(f.serverHas(2));
    f.clock->advanceMs(499);
    settle();
    QCOMPARE(f.endings(id), 0);
    f.clock->advanceMs(1);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Unknown);
    QCOMPARE(f.outcome(id).failure.code, FailureCode::NoAnswer);
    QCOMPARE(f.sinceOpening(), 2);
    QCOMPARE(f.state(), LinkState::Open);
}

void LinkRequestsTest::requestMayTakeItsOwnTime()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto id = f.write({{ItemId::SetValueSaving, 0}}, 15'000);
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(14'999);
    settle();
    QCOMPARE(f.endings(id), 0);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Done);
    QCOMPARE(f.state(), LinkState::Open);
}

void LinkRequestsTest::refusalsCarryTheirCode_data()
{
    QTest::addColumn<int>("wire");
    QTest::addColumn<FailureCode>("code");
    QTest::newRow("01") << 1 << FailureCode::FunctionNotSupported;
    QTest::newRow("02") << 2 << FailureCode::AddressRefused;
    QTest::newRow("03") << 3 << FailureCode::ValueRefused;
    QTest::newRow("04") << 4 << FailureCode::NotReady;
    QTest::newRow("06") << 6 << FailureCode::OtherRefusal;
}

void LinkRequestsTest::refusalsCarryTheirCode()
{
    QFETCH(int, wire);
    QFETCH(FailureCode, code);
    LinkFixture f;
    f.openLink();
    f.server.always([&](const auto& request) { f.server.refuse(request, wire); });
    const auto written = f.write({{ItemId::HighSetValue, 1}});
    const auto read = f.read({ItemId::HighSetValue});
    QTRY_COMPARE(f.outcomes.size(), 2);
    for (const auto id : {written, read}) {
        QCOMPARE(f.outcome(id).status, Status::Refused);
        QCOMPARE(f.outcome(id).failure.code, code);
        QCOMPARE(f.outcome(id).failure.wireCode, wire);
    }
}

void LinkRequestsTest::refusedReadIsNotRepeated()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const auto& request) { f.server.refuse(request, 4); });
    const auto id = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(id), 1);
    settle();
    QCOMPARE(f.sinceOpening(), 1);
}

void LinkRequestsTest::refusalInTheMiddleOfAReadGivesNoValues()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const auto& request) { f.server.send(f.server.goodFrame(request)); });
    f.server.next([&f](const auto& request) { f.server.refuse(request, 4); });
    const auto id = f.read(everyItem());
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Refused);
    QVERIFY(f.outcome(id).values.isEmpty());
}

void LinkRequestsTest::whatHasNoRegisterIsNotReachable()
{
    LinkFixture f;
    f.openLink();
    const auto read = f.read({ItemId::PortSlmp});
    const auto written = f.write({{ItemId::PortSlmp, 45'237}});
    QTRY_COMPARE(f.outcomes.size(), 2);
    for (const auto id : {read, written}) {
        QCOMPARE(f.outcome(id).status, Status::Refused);
        QCOMPARE(f.outcome(id).failure.code, FailureCode::NotReachable);
    }
    QCOMPARE(f.sinceOpening(), 0);
}

void LinkRequestsTest::localRefusalDoesNotHoldUpTheOthers()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto first = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    const auto refused = f.write({{ItemId::MeasuredValue, 1}});
    const auto last = f.read({ItemId::Span});
    settle();
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(last), 1);
    QCOMPARE(f.endings(first), 1);
    QCOMPARE(f.endings(refused), 1);
    QCOMPARE(f.outcome(last).status, Status::Done);
}

void LinkRequestsTest::viewOnlyNeverWrites()
{
    LinkFixture f(true);
    f.openLink();
    const auto written = f.write({{ItemId::KeyLock, 1}});
    const auto read = f.read({ItemId::KeyLock});
    QTRY_COMPARE(f.outcomes.size(), 2);
    QCOMPARE(f.outcome(written).status, Status::Refused);
    QCOMPARE(f.outcome(written).failure.code, FailureCode::ViewOnly);
    QCOMPARE(f.outcome(read).status, Status::Done);
    QCOMPARE(f.server.writes(), 0);
}

void LinkRequestsTest::notConnectedIsSaidAtOnce()
{
    LinkFixture f;
    const auto before = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(before), 1);
    QCOMPARE(f.outcome(before).status, Status::Refused);
    QCOMPARE(f.outcome(before).failure.code, FailureCode::NotConnected);
    f.server.always(silence);
    f.link->open();
    const auto during = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(during), 1);
    QCOMPARE(f.outcome(during).failure.code, FailureCode::NotConnected);
}

void LinkRequestsTest::cutEndsEveryRequestOnce()
{
    LinkFixture f;
    f.openLink();
    f.server.always(silence);
    QList<ports::RequestId> ids;
    ids.append(f.write({{ItemId::KeyLock, 1}}));
    ids.append(f.read({ItemId::Span}));
    ids.append(f.read({ItemId::Span}, Urgency::Background));
    f.link->poll(10);
    QTRY_VERIFY(f.serverHas(1));
    f.server.cut();
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), ports::OpenFailure::Lost);
    f.clock->advanceMs(60'000);
    settle();
    for (const auto id : ids) {
        QCOMPARE(f.endings(id), 1);
        QCOMPARE(f.outcome(id).status, Status::Unknown);
        QCOMPARE(f.outcome(id).failure.code, FailureCode::ConnectionLost);
    }
    QCOMPARE(f.server.writes(), 1);
    QCOMPARE(f.clock->pendingTimers(), 0);
}

void LinkRequestsTest::cutAtEveryByteOfAnAnswerEndsTheRequestOnce()
{
    constexpr int answerSize = 7 + 2 + 4;
    for (const bool write : {false, true}) {
        for (int cut = 0; cut <= (write ? 12 : answerSize); ++cut) {
            LinkFixture f;
            f.openLink();
            f.server.next([&](const auto& request) {
                f.server.send(f.server.goodFrame(request).first(cut));
                f.server.cut();
            });
            const auto id = write ? f.write({{ItemId::KeyLock, 1}}) : f.read({ItemId::Span});
            QTRY_COMPARE(f.state(), LinkState::Failed);
            settle();
            QCOMPARE(f.endings(id), 1);
            const bool whole = cut == (write ? 12 : answerSize);
            QCOMPARE(f.outcome(id).status, whole ? Status::Done : Status::Unknown);
            if (!whole) {
                QCOMPARE(f.outcome(id).failure.code, FailureCode::ConnectionLost);
                QVERIFY(f.outcome(id).values.isEmpty());
            }
            QCOMPARE(f.sinceOpening(), 1);
        }
    }
}

void LinkRequestsTest::closeEndsEveryRequestOnce()
{
    LinkFixture f;
    f.openLink();
    f.server.always(silence);
    const auto first = f.write({{ItemId::KeyLock, 1}});
    const auto second = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    f.link->close();
    const auto third = f.read({ItemId::Span});
    QTRY_COMPARE(f.outcomes.size(), 3);
    for (const auto id : {first, second}) {
        QCOMPARE(f.endings(id), 1);
        QCOMPARE(f.outcome(id).status, Status::Unknown);
        QCOMPARE(f.outcome(id).failure.code, FailureCode::ConnectionLost);
    }
    QCOMPARE(f.outcome(third).failure.code, FailureCode::NotConnected);
    QCOMPARE(f.state(), LinkState::Closed);
    f.clock->advanceMs(60'000);
    settle();
    QCOMPARE(f.outcomes.size(), 3);
}

void LinkRequestsTest::longSilenceIsALostConnection()
{
    LinkFixture f;
    f.openLink();
    f.server.always(silence);
    f.link->poll(10);
    settle();
    f.clock->advanceMs(4900); // Poll after poll is lost.
    settle();
    QCOMPARE(f.state(), LinkState::Open);
    f.clock->advanceMs(1000);
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), ports::OpenFailure::Lost);
    // It can be opened again.
    f.server.answerWell();
    f.openLink();
}

void LinkRequestsTest::reachesWhatHasARegister()
{
    const LinkFixture f;
    int reached = 0;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        reached += f.link->reaches(item.id) ? 1 : 0;
    QCOMPARE(reached, 66); // §5.2.4
    QVERIFY(!f.link->reaches(ItemId::MacAddress));
}

QTEST_GUILESS_MAIN(LinkRequestsTest)
#include "tst_link_requests.moc"
