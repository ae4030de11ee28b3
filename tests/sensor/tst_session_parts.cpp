#include "command_effects.h"
#include "held_values.h"
#include "measurement_rate.h"
#include "reconnect_policy.h"
#include "settings_walk.h"

#include <QtTest>

using namespace lds::sensor;
using lds::ports::OpenFailure;

/// The small pieces a session is put together from.
class SessionPartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void tryingAgainDoublesUpToTheLongest()
    {
        ReconnectPolicy policy(500, 3000);
        QList<int> delays;
        for (int i = 0; i < 5; ++i)
            delays.append(policy.nextDelayMs(OpenFailure::Lost));
        QCOMPARE(delays, (QList<int>{500, 1000, 2000, 3000, 3000}));
        policy.reset();
        QCOMPARE(policy.nextDelayMs(OpenFailure::Refused), 500);
    }

    void aWrongHostIsAskedSlowlyAndASensorInItsMenuQuickly()
    {
        ReconnectPolicy policy(500, 8000);
        QCOMPARE(policy.nextDelayMs(OpenFailure::HostNotFound), 8000);
        QCOMPARE(policy.nextDelayMs(OpenFailure::NotASensor), 8000);
        for (int i = 0; i < 5; ++i)
            QCOMPARE(policy.nextDelayMs(OpenFailure::NotReady), 500);
    }

    void anUnpluggedAdapterIsLookedForQuicklyAndAWrongPortSlowly()
    {
        ReconnectPolicy policy(500, 8000);
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(policy.nextDelayMs(OpenFailure::PortGone), 500);
            QCOMPARE(policy.nextDelayMs(OpenFailure::NoSuchPort), 500);
        }
        QCOMPARE(policy.nextDelayMs(OpenFailure::PortNotPermitted), 8000);
        QCOMPARE(policy.nextDelayMs(OpenFailure::PortUnusable), 8000);
        QCOMPARE(policy.nextDelayMs(OpenFailure::PortSettingsDiffer), 8000);
        QCOMPARE(policy.nextDelayMs(OpenFailure::PortBusy), 500); // Somebody may be about to end the other.
    }

    void theRateLooksBackOneSecond()
    {
        MeasurementRate rate;
        QCOMPARE(rate.perSecond(0), 0.0);
        for (int i = 0; i <= 200; ++i) // 100 a second for two seconds
            rate.add({{.monotonicNs = 1'000'000'000 + i * 10'000'000LL}});
        QCOMPARE(rate.perSecond(3'000'000'000), 100.0);
        QCOMPARE(rate.perSecond(3'500'000'000), 50.0); // half of the last second was silent
        QCOMPARE(rate.perSecond(9'000'000'000), 0.0);
    }

    void theRateOfAYoungStreamIsThatOfWhatThereIs()
    {
        MeasurementRate rate;
        for (int i = 0; i < 11; ++i)
            rate.add({{.monotonicNs = 1'000'000'000 + i * 10'000'000LL}});
        QCOMPARE(rate.perSecond(1'100'000'000), 100.0);
    }

    void theWalkComesToEveryItemAndWatchesTheBankAllTheWay()
    {
        const QList<ItemId> items{ItemId::BankSwitching, ItemId::HighSetValue, ItemId::LowSetValue,
                                  ItemId::Hysteresis,    ItemId::EcoMode,      ItemId::AlarmDelayCount,
                                  ItemId::DisplayDigit,  ItemId::Span,         ItemId::Offset,
                                  ItemId::Tolerance,     ItemId::LaserStop};
        SettingsWalk walk(items);
        QList<ItemId> seen;
        for (int piece = 0; piece < 2; ++piece) {
            const QList<ItemId> next = walk.next();
            QVERIFY(next.contains(ItemId::BankSwitching));
            QVERIFY(next.size() <= SettingsWalk::pieceSize + 1);
            seen += next;
        }
        for (const ItemId item : items)
            QVERIFY(seen.contains(item));
        QCOMPARE(walk.next().at(1), ItemId::HighSetValue); // round again
        QVERIFY(SettingsWalk().next().isEmpty());
    }

    /// §4.2, the table of bank copies.
    void theDestinationOfEachBankCopy()
    {
        const QList<Value> destinations{2, 3, 4, 1, 3, 4, 1, 2, 4, 1, 2, 3};
        for (int code = 0; code < 12; ++code)
            QCOMPARE(command_effects::copyDestination(code), destinations.at(code));
    }

    void aCopyIntoTheRunningBankChangesItsValues()
    {
        const lds::settings::Values inBankTwo{{ItemId::BankSwitching, 2}};
        QVERIFY(command_effects::readBack(ItemId::BankCopy, 0, inBankTwo).contains(ItemId::HighSetValue));
        QVERIFY(!command_effects::readBack(ItemId::BankCopy, 1, inBankTwo).contains(ItemId::HighSetValue));
    }

    /// §4.2, "Types of setting items read from banks".
    void aSwitchedBankChangesWhatBanksHold()
    {
        const QList<ItemId> items = command_effects::readBack(ItemId::BankSwitching, 2, {});
        for (const ItemId item : {ItemId::BankSwitching,
                                  ItemId::SamplingFrequency,
                                  ItemId::AverageTimes,
                                  ItemId::BrightnessTuning,
                                  ItemId::HoldMode,
                                  ItemId::Span,
                                  ItemId::Offset,
                                  ItemId::HighSetValue,
                                  ItemId::LowSetValue,
                                  ItemId::Hysteresis,
                                  ItemId::TeachingMode,
                                  ItemId::Tolerance,
                                  ItemId::OutputDelayTimerSelection,
                                  ItemId::OutputDelayTimerSetting,
                                  ItemId::TriggerMode,
                                  ItemId::AlarmDigitalOutput,
                                  ItemId::AlarmDelayCount,
                                  ItemId::DisplayDigit,
                                  ItemId::ZeroSetting,
                                  ItemId::TriggerInputCommunication})
            QVERIFY2(items.contains(item), qPrintable(QString::number(int(item))));
        QVERIFY(!items.contains(ItemId::EcoMode));
    }

    void whetherItIsSavedAfterEachCommand()
    {
        using namespace command_effects;
        QCOMPARE(savedAfter(Saved::NotSaved, ItemId::SetValueSaving), Saved::Saved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::BankSwitching), Saved::NotSaved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::BankCopy), Saved::Saved);
        QCOMPARE(savedAfter(Saved::NotSaved, ItemId::BankCopy), Saved::NotSaved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::SettingsInitialization), Saved::Unknown);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::LaserStop), Saved::NotSaved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::ZeroSetting), Saved::NotSaved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::Teaching1stPoint), Saved::NotSaved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::MeasuredValueResetting), Saved::Saved);
        QCOMPARE(savedAfter(Saved::Saved, ItemId::TriggerInputCommunication), Saved::Saved);
    }

    void heldValuesTellWhatIsNewAndWhatMoved()
    {
        HeldValues held;
        const auto first = held.update({{ItemId::Span, 10000}, {ItemId::EcoMode, 0}}, 5);
        QCOMPARE(first.items.size(), 2);
        QVERIFY(first.moved.isEmpty());
        const auto second = held.update({{ItemId::Span, 20000}, {ItemId::EcoMode, 0}}, 7);
        QCOMPARE(second.items, QList{ItemId::Span});
        QCOMPARE(second.moved.size(), 1);
        QCOMPARE(second.moved.first().before, 10000);
        QCOMPARE(second.moved.first().after, 20000);
        QCOMPARE(held.readAtNs(ItemId::EcoMode), 7);
        QCOMPARE(held.readAtNs(ItemId::Offset), -1);
    }

    void oneLeaseAtATimeAndItComesBackByItself()
    {
        int changes = 0;
        LeaseDesk desk([&changes] { ++changes; });
        {
            const Lease lease = desk.acquire();
            QVERIFY(lease.isHeld());
            QVERIFY(desk.isTaken());
            QVERIFY(!desk.acquire().isHeld());
            QVERIFY(desk.isTaken());
        }
        QVERIFY(!desk.isTaken());
        Lease first = desk.acquire();
        Lease moved = std::move(first);
        QVERIFY(!first.isHeld()); // NOLINT(bugprone-use-after-move): that is what is asked
        QVERIFY(desk.isTaken());
        moved.release();
        QVERIFY(!desk.isTaken());
        QCOMPARE(changes, 4);
    }

    void aLeaseMayOutliveItsDesk()
    {
        Lease lease;
        {
            LeaseDesk desk;
            lease = desk.acquire();
        }
        lease.release();
        QVERIFY(!lease.isHeld());
    }
};

QTEST_GUILESS_MAIN(SessionPartsTest)
#include "tst_session_parts.moc"
