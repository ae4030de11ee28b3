#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Status;
using lds::support::FakeSensor;
using lds::support::settle;

class SessionApplyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachEditIsWrittenOnceReadBackAndOnlyThenGone()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        QCOMPARE(f.session->pending().count(), 10);
        QSignalSpy progress(f.session.get(), &SensorSession::applyProgress);
        f.sensor().setOnRequest([&f](const Request& request) {
            if (request.kind == RequestKind::Write) // not gone before it has been read back
                QVERIFY(f.session->pending().find(request.write.first().item));
        });
        QVERIFY(f.session->apply());
        QVERIFY(f.session->isApplying());
        QVERIFY(f.applies.isEmpty());
        QVERIFY(!f.session->canWrite());
        settle();
        QVERIFY(!f.session->isApplying());
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(f.applies.first().allDone());
        QCOMPARE(f.applies.first().written.size(), 10);
        QVERIFY(f.session->pending().isEmpty());
        QVERIFY(!f.session->pending().canUndo());
        QCOMPARE(f.sensor().writes(), 10);
        for (const auto& each : tenEdits) {
            QCOMPARE(f.sensor().writesOf(each.item), 1);
            QCOMPARE(f.sensor().value(each.item), each.value);
            QCOMPARE(f.session->held(each.item), std::optional(each.value));
        }
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        QVERIFY(f.external.isEmpty());
        QCOMPARE(progress.first().at(0).toInt(), 0);
        QCOMPARE(progress.first().at(1).toInt(), 10);
        QCOMPARE(progress.last().at(0).toInt(), 10);
        f.passWalk();
        QVERIFY(f.external.isEmpty());
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        QCOMPARE(f.sensor().writes(), 10);
    }

    void theReportNamesOldAndNew()
    {
        SessionFixture f;
        f.openReady();
        const Value before = *f.session->held(ItemId::Span);
        f.edit(ItemId::Span, 20000);
        f.applyAndSettle();
        const WriteResult result = f.applies.first().written.first();
        QCOMPARE(result.before.value(ItemId::Span), before);
        QCOMPARE(result.readBack.value(ItemId::Span), 20000);
        QCOMPARE(result.status, Status::Done);
    }

    void nothingToApplyIsDoneAtOnceButNotInsideTheCall()
    {
        SessionFixture f;
        f.openReady();
        QVERIFY(f.session->apply());
        QVERIFY(f.applies.isEmpty());
        settle();
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(f.applies.first().allDone());
        QCOMPARE(f.sensor().requests().size(), 0);
        QCOMPARE(f.session->saved(), Saved::Unknown);
    }

    void oneOfTenRefusedLeavesNineWrittenAndOneEdit()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        f.sensor().refuse(ItemId::Offset);
        f.applyAndSettle();
        const ApplyReport report = f.applies.value(0);
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(!report.allDone());
        QCOMPARE(report.written.size(), 9);
        QCOMPARE(writtenItems(report.refused), QList{ItemId::Offset});
        QCOMPARE(report.refused.first().failure.code, FailureCode::ValueRefused);
        QVERIFY(report.notTried.isEmpty());
        QCOMPARE(f.session->pending().edits().keys(), QList{ItemId::Offset});
        QVERIFY(!f.session->pending().find(ItemId::Offset)->conflict);
        QCOMPARE(f.sensor().writesOf(ItemId::Offset), 1);
        // And the person may try once more.
        f.sensor().acceptAgain(ItemId::Offset);
        f.applyAndSettle();
        QVERIFY(f.applies.last().allDone());
        QCOMPARE(f.sensor().writesOf(ItemId::Offset), 2);
        QVERIFY(f.session->pending().isEmpty());
    }

    /// §4.4.1: without the new HIGH there is no order of writes for the new LOW.
    void whatARefusalMakesImpossibleIsNotTried()
    {
        SessionFixture f;
        f.openReady();
        const Value high = *f.session->held(ItemId::HighSetValue);
        f.session->edit({{ItemId::HighSetValue, high + 20000},
                         {ItemId::LowSetValue, high + 10000},
                         {ItemId::DisplayInversion, 1}});
        f.sensor().refuse(ItemId::HighSetValue);
        f.applyAndSettle();
        const ApplyReport report = f.applies.value(0);
        QCOMPARE(writtenItems(report.refused), QList{ItemId::HighSetValue});
        QCOMPARE(report.notTried, QList{ItemId::LowSetValue});
        QCOMPARE(writtenItems(report.written), QList{ItemId::DisplayInversion});
        QCOMPARE(f.sensor().writesOf(ItemId::LowSetValue), 0);
        QCOMPARE(f.wanted(ItemId::LowSetValue), high + 10000);
    }

    void aGoalThatBreaksARuleWritesNothing()
    {
        SessionFixture f;
        f.openReady();
        const Value high = *f.session->held(ItemId::HighSetValue);
        f.session->edit({{ItemId::LowSetValue, high + 10000}, {ItemId::DisplayInversion, 1}});
        QVERIFY(!f.session->problems().isEmpty());
        QCOMPARE(f.session->problems().first().rule, lds::settings::Rule::HighNotAboveLow);
        f.applyAndSettle();
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(f.applies.first().planFailure);
        QCOMPARE(f.applies.first().notTried.size(), 2);
        QCOMPARE(f.sensor().writes(), 0);
        QCOMPARE(f.session->pending().count(), 2);
        QVERIFY(f.session->canWrite());
    }

    /// §4.3.4: a hold mode other than None turns One Shot into Hold.
    void whatTheSensorChangesByItselfIsNamedAndIsNobodyElse()
    {
        SessionFixture f;
        f.sensor().set(ItemId::TriggerMode, 1);
        f.openReady();
        f.edit(ItemId::HoldMode, 1);
        f.applyAndSettle();
        QVERIFY(f.applies.first().allDone());
        QCOMPARE(f.applies.first().changedByItself, QList{ItemId::TriggerMode});
        QCOMPARE(f.session->held(ItemId::TriggerMode), std::optional<Value>(0));
        QVERIFY(f.external.isEmpty());
        f.passWalk();
        QVERIFY(f.external.isEmpty());
    }

    void aWriteAcceptedButReadBackOtherwiseKeepsItsEdit()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::Span, 20000}, {ItemId::DisplayInversion, 1}});
        f.sensor().setJudge(
            [](const lds::settings::Values& state, const lds::settings::Write& write) -> FakeSensor::Verdict {
                auto next = state;
                for (const auto& each : write)
                    next.insert(each.item, each.item == ItemId::Span ? 19990 : each.value);
                return next;
            });
        f.applyAndSettle();
        const ApplyReport report = f.applies.value(0);
        QCOMPARE(writtenItems(report.different), QList{ItemId::Span});
        QCOMPARE(report.different.first().readBack.value(ItemId::Span), 19990);
        QCOMPARE(writtenItems(report.written), QList{ItemId::DisplayInversion});
        QCOMPARE(f.wanted(ItemId::Span), 20000);
        QVERIFY(!f.session->pending().find(ItemId::Span)->conflict); // it was us
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(19990));
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 1);
    }

    void cancellingStopsAfterTheWriteUnderWay()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        QVERIFY(f.session->apply());
        f.sensor().holdAnswers(true);
        settle();
        f.session->cancelApply();
        f.sensor().holdAnswers(false);
        f.sensor().deliverAll();
        settle();
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(f.applies.first().cancelled);
        QCOMPARE(f.applies.first().written.size(), 1);
        QCOMPARE(f.applies.first().notTried.size(), 9);
        QCOMPARE(f.sensor().writes(), 1);
        QCOMPARE(f.session->pending().count(), 9);
        QVERIFY(f.session->canWrite());
    }

    /// §5.1.1: the gateway is off only on the way to another network; who cancels there gets it back.
    void cancellingPutsBackWhatWasChangedOnlyForTheWay()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::IpAddress1stOctet, 10},
                         {ItemId::IpAddress2ndOctet, 0},
                         {ItemId::IpAddress3rdOctet, 0},
                         {ItemId::DefaultGateway1stOctet, 10},
                         {ItemId::DefaultGateway2ndOctet, 0},
                         {ItemId::DefaultGateway3rdOctet, 0}});
        const auto before = f.session->heldValues();
        const auto plan = f.session->plan();
        QVERIFY(plan);
        QVERIFY(plan->steps.size() > 2); // there is something between
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 1)
                f.session->cancelApply();
        });
        f.applyAndSettle();
        QVERIFY(f.applies.value(0).cancelled);
        QCOMPARE(f.sensor().value(ItemId::IpAddress1stOctet), before.value(ItemId::IpAddress1stOctet));
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway1stOctet),
                 before.value(ItemId::DefaultGateway1stOctet));
        QCOMPARE(f.session->pending().count(), 2);
        for (auto it = f.session->pending().edits().begin(); it != f.session->pending().edits().end(); ++it)
            QVERIFY(!it->conflict);
    }

    /// §5.1.1: the gateway is 0.0.0.0 for a moment, which some of its octets are to be in the end.
    void aSensorMovesToAnotherNetwork()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::IpAddress1stOctet, 10},
                         {ItemId::IpAddress2ndOctet, 0},
                         {ItemId::IpAddress3rdOctet, 0},
                         {ItemId::DefaultGateway1stOctet, 10},
                         {ItemId::DefaultGateway2ndOctet, 0},
                         {ItemId::DefaultGateway3rdOctet, 0}});
        QCOMPARE(f.session->pending().count(), 2);
        f.applyAndSettle();
        QVERIFY(f.applies.value(0).allDone());
        QVERIFY(f.session->pending().isEmpty());
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway1stOctet), 10);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway2ndOctet), 0);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway4thOctet), 1);
        QCOMPARE(f.sensor().value(ItemId::IpAddress4thOctet), 6);
    }

    void aCutOnTheWayToAnotherNetworkForgetsNothing()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::IpAddress1stOctet, 10},
                         {ItemId::IpAddress2ndOctet, 0},
                         {ItemId::DefaultGateway1stOctet, 10},
                         {ItemId::DefaultGateway2ndOctet, 0}});
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 2)
                f.sensor().cut();
        });
        f.applyAndSettle();
        QVERIFY(f.applies.value(0).connectionLost);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway1stOctet), 0); // that far it got
        f.sensor().setOnRequest({});
        f.pass(500);
        QVERIFY(f.session->isReady());
        QCOMPARE(f.session->pending().count(), 2);
        f.applyAndSettle();
        QVERIFY(f.applies.last().allDone());
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway1stOctet), 10);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway3rdOctet), 1);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway4thOctet), 1);
    }

    void anAddressAndItsGatewayAreTwoChangesWrittenWhole()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::IpAddress1stOctet, 10}, {ItemId::DefaultGateway1stOctet, 10}});
        f.applyAndSettle();
        QVERIFY(f.applies.first().allDone());
        QCOMPARE(f.sensor().value(ItemId::IpAddress1stOctet), 10);
        QCOMPARE(f.sensor().value(ItemId::DefaultGateway1stOctet), 10);
        QVERIFY(f.session->pending().isEmpty());
        for (const Request& request : f.sensor().requests()) {
            if (request.kind == RequestKind::Write)
                QCOMPARE(request.write.size(), 4);
        }
    }

    void aConflictIsLeftAloneUntilThePersonKeepsTheirs()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::Span, 20000}, {ItemId::DisplayInversion, 1}});
        f.sensor().set(ItemId::Span, 15000);
        f.passWalk();
        QCOMPARE(f.conflicts, QList{ItemId::Span});
        f.applyAndSettle();
        QCOMPARE(f.applies.first().inConflict, QList{ItemId::Span});
        QVERIFY(!f.applies.first().allDone());
        QCOMPARE(writtenItems(f.applies.first().written), QList{ItemId::DisplayInversion});
        QCOMPARE(f.sensor().value(ItemId::Span), 15000);
        QVERIFY(f.session->pending().find(ItemId::Span)->conflict);
        f.session->keepMine(ItemId::Span);
        f.applyAndSettle();
        QVERIFY(f.applies.last().allDone());
        QCOMPARE(f.sensor().value(ItemId::Span), 20000);
    }

    void anEditTakenBackWhileApplyingIsNotWritten()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 1)
                f.session->revertAll();
        });
        f.applyAndSettle();
        QCOMPARE(f.sensor().writes(), 1);
        QCOMPARE(f.applies.size(), 1);
        QVERIFY(f.session->pending().isEmpty());
    }

    void aBankSwitchedByAPlcWhileApplyingStopsTheEditsOfTheOldBank()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::Span, 20000}, {ItemId::Offset, 500}, {ItemId::DisplayInversion, 1}});
        int writes = 0;
        QList<ItemId> first;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind != RequestKind::Write || ++writes != 1)
                return;
            first = itemsOf(request.write);
            f.sensor().setOnRequest([&](const Request& next) {
                if (next.kind == RequestKind::Read) {
                    f.sensor().setOnRequest({});
                    f.sensor().switchBank(2);
                }
            });
        });
        f.applyAndSettle();
        QCOMPARE(f.applies.size(), 1);
        for (const ItemId item : {ItemId::Span, ItemId::Offset}) {
            if (!first.contains(item))
                QCOMPARE(f.sensor().writesOf(item), 0);
            QVERIFY(f.session->pending().find(item)->conflict);
        }
        QCOMPARE(f.session->held(ItemId::BankSwitching), std::optional<Value>(2));
        QVERIFY(f.session->canWrite()); // the other bank's values have been read by now
        QCOMPARE(f.session->held(ItemId::Span), std::optional(f.sensor().value(ItemId::Span)));
    }

    void aSensorThatGoesIntoItsMenuEndsTheApply()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 3)
                f.sensor().setNotReady(true);
        });
        f.applyAndSettle();
        f.pass(2000);
        QCOMPARE(f.applies.size(), 1);
        QCOMPARE(f.applies.first().refused.size(), 1);
        QCOMPARE(f.applies.first().refused.first().failure.code, FailureCode::NotReady);
        QCOMPARE(f.applies.first().written.size(), 2);
        QCOMPARE(f.applies.first().notTried.size(), 7);
        QCOMPARE(f.sensor().writes(), 3);
        QCOMPARE(f.session->pending().count(), 8);
        QVERIFY(f.session->isSensorNotReady());
    }

    void whatAnotherChangedAtARefusalIsSeenAndPlannedAnew()
    {
        SessionFixture f;
        f.openReady();
        const Value low = *f.session->held(ItemId::LowSetValue);
        const Value high = *f.session->held(ItemId::HighSetValue);
        f.session->edit({{ItemId::HighSetValue, low + 10000}, {ItemId::DisplayInversion, 1}});
        f.sensor().set(ItemId::LowSetValue, low + 15000); // a PLC; the session does not know yet
        f.sensor().set(ItemId::HighSetValue, high);
        f.applyAndSettle();
        QCOMPARE(writtenItems(f.applies.value(0).refused), QList{ItemId::HighSetValue});
        QCOMPARE(writtenItems(f.applies.value(0).written), QList{ItemId::DisplayInversion});
        QCOMPARE(f.session->held(ItemId::LowSetValue), std::optional(low + 15000));
        QCOMPARE(f.external.size(), 1);
        QCOMPARE(f.sensor().writesOf(ItemId::HighSetValue), 1);
    }
};

QTEST_GUILESS_MAIN(SessionApplyTest)
#include "tst_session_apply.moc"
