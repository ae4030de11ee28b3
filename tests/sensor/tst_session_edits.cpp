#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Status;
using lds::support::FakeSensor;
using lds::support::settle;

/// What may be edited, who may write, and how an apply ends when nobody waits for it.
class SessionEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
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
};

QTEST_GUILESS_MAIN(SessionEditsTest)
#include "tst_session_edits.moc"
