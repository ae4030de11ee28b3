// Opening, read and info against a sensor in memory that refuses, stays silent and goes away.

#include "ctl_fixture.h"

using namespace lds;
using namespace lds::ctl;

class TestReadCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // --- Opening

    void aConnectionThatCannotOpenIsTriedOnce_data()
    {
        QTest::addColumn<int>("failure");
        QTest::addColumn<QString>("said");
        using enum ports::OpenFailure;
        QTest::newRow("refused") << int(Refused) << u"nothing listens on port 502"_s;
        QTest::newRow("silent") << int(NoAnswer) << u"127.0.0.1:502 does not answer"_s;
        QTest::newRow("other device") << int(NotASensor) << u"not as an HL-G2 does"_s;
        QTest::newRow("in its menu") << int(NotReady) << u"is in its menu"_s;
        QTest::newRow("unknown host") << int(HostNotFound) << u"No host named"_s;
        QTest::newRow("cut") << int(Lost) << u"was cut"_s;
    }

    void aConnectionThatCannotOpenIsTriedOnce()
    {
        QFETCH(int, failure);
        QFETCH(QString, said);
        Ctl ctl({u"read"_s});
        ctl.sensor().failOpenings(ports::OpenFailure(failure), u"system says so"_s);
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.sensor().openings(), 1);
        QVERIFY2(ctl.err().contains(said) && ctl.err().contains(u"system says so"), qPrintable(ctl.err()));
        QVERIFY2(!ctl.err().contains(u"tried again by itself"), qPrintable(ctl.err()));
        QCOMPARE(ctl.out(), QString());
    }

    void aSensorThatDoesNotAnswerReadsIsGivenUp()
    {
        Ctl ctl({u"read"_s});
        ctl.sensor().holdAnswers(true);
        ctl.start();
        QCOMPARE(ctl.finishes, 0);
        ctl.pass(31'000);
        VERIFY_ENDED(ctl, 1);
        QVERIFY2(ctl.err().contains(u"does not answer"), qPrintable(ctl.err()));
    }

    void aSensorInItsMenuIsSaidAtOnce() // §5.2.2
    {
        Ctl ctl({u"read"_s});
        ctl.sensor().refuseReads(ports::FailureCode::NotReady);
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QVERIFY2(ctl.err().contains(u"is in its menu"), qPrintable(ctl.err()));
    }

    // --- Read and info

    void readPrintsValuesWithTheirUnits()
    {
        Ctl ctl({u"read"_s, u"highSetValue"_s, u"samplingFrequency"_s, u"ipAddress"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QCOMPARE(ctl.out(), u"highSetValue       +5.0000      mm\n"
                            "samplingFrequency  1 ms\n"
                            "ipAddress          192.168.1.6\n"_s);
        QCOMPARE(ctl.err(), QString());
    }

    void readWithoutKeysReadsEveryReadableItem()
    {
        Ctl ctl({u"read"_s, u"--json"_s});
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        int readable = 0;
        for (const auto& item : catalog::Catalog::hlG2().items())
            readable += item.isReadable() ? 1 : 0;
        QCOMPARE(ctl.json().size(), readable);
        QCOMPARE(ctl.json().value(u"span"_s).toObject().value(u"value"_s), 10'000);
    }

    void readRefusesWhatHasNoValueBeforeConnecting()
    {
        for (const QString& key : {u"setValueSaving"_s, u"portSlmp"_s, u"nonsense"_s}) {
            Ctl ctl({u"read"_s, u"span"_s, key});
            ctl.start();
            VERIFY_ENDED(ctl, 2);
            QCOMPARE(ctl.sensor().openings(), 0);
            QVERIFY2(ctl.err().contains(key), qPrintable(ctl.err()));
        }
    }

    void readSaysWhatTheConnectionDoesNotReach()
    {
        Ctl ctl({u"read"_s, u"span"_s, u"offset"_s});
        ctl.sensor().hide(ItemId::Offset);
        ctl.start();
        VERIFY_ENDED(ctl, 1);
        QCOMPARE(ctl.out(), u"span  1.0000  ×\n"_s);
        QVERIFY2(ctl.err().contains(u"offset"), qPrintable(ctl.err()));
    }

    void infoNamesTheTypeAndTheState()
    {
        Ctl ctl({u"info"_s, u"--json"_s}, {});
        ctl.sensor().set(ItemId::SensorState, measurement::LaserBit | measurement::HighBit);
        ctl.sensor().set(ItemId::SelfMonitoringNotification, 2);
        ctl.sensor().set(ItemId::BankSwitching, 3);
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        const QJsonObject info = ctl.json();
        QCOMPARE(info.value(u"sensor"_s), u"HL-G203B-S-MK"_s);
        QCOMPARE(info.value(u"sensorIsStated"_s), false);
        QCOMPARE(info.value(u"state"_s).toArray(), QJsonArray({u"judgmentHigh"_s, u"laser"_s}));
        QCOMPARE(info.value(u"selfMonitoring"_s).toArray(), QJsonArray({u"insufficientIntensity"_s}));
        QCOMPARE(info.value(u"bankSwitching"_s).toObject().value(u"value"_s), 3);
    }

    void infoSaysWhenTheStatedTypeCannotBe()
    {
        Ctl ctl({u"info"_s}, u"?sensor=HL-G225B-S-MK"_s);
        ctl.sensor().set(ItemId::DisplayDigit, 0);
        ctl.start();
        VERIFY_ENDED(ctl, 0);
        QVERIFY2(ctl.err().contains(u"HL-G225B-S-MK"), qPrintable(ctl.err()));
    }
};

QTEST_GUILESS_MAIN(TestReadCommand)
#include "tst_read_command.moc"
