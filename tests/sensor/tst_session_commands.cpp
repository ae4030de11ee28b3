#include "session_fixture.h"

using namespace lds::sensor;
using lds::catalog::Role;
using lds::ports::FailureCode;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Status;
using lds::support::FakeSensor;
using lds::support::settle;

class SessionCommandsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void savingHasThreeAnswers()
    {
        SessionFixture f;
        f.openReady();
        QCOMPARE(f.session->saved(), Saved::Unknown); // after connecting nobody can tell
        f.edit(ItemId::Span, 20000);
        f.applyAndSettle();
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        f.runAndSettle(ItemId::SetValueSaving, 0);
        QCOMPARE(f.session->saved(), Saved::Saved);
        QCOMPARE(f.commands.size(), 1);
        QCOMPARE(f.commands.first().status, Status::Done);
        QCOMPARE(f.sensor().requests().last().timeoutMs, 15000); // §5.3.3

        f.edit(ItemId::Span, 30000);
        f.applyAndSettle();
        f.sensor().refuse(ItemId::SetValueSaving, FailureCode::NotReady);
        f.runAndSettle(ItemId::SetValueSaving, 0);
        QCOMPARE(f.commands.last().status, Status::Refused);
        QCOMPARE(f.commands.last().failure.code, FailureCode::NotReady);
        QCOMPARE(f.session->saved(), Saved::NotSaved);

        f.sensor().acceptAgain(ItemId::SetValueSaving);
        f.sensor().loseAnswer(ItemId::SetValueSaving, FakeSensor::Carried::Out);
        f.runAndSettle(ItemId::SetValueSaving, 0);
        QVERIFY(f.session->isRunning());
        f.sensor().timeOut();
        settle();
        QVERIFY(!f.session->isRunning());
        QCOMPARE(f.commands.last().status, Status::Unknown);
        QCOMPARE(f.session->saved(), Saved::Unknown);
        QCOMPARE(f.commands.size(), 3);
    }

    void savingIsNeverAutomatic()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.applyAndSettle();
        f.passWalk();
        f.session->close();
        settle();
        QCOMPARE(f.sensor().writesOf(ItemId::SetValueSaving), 0);
    }

    void aSwitchIsReadBackBeforeItIsDone()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().setOnRequest([&f](const Request&) { QVERIFY(f.commands.isEmpty()); });
        f.runAndSettle(ItemId::LaserStop, 1);
        QCOMPARE(f.commands.value(0).status, Status::Done);
        QCOMPARE(f.commands.value(0).item, ItemId::LaserStop);
        QCOMPARE(f.commands.value(0).value, 1);
        QCOMPARE(f.session->held(ItemId::LaserStop), std::optional<Value>(1));
        QVERIFY(f.sensor().readsOf(ItemId::LaserStop) > 0);
        QVERIFY(f.external.isEmpty());
        QCOMPARE(f.session->saved(), Saved::NotSaved);
    }

    void aSwitchedBankIsReadWholeAndItsEditsStayWithTheirBank()
    {
        SessionFixture f;
        f.sensor().switchBank(2);
        f.sensor().set(ItemId::Span, 15000);
        f.sensor().set(ItemId::ZeroSetting, 1);
        f.sensor().switchBank(1);
        f.openReady();
        f.edit(ItemId::Offset, 500);
        f.runAndSettle(ItemId::BankSwitching, 2);
        QCOMPARE(f.commands.value(0).status, Status::Done);
        QCOMPARE(f.session->held(ItemId::BankSwitching), std::optional<Value>(2));
        QCOMPARE(f.session->held(ItemId::Span), std::optional<Value>(15000));
        QCOMPARE(f.session->held(ItemId::ZeroSetting), std::optional<Value>(1));
        QVERIFY(f.external.isEmpty());
        QVERIFY(f.session->pending().find(ItemId::Offset)->conflict);
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        f.runAndSettle(ItemId::BankSwitching, 1);
        QVERIFY(!f.session->pending().find(ItemId::Offset)->conflict);
    }

    void initialisationIsReadBackWhole()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.applyAndSettle();
        f.runAndSettle(ItemId::SettingsInitialization, 1);
        QCOMPARE(f.commands.value(0).status, Status::Done);
        QCOMPARE(f.session->held(ItemId::Span), std::optional(f.sensor().value(ItemId::Span)));
        QVERIFY(f.session->held(ItemId::Span) != std::optional<Value>(20000));
        QCOMPARE(f.session->saved(), Saved::Unknown);
        QVERIFY(f.external.isEmpty());
    }

    void aBusySensorAfterInitialisingIsReadWhenItIsBack()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().setOnRequest([&f](const Request& request) {
            if (request.kind == RequestKind::Write)
                f.sensor().refuseReads(FailureCode::NotReady);
        });
        f.runAndSettle(ItemId::SettingsInitialization, 6);
        f.pass(3000);
        QVERIFY(f.session->isRunning());
        f.sensor().refuseReads(FailureCode::None);
        f.pass(600);
        QCOMPARE(f.commands.value(0).status, Status::Done);
        QCOMPARE(f.sensor().writes(), 1);
    }

    /// Every switch, procedure step and command there is, with its answer lost.
    void aLostAnswerIsNeverWrittenAgain_data()
    {
        QTest::addColumn<ItemId>("item");
        QTest::addColumn<Value>("value");
        QTest::addColumn<bool>("carriedOut");
        for (const auto& item : lds::catalog::Catalog::hlG2().items()) {
            if (item.role == Role::Setting || item.role == Role::Status || !item.isWritable())
                continue;
            const Value value = item.choices.empty() ? 0 : item.choices.back().code;
            QTest::addRow("%s, carried out", item.key) << item.id << value << true;
            QTest::addRow("%s, not carried out", item.key) << item.id << value << false;
        }
    }
    void aLostAnswerIsNeverWrittenAgain()
    {
        QFETCH(ItemId, item);
        QFETCH(Value, value);
        QFETCH(bool, carriedOut);
        SessionFixture f;
        f.openReady();
        f.sensor().loseAnswer(item, carriedOut ? FakeSensor::Carried::Out : FakeSensor::Carried::Not);
        f.runAndSettle(item, value);
        QVERIFY(f.session->isRunning());
        f.sensor().timeOut();
        settle();
        f.passWalk();
        QVERIFY(!f.session->isRunning());
        QCOMPARE(f.sensor().writesOf(item), 1);
        QCOMPARE(f.commands.size(), 1);
        const bool canTell = lds::catalog::hlG2(item).isReadable();
        QCOMPARE(f.commands.first().status, canTell && carriedOut ? Status::Done : Status::Unknown);
    }

    void aCutDuringACommandEndsItAsUnknown()
    {
        SessionFixture f;
        f.openReady();
        f.sensor().setOnRequest([&f](const Request& request) {
            if (request.kind == RequestKind::Write)
                f.sensor().cut();
        });
        f.runAndSettle(ItemId::LaserStop, 1);
        QCOMPARE(f.commands.size(), 1);
        QCOMPARE(f.commands.first().status, Status::Unknown);
        QCOMPARE(f.commands.first().failure.code, FailureCode::ConnectionLost);
        f.sensor().setOnRequest({});
        f.pass(500);
        QVERIFY(f.session->isReady());
        QCOMPARE(f.sensor().writesOf(ItemId::LaserStop), 1);
        QCOMPARE(f.commands.size(), 1);
    }

    void closingOrDeletingDuringACommandEndsItExactlyOnce()
    {
        for (const bool destroy : {false, true}) {
            SessionFixture f;
            f.openReady();
            int finished = 0;
            connect(f.session.get(), &SensorSession::commandFinished, this, [&finished] { ++finished; });
            f.sensor().holdAnswers(true);
            QVERIFY(f.session->run(ItemId::SetValueSaving, 0));
            settle();
            if (destroy)
                f.session.reset();
            else
                f.session->close();
            f.sensor().deliverAll();
            settle();
            QCOMPARE(finished, 1);
        }
    }

    void oneThingAtATime()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().holdAnswers(true);
        QVERIFY(f.session->run(ItemId::LaserStop, 1));
        QVERIFY(!f.session->run(ItemId::KeyLock, 1));
        QVERIFY(!f.session->apply());
        QVERIFY(!f.session->canWrite());
        f.sensor().holdAnswers(false);
        settle();
        f.sensor().deliverAll();
        settle();
        QVERIFY(f.session->canWrite());
        QVERIFY(f.session->run(ItemId::KeyLock, 1));
    }

    void whatCannotBeRunIsNotRun()
    {
        SessionFixture f;
        QVERIFY(!f.session->run(ItemId::LaserStop, 1)); // closed
        f.sensor().hide(ItemId::ZeroSetting);
        f.openReady();
        QVERIFY(!f.session->run(ItemId::Span, 20000));       // a setting
        QVERIFY(!f.session->run(ItemId::SensorState, 1));    // a status
        QVERIFY(!f.session->run(ItemId::BankSwitching, 5));  // no such bank
        QVERIFY(!f.session->run(ItemId::SetValueSaving, 1)); // reserved (§5.2.4, note 1)
        QVERIFY(!f.session->run(ItemId::ZeroSetting, 1));    // not reached
        settle();
        QCOMPARE(f.sensor().writes(), 0);
        QVERIFY(f.commands.isEmpty());
    }

    void theNextStepMayBeStartedFromTheEndOfTheLast()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        connect(f.session.get(), &SensorSession::applyFinished, this,
                [&f] { QVERIFY(f.session->run(ItemId::SetValueSaving, 0)); });
        f.applyAndSettle();
        QCOMPARE(f.commands.value(0).status, Status::Done);
        QCOMPARE(f.session->saved(), Saved::Saved);
    }
};

QTEST_GUILESS_MAIN(SessionCommandsTest)
#include "tst_session_commands.moc"
