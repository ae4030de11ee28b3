#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Urgency;
using lds::support::settle;

/// What a PLC, the keypad or another program does to the sensor is noticed.
class SessionWatchTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyStoredValueIsReadAgainInTheBackground()
    {
        SessionFixture f;
        f.openReady();
        f.passWalk();
        for (const auto& item : f.session->catalog().items()) {
            if (item.role == lds::catalog::Role::Setting && item.isReadable() && item.modbus) {
                QVERIFY2(f.sensor().readsOf(item.id) > 0, item.key);
                QVERIFY(f.scheduler.nowNs() - f.session->readAtNs(item.id) < 10'000'000'000);
            }
        }
        for (const Request& request : f.sensor().requests()) {
            QCOMPARE(request.urgency, Urgency::Background);
            QCOMPARE(request.kind, RequestKind::Read);
            QVERIFY(request.items.size() <= 10);
        }
    }

    void aStepThatIsNotAnsweredYetIsNotFollowedByAnother()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().holdAnswers(true);
        f.passWalk();
        QCOMPARE(f.sensor().outstanding(), 1);
        f.sensor().holdAnswers(false);
        f.sensor().deliverAll();
        f.passWalk();
        QVERIFY(f.sensor().reads() > 2);
    }

    void aStepThatIsRefusedOrLostDoesNotEndTheWalk()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().loseReads(1);
        f.pass(500);
        f.sensor().timeOut();
        f.sensor().refuseReads(lds::ports::FailureCode::NotReady);
        f.pass(2000);
        f.sensor().refuseReads(lds::ports::FailureCode::None);
        f.sensor().set(ItemId::Span, 15000);
        f.passWalk();
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(15000));
        QVERIFY(f.session->isReady());
    }

    void aChangeBySomebodyElseIsTold()
    {
        SessionFixture f;
        f.openReady();
        f.runAndSettle(ItemId::SetValueSaving, 0);
        QCOMPARE(f.session->saved(), Saved::Saved);
        const Value before = f.sensor().value(ItemId::Span);
        f.sensor().set(ItemId::Span, 15000);
        f.passWalk();
        QCOMPARE(f.external.size(), 1);
        QCOMPARE(f.external.first().item, ItemId::Span);
        QCOMPARE(f.external.first().before, before);
        QCOMPARE(f.external.first().after, 15000);
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(15000));
        QCOMPARE(f.session->saved(), Saved::Unknown);
    }

    void aStoppedLaserIsSeen()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().set(ItemId::LaserStop, 1);
        f.passWalk();
        QCOMPARE(f.external.value(0).item, ItemId::LaserStop);
    }

    void aChangedMeasurementIsNobodysChange()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().set(ItemId::MeasuredValue, 4711);
        f.sensor().set(ItemId::SensorState, 1);
        f.session->readAll();
        settle();
        QCOMPARE(f.session->held(ItemId::MeasuredValue), std::optional<Value>(4711));
        QVERIFY(f.external.isEmpty());
    }

    void aChangeUnderAnEditIsAConflict()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.edit(ItemId::Offset, 500);
        f.sensor().set(ItemId::Span, 15000);
        f.passWalk();
        QCOMPARE(f.conflicts, QList{ItemId::Span}); // once
        const auto edit = f.session->pending().find(ItemId::Span);
        QVERIFY(edit && edit->conflict);
        QCOMPARE(edit->wanted, 20000);
        QVERIFY(!f.session->pending().find(ItemId::Offset)->conflict);
        f.session->keepMine(ItemId::Span);
        QVERIFY(!f.session->pending().find(ItemId::Span)->conflict);
        QCOMPARE(f.session->pending().find(ItemId::Span)->base, 15000);
    }

    void anEditThatSomebodyElseMadeTrueVanishes()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().set(ItemId::Span, 20000);
        f.passWalk();
        QVERIFY(f.session->pending().isEmpty());
        QVERIFY(f.conflicts.isEmpty());
    }

    /// §4.2: another bank is another set of values, not forty changes.
    void aBankSwitchedElsewhereIsSeenAtOnceAndReadAnew()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().switchBank(2);
        f.sensor().set(ItemId::Span, 15000);
        f.sensor().set(ItemId::HighSetValue, 12340);
        f.sensor().switchBank(1);
        f.edit(ItemId::Offset, 500);
        f.edit(ItemId::DisplayInversion, 1);
        f.sensor().switchBank(2);
        f.pass(600); // one step of the walk
        QCOMPARE(f.session->held(ItemId::BankSwitching), std::optional<Value>(2));
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(15000));
        QCOMPARE(f.session->held(ItemId::HighSetValue), std::optional<Value>(12340));
        QCOMPARE(f.external.size(), 1);
        QCOMPARE(f.external.first().item, ItemId::BankSwitching);
        QCOMPARE(f.conflicts, QList{ItemId::Offset}); // made for bank 1
        QCOMPARE(f.session->saved(), Saved::Unknown);
        QVERIFY(f.session->canWrite());
        f.passWalk();
        QCOMPARE(f.external.size(), 1);
        f.sensor().switchBank(1);
        f.pass(600);
        QVERIFY(!f.session->pending().find(ItemId::Offset)->conflict);
        QCOMPARE(f.wanted(ItemId::Offset), 500);
    }

    void whileTheOtherBankIsNotReadYetNothingIsWritten()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().switchBank(2);
        f.pass(490);
        int asked = 0;
        f.sensor().setOnRequest([&f, &asked](const Request&) {
            if (++asked == 2)
                f.sensor().holdAnswers(true); // the step of the walk is answered, the reading anew is not
        });
        f.pass(20);
        QCOMPARE(f.sensor().outstanding(), 1);
        QVERIFY(!f.session->canWrite());
        f.sensor().timeOut();
        settle();
        QVERIFY(!f.session->canWrite());
        f.sensor().setOnRequest({});
        f.sensor().holdAnswers(false);
        f.pass(600);
        QVERIFY(f.session->canWrite());
    }

    /// A background reading that waits in the link is overtaken by the write, and then shows what this
    /// program wrote as if somebody else had.
    void aReadingThatAWriteOvertakesIsNotBelieved()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().holdAnswers(true);
        f.pass(500);
        QCOMPARE(f.sensor().outstanding(), 1);
        QVERIFY(f.sensor().requests().last().items.contains(ItemId::LanguageSetting));
        f.edit(ItemId::LanguageSetting, 2);
        QVERIFY(f.session->apply());
        settle();
        QCOMPARE(f.sensor().outstanding(), 2);
        f.sensor().deliverNewest(); // the write
        f.sensor().deliver();       // the reading
        f.sensor().holdAnswers(false);
        settle();
        f.sensor().deliverAll();
        settle();
        QVERIFY(f.applies.value(0).allDone());
        QVERIFY(f.external.isEmpty());
        QVERIFY(f.conflicts.isEmpty());
        QCOMPARE(f.session->saved(), Saved::NotSaved);
    }

    void everythingCanBeReadOnRequestAndDuringAnApplyAfterIt()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().set(ItemId::Span, 15000);
        f.session->readAll();
        settle();
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(15000));
        f.edit(ItemId::DisplayInversion, 1);
        QVERIFY(f.session->apply());
        f.sensor().set(ItemId::Span, 16000);
        f.session->readAll();
        settle();
        QVERIFY(f.applies.value(0).allDone());
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(16000));
    }
};

QTEST_GUILESS_MAIN(SessionWatchTest)
#include "tst_session_watch.moc"
