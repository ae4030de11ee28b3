#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Status;
using lds::support::FakeSensor;
using lds::support::settle;

namespace {

/// Ten settings that no rule ties together, with other values than the factory's.
const QList<lds::settings::ItemValue> tenEdits{
    {ItemId::SamplingFrequency, 2},  {ItemId::AverageTimes, 1},
    {ItemId::Span, 20000},           {ItemId::Offset, 500},
    {ItemId::DisplayDigit, 2},       {ItemId::DisplayInversion, 1},
    {ItemId::AlarmDelayCount, 77},   {ItemId::OutputDelayTimerSetting, 7},
    {ItemId::AlarmDigitalOutput, 1}, {ItemId::TeachingMode, 3},
};

QList<ItemId> itemsOf(const QList<lds::settings::ItemValue>& values)
{
    QList<ItemId> items;
    for (const auto& each : values)
        items.append(each.item);
    return items;
}

} // namespace

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

    /// Design: a lost reply to a write is never answered by writing again. Every setting there is.
    void aLostAnswerIsNeverWrittenAgain_data()
    {
        QTest::addColumn<ItemId>("item");
        QTest::addColumn<bool>("carriedOut");
        for (const auto& item : lds::catalog::Catalog::hlG2().items()) {
            if (item.role != lds::catalog::Role::Setting || !item.isWritable())
                continue;
            QTest::addRow("%s, carried out", item.key) << item.id << true;
            QTest::addRow("%s, not carried out", item.key) << item.id << false;
        }
    }
    void aLostAnswerIsNeverWrittenAgain()
    {
        QFETCH(ItemId, item);
        QFETCH(bool, carriedOut);
        SessionFixture f;
        prepareNetworkFor(item, f.sensor());
        f.openReady();
        const Value other = otherValue(f, item);
        QVERIFY2(other != *f.session->held(item), "the test finds no other value");
        f.edit(item, other);
        QVERIFY2(f.session->plan(), "the test's own choice of a value");
        f.sensor().loseAnswer(item, carriedOut ? FakeSensor::Carried::Out : FakeSensor::Carried::Not);
        f.applyAndSettle();
        QCOMPARE(f.sensor().outstanding(), 1);
        QVERIFY(f.session->isApplying());
        f.sensor().timeOut();
        settle();
        f.passWalk();
        QCOMPARE(f.sensor().writesOf(item), 1);
        QCOMPARE(f.applies.size(), 1);
        if (carriedOut) { // found by reading
            QVERIFY(f.applies.first().allDone());
            QVERIFY(!f.session->pending().find(item));
            QCOMPARE(f.session->saved(), Saved::NotSaved);
        } else {
            QVERIFY(writtenItems(f.applies.first().unknown).contains(item));
            QCOMPARE(f.wanted(item), other);
            QVERIFY(!f.applies.first().unknown.first().readBack.isEmpty());
        }
        QCOMPARE(f.session->held(item), std::optional(f.sensor().value(item)));
    }

    void theOthersGoOnAfterALostAnswer()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        f.sensor().loseAnswer(ItemId::Offset, FakeSensor::Carried::Not);
        f.applyAndSettle();
        f.sensor().timeOut();
        settle();
        QCOMPARE(writtenItems(f.applies.value(0).unknown), QList{ItemId::Offset});
        QCOMPARE(f.applies.value(0).written.size(), 9);
        QCOMPARE(f.session->pending().edits().keys(), QList{ItemId::Offset});
    }

    void aReadBackWithoutAnswerIsRepeatedButNotForEver()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().loseReads(1);
        f.applyAndSettle();
        f.sensor().timeOut();
        settle();
        f.pass(300);
        QVERIFY(f.applies.value(0).allDone());
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 1);

        f.edit(ItemId::Span, 30000);
        f.sensor().loseReads(1000);
        f.applyAndSettle();
        for (int i = 0; i < 10 && f.applies.size() < 2; ++i) {
            f.sensor().timeOut();
            settle();
            f.pass(300);
        }
        QCOMPARE(f.applies.size(), 2);
        QCOMPARE(writtenItems(f.applies.last().unknown), QList{ItemId::Span});
        QVERIFY(f.applies.last().unknown.first().readBack.isEmpty());
        QCOMPARE(f.wanted(ItemId::Span), 30000);
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 2);
    }

    void aCutInTheMiddleStopsAndKeepsWhatIsNotDone()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 4)
                f.sensor().cut();
        });
        f.applyAndSettle();
        QCOMPARE(f.applies.size(), 1);
        const ApplyReport report = f.applies.first();
        QVERIFY(report.connectionLost);
        QCOMPARE(report.written.size(), 3);
        QCOMPARE(report.unknown.size(), 1);
        QCOMPARE(report.notTried.size(), 6);
        QCOMPARE(f.session->pending().count(), 7);
        QCOMPARE(f.session->connection(), Connection::Reconnecting);
        f.sensor().setOnRequest({});
        f.pass(500);
        QVERIFY(f.session->isReady());
        f.passWalk();
        QCOMPARE(f.sensor().writes(), 4); // reconnecting writes nothing
        QCOMPARE(f.session->pending().count(), 7);
        QCOMPARE(f.applies.size(), 1);
        f.applyAndSettle();
        QVERIFY(f.applies.last().allDone());
        for (const auto& each : tenEdits)
            QCOMPARE(f.sensor().value(each.item), each.value);
    }

    /// The write went through, the connection did not: reading again after the cut shows it.
    void anEditCarriedOutJustBeforeTheCutComesTrueByReading()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().loseAnswer(ItemId::Span, FakeSensor::Carried::Out);
        f.applyAndSettle();
        f.sensor().cut();
        settle();
        QVERIFY(f.applies.value(0).connectionLost);
        QVERIFY(f.session->pending().find(ItemId::Span));
        f.pass(500);
        QVERIFY(f.session->isReady());
        QVERIFY(f.session->pending().isEmpty());
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

    void onlySettingsCanBeEdited()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit({{ItemId::LaserStop, 1}, {ItemId::MeasuredValue, 1}, {ItemId::MacAddress, 1}});
        QVERIFY(f.session->pending().isEmpty());
        QVERIFY(!f.session->editText(ItemId::LaserStop, QStringLiteral("1")));
        QVERIFY(f.session->pending().isEmpty());
        QVERIFY(!f.session->isEditable(ItemId::BankSwitching));
        QVERIFY(f.session->isEditable(ItemId::Span));
    }

    void aTextBecomesAnEditAsTheSensorWillRoundIt()
    {
        SessionFixture f(false, lds::catalog::SensorModel::HlG205); // resolution 1 µm
        f.openReady();
        const auto parsed = f.session->editText(ItemId::Offset, QStringLiteral("1.2349 mm"));
        QVERIFY(parsed);
        QCOMPARE(parsed->written, 12349);
        QCOMPARE(parsed->effective, 12340);
        QCOMPARE(f.wanted(ItemId::Offset), 12340);
        for (const char* wrong : {"", "abc", "1.2.3", "1000000"})
            QVERIFY(!f.session->editText(ItemId::Offset, QString::fromLatin1(wrong)));
        QCOMPARE(f.wanted(ItemId::Offset), 12340); // nothing entered is lost
    }

    void undoAndRedoAreTold()
    {
        SessionFixture f;
        f.openReady();
        QSignalSpy pending(f.session.get(), &SensorSession::pendingChanged);
        f.edit(ItemId::Span, 20000);
        f.session->undo();
        QVERIFY(f.session->pending().isEmpty());
        f.session->redo();
        QCOMPARE(f.wanted(ItemId::Span), 20000);
        f.session->revert({ItemId::Span});
        QVERIFY(f.session->pending().isEmpty());
        QCOMPARE(pending.count(), 4);
        QCOMPARE(f.sensor().writes(), 0);
    }

    void viewOnlyNeverWrites()
    {
        SessionFixture f(true);
        f.openReady();
        QVERIFY(f.session->isViewOnly());
        f.edit(ItemId::Span, 20000);
        QVERIFY(!f.session->canWrite());
        QVERIFY(!f.session->apply());
        QVERIFY(!f.session->run(ItemId::SetValueSaving, 0));
        f.passWalk();
        QCOMPARE(f.sensor().writes(), 0);
        QVERIFY(f.applies.isEmpty());
        QVERIFY(f.commands.isEmpty());
    }

    void whileSomebodyElseHoldsTheLeaseNothingIsWritten()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        QSignalSpy busy(f.session.get(), &SensorSession::busyChanged);
        Lease lease = f.session->leases().acquire();
        QVERIFY(lease.isHeld());
        QCOMPARE(busy.count(), 1);
        QVERIFY(!f.session->canWrite());
        QVERIFY(!f.session->apply());
        QVERIFY(!f.session->run(ItemId::LaserStop, 1));
        lease.release();
        QCOMPARE(busy.count(), 2);
        QVERIFY(f.session->apply());
        QVERIFY(!f.session->leases().acquire().isHeld()); // the apply has it
        QVERIFY(!f.session->apply());
        settle();
        QVERIFY(f.applies.value(0).allDone());
        QVERIFY(f.session->leases().acquire().isHeld());
    }

    void closingWhileApplyingEndsItExactlyOnce_data()
    {
        QTest::addColumn<bool>("destroy");
        QTest::addColumn<bool>("begun");
        QTest::newRow("closed before the first write") << false << false;
        QTest::newRow("closed during a write") << false << true;
        QTest::newRow("deleted before the first write") << true << false;
        QTest::newRow("deleted during a write") << true << true;
    }
    void closingWhileApplyingEndsItExactlyOnce()
    {
        QFETCH(bool, destroy);
        QFETCH(bool, begun);
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        QList<ApplyReport> reports;
        connect(f.session.get(), &SensorSession::applyFinished, this,
                [&reports](const ApplyReport& report) { reports.append(report); });
        f.sensor().holdAnswers(true);
        QVERIFY(f.session->apply());
        if (begun)
            settle();
        if (destroy)
            f.session.reset();
        else
            f.session->close();
        QCOMPARE(reports.size(), 1);
        f.sensor().deliverAll();
        settle();
        QCOMPARE(reports.size(), 1);
        QVERIFY(reports.first().connectionLost);
        QCOMPARE(reports.first().unknown.size(), begun ? 1 : 0);
        QCOMPARE(reports.first().notTried.size(), begun ? 9 : 10);
        if (!destroy)
            QCOMPARE(f.session->pending().count(), 10);
    }

    void theSessionMayBeDeletedWhenTheApplyEnds()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        connect(f.session.get(), &SensorSession::applyFinished, this, [&f] { f.session.reset(); });
        QVERIFY(f.session->apply());
        settle();
        QVERIFY(!f.session);
    }

    void theSessionMayBeDeletedAtAnyProgress()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        int finished = 0;
        connect(f.session.get(), &SensorSession::applyProgress, this, [&f](int done) {
            if (done == 3)
                f.session.reset();
        });
        connect(f.session.get(), &SensorSession::applyFinished, this, [&finished] { ++finished; });
        QVERIFY(f.session->apply());
        settle();
        QVERIFY(!f.session);
        QCOMPARE(finished, 1);
    }

private:
    /// An address in which one octet can be changed by itself.
    static void prepareNetworkFor(ItemId item, FakeSensor& sensor)
    {
        const QList masks{ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet, ItemId::SubnetMask3rdOctet,
                          ItemId::SubnetMask4thOctet};
        const auto setMask = [&](Value first, Value second, Value third) {
            sensor.set(masks[0], first);
            sensor.set(masks[1], second);
            sensor.set(masks[2], third);
            sensor.set(masks[3], 0);
        };
        const auto group = lds::catalog::hlG2(item).group;
        if (group == lds::catalog::WriteGroup::DefaultGateway)
            return setMask(128, 0, 0); // nearly everything is one network
        if (group != lds::catalog::WriteGroup::None) {
            for (const ItemId octet : {ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                                       ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet})
                sensor.set(octet, 0);
        }
        if (item == ItemId::SubnetMask1stOctet)
            setMask(255, 0, 0);
        if (item == ItemId::SubnetMask2ndOctet)
            setMask(255, 255, 0);
    }

    /// Another legal value, such that the rules find a way there.
    static Value otherValue(SessionFixture& f, ItemId id)
    {
        const auto& item = lds::catalog::hlG2(id);
        const Value now = *f.session->held(id);
        const auto& limits = item.limitsFor(f.session->model());
        QList<Value> candidates;
        for (const auto& choice : item.choices) {
            if (choice.models & lds::catalog::maskOf(f.session->model()))
                candidates.append(choice.code);
        }
        candidates += {now + limits.resolution, now - limits.resolution, 0, 1, 128, 192, 254, 255};
        for (const Value value : std::as_const(candidates)) {
            if (value == now || value < limits.minimum || value > limits.maximum)
                continue;
            const auto plan =
                lds::settings::planWrites(f.session->model(), f.session->heldValues(), {{id, value}});
            // One write of the item, so that it can be counted.
            if (plan && std::count_if(plan->steps.begin(), plan->steps.end(),
                                      [id](const auto& step) { return itemsOf(step).contains(id); }) == 1)
                return value;
        }
        return now;
    }
};

QTEST_GUILESS_MAIN(SessionApplyTest)
#include "tst_session_apply.moc"
