#include "pending_edits.h"

#include <QtTest>

using namespace lds::sensor;
using lds::settings::Values;

namespace {

const Values held{{ItemId::HighSetValue, 10000},
                  {ItemId::LowSetValue, -10000},
                  {ItemId::EcoMode, 0},
                  {ItemId::BankSwitching, 1},
                  {ItemId::Span, 10000}};

Values with(Values values, ItemId item, Value value)
{
    values.insert(item, value);
    return values;
}

} // namespace

class PendingEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEditKeepsWhatTheSensorHeld()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        const auto edit = edits.find(ItemId::HighSetValue);
        QVERIFY(edit);
        QCOMPARE(edit->wanted, 20000);
        QCOMPARE(edit->base, 10000);
        QVERIFY(!edit->conflict);
    }

    void anEditBackToWhatIsHeldIsNone()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.set({{ItemId::HighSetValue, 10000}}, held);
        QVERIFY(edits.isEmpty());
        edits.undo(held);
        QCOMPARE(edits.find(ItemId::HighSetValue)->wanted, 20000);
    }

    void undoAndRedoGoStepByStep()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.set({{ItemId::HighSetValue, 30000}, {ItemId::EcoMode, 1}}, held);
        edits.clear();
        QVERIFY(edits.isEmpty());
        edits.undo(held);
        QCOMPARE(edits.edits().size(), 2);
        edits.undo(held);
        QCOMPARE(edits.edits().size(), 1);
        QCOMPARE(edits.find(ItemId::HighSetValue)->wanted, 20000);
        edits.undo(held);
        QVERIFY(edits.isEmpty());
        QVERIFY(!edits.canUndo());
        edits.redo(held);
        edits.redo(held);
        QCOMPARE(edits.find(ItemId::HighSetValue)->wanted, 30000);
        QVERIFY(edits.canRedo());
        edits.set({{ItemId::Span, 20000}}, held); // another way from here
        QVERIFY(!edits.canRedo());
    }

    void aStepThatChangesNothingIsNotCounted()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 10000}}, held);
        QVERIFY(!edits.canUndo());
        edits.clear();
        QVERIFY(!edits.canUndo());
        edits.remove({ItemId::Span});
        QVERIFY(!edits.canUndo());
    }

    void theOctetsOfAnAddressAreOneChange()
    {
        PendingEdits edits;
        edits.set({{ItemId::IpAddress4thOctet, 7}, {ItemId::IpAddress3rdOctet, 2}, {ItemId::EcoMode, 1}},
                  held);
        QCOMPARE(edits.count(), 2);
    }

    void theOctetsOfAnAddressComeTrueAndAreTakenBackTogether()
    {
        const Values gateway{{ItemId::DefaultGateway1stOctet, 192},
                             {ItemId::DefaultGateway2ndOctet, 168},
                             {ItemId::DefaultGateway3rdOctet, 1},
                             {ItemId::DefaultGateway4thOctet, 1}};
        Values off = gateway;
        for (auto& octet : off)
            octet = 0;
        PendingEdits edits;
        edits.set({{ItemId::DefaultGateway1stOctet, 10},
                   {ItemId::DefaultGateway2ndOctet, 0},
                   {ItemId::DefaultGateway3rdOctet, 0}},
                  gateway);
        QCOMPARE(edits.edits().size(), 4);
        QCOMPARE(edits.find(ItemId::DefaultGateway4thOctet)->wanted, 1);
        edits.follow(gateway.keys(), off); // on its way
        QCOMPARE(edits.edits().size(), 4);
        for (const PendingEdit& edit : edits.edits())
            QVERIFY(!edit.conflict);
        edits.rebase(with(off, ItemId::DefaultGateway4thOctet, 9)); // somebody else
        for (const PendingEdit& edit : edits.edits())
            QVERIFY(edit.conflict);
        edits.confirm(ItemId::DefaultGateway1stOctet, off);
        for (const PendingEdit& edit : edits.edits())
            QVERIFY(!edit.conflict);
        edits.remove({ItemId::DefaultGateway2ndOctet});
        QVERIFY(edits.isEmpty());
        edits.undo(off);
        QCOMPARE(edits.edits().size(), 4);
        edits.rebase(edits.wantedValues());
        QVERIFY(edits.isEmpty());
    }

    void anAddressTypedBackIsNoEdit()
    {
        const Values gateway{{ItemId::DefaultGateway1stOctet, 192},
                             {ItemId::DefaultGateway2ndOctet, 168},
                             {ItemId::DefaultGateway3rdOctet, 1},
                             {ItemId::DefaultGateway4thOctet, 1}};
        PendingEdits edits;
        edits.set({{ItemId::DefaultGateway4thOctet, 7}}, gateway);
        edits.set({{ItemId::DefaultGateway4thOctet, 1}}, gateway);
        QVERIFY(edits.isEmpty());
    }

    void aMovedBaseIsAConflictUntilConfirmed()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        const Values moved = with(held, ItemId::HighSetValue, 15000);
        edits.rebase(moved);
        QVERIFY(edits.find(ItemId::HighSetValue)->conflict);
        QCOMPARE(edits.find(ItemId::HighSetValue)->base, 10000);
        edits.confirm(ItemId::HighSetValue, moved);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
        QCOMPARE(edits.find(ItemId::HighSetValue)->base, 15000);
        QCOMPARE(edits.find(ItemId::HighSetValue)->wanted, 20000);
    }

    void aBaseThatMovesBackIsNoConflict()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.rebase(with(held, ItemId::HighSetValue, 15000));
        edits.rebase(held);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
    }

    void anEditThatHasComeTrueVanishes()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}, {ItemId::EcoMode, 1}}, held);
        edits.rebase(with(held, ItemId::HighSetValue, 20000));
        QVERIFY(!edits.find(ItemId::HighSetValue));
        QVERIFY(edits.find(ItemId::EcoMode));
    }

    void anAppliedEditIsForgottenByUndoAndRedo()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.set({{ItemId::EcoMode, 1}}, held);
        edits.applied(ItemId::HighSetValue);
        QCOMPARE(edits.edits().keys(), QList{ItemId::EcoMode});
        const Values now = with(held, ItemId::HighSetValue, 20000);
        edits.undo(now);
        QVERIFY(edits.isEmpty());
        QVERIFY(!edits.canUndo());
        edits.redo(now);
        QCOMPARE(edits.edits().keys(), QList{ItemId::EcoMode});
    }

    void undoOfWhatHasMovedMeanwhileIsAConflict()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.clear();
        const Values moved = with(held, ItemId::HighSetValue, 15000);
        edits.rebase(moved);
        edits.undo(moved);
        QVERIFY(edits.find(ItemId::HighSetValue)->conflict);
    }

    /// §4.2: each bank has its own HIGH; an edit made for one must not slip into another.
    void anEditForAnotherBankIsInConflictAndIsNotLost()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}, {ItemId::EcoMode, 1}}, held);
        Values bankTwo = with(held, ItemId::BankSwitching, 2);
        edits.rebase(bankTwo); // the same HIGH there
        QVERIFY(edits.find(ItemId::HighSetValue)->conflict);
        QVERIFY(!edits.find(ItemId::EcoMode)->conflict); // common to all banks
        edits.rebase(with(bankTwo, ItemId::HighSetValue, 20000));
        QVERIFY(edits.find(ItemId::HighSetValue));
        edits.rebase(held);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
    }

    void whatThisProgramChangesIsFollowed()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}}, held);
        edits.set({{ItemId::HighSetValue, 30000}}, held);
        const Values now = with(held, ItemId::HighSetValue, 15000);
        edits.follow({ItemId::HighSetValue}, now);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
        QCOMPARE(edits.find(ItemId::HighSetValue)->base, 15000);
        edits.undo(now);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
    }

    void anEditBeforeTheFirstReadingGetsItsBaseFromIt()
    {
        PendingEdits edits;
        edits.set({{ItemId::HighSetValue, 20000}, {ItemId::EcoMode, 1}}, {});
        QCOMPARE(edits.edits().size(), 2);
        edits.rebase(with(held, ItemId::EcoMode, 1));
        QCOMPARE(edits.find(ItemId::HighSetValue)->base, 10000);
        QVERIFY(!edits.find(ItemId::HighSetValue)->conflict);
        QVERIFY(!edits.find(ItemId::EcoMode));
    }
};

QTEST_GUILESS_MAIN(PendingEditsTest)
#include "tst_pending_edits.moc"
