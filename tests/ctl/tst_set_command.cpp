// What set writes, in which order, and what it says when something goes wrong.

#include "ctl_fixture.h"

using namespace lds;
using namespace lds::ctl;

namespace {

/// The lines of a table without its padding.
QStringList words(const QString& table)
{
    QStringList lines = table.split(u'\n', Qt::SkipEmptyParts);
    for (QString& line : lines)
        line = line.simplified();
    return lines;
}

} // namespace

class TestSetCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void setWritesReadsBackAndTellsBeforeAndAfter()
    {
        Ctl ctl({u"set"_s, u"highSetValue=1.75"_s, u"span=1"_s, u"laserStop=on"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.sensor().value(ItemId::HighSetValue), 17'500);
        QCOMPARE(ctl.sensor().value(ItemId::LaserStop), 1);
        QCOMPARE(ctl.sensor().writesOf(ItemId::Span), 0);
        QCOMPARE(ctl.sensor().writesOf(ItemId::SetValueSaving), 0);
        QCOMPARE(words(ctl.out()),
                 QStringList({u"highSetValue +5.0000 -> +1.7500 mm done"_s, u"span 1.0000 × was so already"_s,
                              u"laserStop OFF (Laser emitted) -> ON (Emission stopped) done"_s}));
        QVERIFY2(ctl.err().contains(u"Not saved"), qPrintable(ctl.err()));
    }

    void settingsThatStandTogetherArePlannedTogether() // §4.4.1: the window moves past its own edge
    {
        Ctl ctl({u"set"_s, u"lowSetValue=6"_s, u"highSetValue=8"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.sensor().value(ItemId::LowSetValue), 60'000);
        QCOMPARE(ctl.sensor().value(ItemId::HighSetValue), 80'000);
    }

    void theOrderGivenIsKeptAroundASwitch()
    {
        Ctl ctl({u"set"_s, u"bankSwitching=2"_s, u"span=2"_s, u"--json"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.sensor().value(ItemId::BankSwitching), 2);
        QCOMPARE(ctl.sensor().value(ItemId::Span), 20'000);
        ctl.sensor().switchBank(1);
        QCOMPARE(ctl.sensor().value(ItemId::Span), 10'000);
    }

    void saveComesAfterSuccessOnly()
    {
        Ctl good({u"set"_s, u"span=2"_s, u"--save"_s, u"--json"_s});
        good.start();
        VERIFY_ENDED(good, 0);
        QCOMPARE(good.sensor().writesOf(ItemId::SetValueSaving), 1);
        QCOMPARE(good.statuses(), QStringList({u"span done"_s, u"setValueSaving done"_s}));
        QCOMPARE(good.json().value(u"saved"_s), u"saved"_s);

        Ctl bad({u"set"_s, u"span=2"_s, u"--save"_s, u"--json"_s});
        bad.sensor().refuse(ItemId::Span);
        bad.start();
        VERIFY_ENDED(bad, 1);
        QCOMPARE(bad.sensor().writesOf(ItemId::SetValueSaving), 0);
        QCOMPARE(bad.statuses(), QStringList({u"span refused"_s}));
    }

    void nothingIsWrittenWhenOneValueIsWrong()
    {
        Ctl ctl({u"set"_s, u"span=2"_s, u"highSetValue=9.6"_s}, {});
        ctl.start(); // the stated type is missing: only after reading it is clear that 9.6 is too much
        VERIFY_ENDED(ctl, 2);
        QCOMPARE(ctl.sensor().openings(), 1);
        QCOMPARE(ctl.sensor().writes(), 0);
        QVERIFY2(ctl.err().contains(u"highSetValue=9.6") && ctl.err().contains(u"HL-G203B-S-MK"),
                 qPrintable(ctl.err()));
    }

    void whatNoTypeTakesIsRefusedBeforeConnecting()
    {
        for (const QString& argument :
             {u"span=abc"_s, u"highSetValue=951"_s, u"nonsense=1"_s, u"errorCode=0"_s}) {
            Ctl ctl({u"set"_s, u"offset=1"_s, argument}, {});
            ctl.start();
            VERIFY_ENDED(ctl, 2);
            QCOMPARE(ctl.sensor().openings(), 0);
        }
    }

    void aGoalThatBreaksARuleIsNotTried() // §4.4.1
    {
        Ctl ctl({u"set"_s, u"span=2"_s, u"highSetValue=-6"_s, u"--json"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.sensor().writes(), 0);
        QCOMPARE(ctl.statuses(), QStringList({u"span notTried"_s, u"highSetValue notTried"_s}));
        QVERIFY2(ctl.err().contains(u"must be greater than LOW"), qPrintable(ctl.err()));
    }

    void roundingIsSaidBeforeWriting() // §1.4
    {
        Ctl ctl({u"set"_s, u"highSetValue=1.2345"_s}, u"?sensor=HL-G225B-S-MK"_s);
        bool saidBefore = false;
        ctl.sensor().setOnRequest([&](const ports::Request& request) {
            if (request.kind == ports::RequestKind::Write)
                saidBefore = ctl.err().contains(u"+1.2345 down") && ctl.err().contains(u"+1.23 mm");
        });
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QVERIFY2(saidBefore, qPrintable(ctl.err()));
        QCOMPARE(ctl.sensor().value(ItemId::HighSetValue), 12'300);
    }

    void oneRefusalOfManyIsNamedAndTheOthersAreDone()
    {
        Ctl ctl({u"set"_s, u"span=2"_s, u"offset=1"_s, u"averageTimes=64 times"_s, u"--json"_s});
        ctl.sensor().refuse(ItemId::Offset);
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.statuses(), QStringList({u"span done"_s, u"offset refused"_s, u"averageTimes done"_s}));
        QVERIFY2(ctl.err().contains(u"offset: ") && ctl.err().contains(u"error 03"), qPrintable(ctl.err()));
    }

    void aLostAnswerToACommandIsUnknownAndNotRepeated()
    {
        Ctl ctl({u"set"_s, u"measuredValueResetting=0"_s, u"--json"_s});
        ctl.sensor().loseAnswer(ItemId::MeasuredValueResetting, FakeSensor::Carried::Out);
        ctl.start();
        ctl.sensor().timeOut();
        settle();
        ctl.pass(5'000);
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.sensor().writesOf(ItemId::MeasuredValueResetting), 1);
        QCOMPARE(ctl.statuses(), QStringList({u"measuredValueResetting unknown"_s}));
        QVERIFY2(ctl.err().contains(u"not known whether it was carried out"), qPrintable(ctl.err()));
    }

    void aCutWhileWritingIsUnknownAndNotRepeated()
    {
        Ctl ctl({u"set"_s, u"span=2"_s, u"--json"_s});
        ctl.sensor().setOnRequest([&](const ports::Request& request) {
            if (request.kind == ports::RequestKind::Write)
                ctl.sensor().holdAnswers(true);
        });
        ctl.start();
        QCOMPARE(ctl.finishes, 0);
        ctl.sensor().cut();
        settle();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.statuses(), QStringList({u"span unknown"_s}));
        QCOMPARE(ctl.sensor().writesOf(ItemId::Span), 1);
        QVERIFY2(ctl.err().contains(u"was cut"), qPrintable(ctl.err()));
        QCOMPARE(ctl.sensor().openings(), 1);
    }

    void viewOnlyNeverWrites()
    {
        Ctl ctl({u"set"_s, u"span=2"_s}, u"?view=only"_s);
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.sensor().openings(), 0);
        QVERIFY2(ctl.err().contains(u"view=only"), qPrintable(ctl.err()));
    }

    void whatTheSensorChangesByItselfIsSaid() // §4.3.4
    {
        Ctl ctl({u"set"_s, u"holdMode=Peak Hold"_s});
        ctl.sensor().set(ItemId::TriggerMode, 1);
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.sensor().value(ItemId::TriggerMode), 0);
        QVERIFY2(ctl.err().contains(u"triggerMode"), qPrintable(ctl.err()));
    }

    void anAddressIsWrittenWholeAndWaitsForTheReset() // §5.1.1
    {
        Ctl ctl({u"set"_s, u"ipAddress=192.168.1.77"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.sensor().value(ItemId::IpAddress4thOctet), 77);
        QVERIFY(ctl.out().startsWith(u"ipAddress  192.168.1.6 -> 192.168.1.77"));
        QVERIFY2(ctl.err().contains(u"resettingCommunicationSettings=0"), qPrintable(ctl.err()));
    }
};

QTEST_GUILESS_MAIN(TestSetCommand)
#include "tst_set_command.moc"
