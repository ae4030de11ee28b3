// read, info, set and monitor against a sensor in memory that refuses, stays silent and goes away.

#include "console.h"
#include "fake_link.h"
#include "info_command.h"
#include "manual_scheduler.h"
#include "monitor_command.h"
#include "read_command.h"
#include "set_command.h"

#include <QBuffer>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

using namespace lds;
using namespace lds::ctl;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using support::FakeSensor;
using support::settle;

namespace {

/// One ldsctl with a sensor in memory and a clock that only the test moves.
class Ctl {
public:
    explicit Ctl(const QStringList& arguments, const QString& parameters = u"?sensor=HL-G203B-S-MK"_s)
    {
        ports::registerMetaTypes();
        output.open(QIODevice::WriteOnly);
        errors.open(QIODevice::WriteOnly);
        const auto parsed = parseCommandLine(
            QStringList{u"ldsctl"_s, u"-c"_s, u"modbus-tcp://127.0.0.1:502"_s + parameters} + arguments);
        if (!parsed)
            qFatal("%s", qPrintable(parsed.error().message));
        const auto line = std::get<CommandLine>(*parsed);
        url = *line.url;
        session = std::make_unique<sensor::SensorSession>(url, links, scheduler);
        command = make(line);
        QObject::connect(command.get(), &SessionCommand::finished, command.get(), [this](ExitCode code) {
            ++finishes;
            exitCode = int(code);
        });
    }
    ~Ctl()
    {
        command.reset();
        session.reset();
        settle();
    }

    FakeSensor& sensor() { return links.sensor(url); }
    Ctl& start()
    {
        command->start();
        settle();
        return *this;
    }
    void pass(int ms)
    {
        for (int gone = 0; gone < ms; gone += 10) {
            scheduler.advanceMs(10);
            settle();
        }
    }
    QString out() const { return QString::fromUtf8(output.data()); }
    QString err() const { return QString::fromUtf8(errors.data()); }
    QJsonObject json() const { return QJsonDocument::fromJson(output.data()).object(); }
    QStringList statuses() const
    {
        QStringList words;
        const QJsonArray results = json().value(u"results"_s).toArray();
        for (const auto& result : results)
            words += result.toObject().value(u"key"_s).toString() + u' ' +
                     result.toObject().value(u"status"_s).toString();
        return words;
    }

    ports::ManualScheduler scheduler;
    support::FakeLinkFactory links{scheduler};
    ports::ConnectionUrl url;
    QBuffer output;
    QBuffer errors;
    Console console{output, errors};
    std::unique_ptr<sensor::SensorSession> session;
    std::unique_ptr<SessionCommand> command;
    int finishes = 0;
    int exitCode = -1;

private:
    std::unique_ptr<SessionCommand> make(const CommandLine& line)
    {
        switch (line.verb) {
        case Verb::Info:
            return std::make_unique<InfoCommand>(line, *session, scheduler, console);
        case Verb::Read:
            return std::make_unique<ReadCommand>(line, *session, scheduler, console);
        case Verb::Set:
            return std::make_unique<SetCommand>(line, *session, scheduler, console);
        default:
            return std::make_unique<MonitorCommand>(line, *session, scheduler, console);
        }
    }
};

/// The lines of a table without its padding.
QStringList words(const QString& table)
{
    QStringList lines = table.split(u'\n', Qt::SkipEmptyParts);
    for (QString& line : lines)
        line = line.simplified();
    return lines;
}

measurement::Measurement sampleOf(catalog::Value value, quint16 state = measurement::GoBit)
{
    measurement::Measurement sample;
    sample.monotonicNs = 2'000'000'000;
    sample.wallMs = 1'700'000'001'000;
    sample.value = value;
    sample.kind = measurement::kindOf(value);
    sample.state = state;
    sample.intensity = 500;
    return sample;
}

#define VERIFY_ENDED(ctl, code)                                                                              \
    QCOMPARE((ctl).finishes, 1);                                                                             \
    QVERIFY2((ctl).exitCode == (code), qPrintable((ctl).err()))

} // namespace

class TestSessionCommandsOfCtl : public QObject {
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

    // --- Set

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

    // --- Monitor

    void monitorPrintsEachMeasurementOnce()
    {
        Ctl ctl({u"monitor"_s, u"--seconds"_s, u"1"_s});
        ctl.start();
        ctl.sensor().emitBatch({sampleOf(12'345), sampleOf(-9'999'999, measurement::IndeterminateBit)});
        settle();
        ctl.sensor().emitMeasurement(sampleOf(-1));
        settle();
        QCOMPARE(ctl.finishes, 0);
        ctl.pass(1'010);
        VERIFY_ENDED(ctl, 0);
        const QStringList lines = ctl.out().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 3);
        QVERIFY2(lines[0].contains(u"+1.2345 mm") && lines[0].endsWith(u"judgmentGo"), qPrintable(lines[0]));
        QVERIFY2(lines[1].contains(u"indeterminate"), qPrintable(lines[1]));
        QVERIFY2(lines[2].contains(u"-0.0001 mm"), qPrintable(lines[2]));
        QVERIFY2(ctl.err().contains(u"3 answered, 0 lost"), qPrintable(ctl.err()));
    }

    void monitorMarksAFrozenValue() // §4.7.2
    {
        Ctl ctl({u"monitor"_s, u"--seconds"_s, u"1"_s, u"--json"_s});
        ctl.start();
        ctl.sensor().emitMeasurement(sampleOf(500, measurement::AlarmBit));
        settle();
        ctl.pass(1'010);
        VERIFY_ENDED(ctl, 0);
        const QStringList lines = ctl.out().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        const QJsonObject sample = QJsonDocument::fromJson(lines[0].toUtf8()).object();
        QCOMPARE(sample.value(u"value"_s), 500);
        QCOMPARE(sample.value(u"kind"_s), u"frozen"_s);
        QCOMPARE(sample.value(u"state"_s).toArray(), QJsonArray({u"alarm"_s}));
        const QJsonObject end = QJsonDocument::fromJson(lines[1].toUtf8()).object();
        QCOMPARE(end.value(u"summary"_s).toObject().value(u"answered"_s), 1);
    }

    void monitorWritesCsvAsWell()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"values.csv"_s);
        Ctl ctl({u"monitor"_s, u"--seconds"_s, u"1"_s, u"--csv"_s, file});
        ctl.start();
        ctl.sensor().emitMeasurement(sampleOf(12'345, measurement::GoBit | measurement::LaserBit));
        settle();
        ctl.pass(1'010);
        VERIFY_ENDED(ctl, 0);
        QFile csv(file);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(csv.readAll()).split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QCOMPARE(lines[0], u"time,value_mm,kind,state,intensity"_s);
        QVERIFY2(lines[1].endsWith(u"Z,+1.2345,valid,judgmentGo laser,500"), qPrintable(lines[1]));
    }

    void monitorSaysWhichFileCannotBeWritten()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"missing/values.csv"_s);
        Ctl ctl({u"monitor"_s, u"--csv"_s, file});
        ctl.start();
        VERIFY_ENDED(ctl, 2);
        QVERIFY2(ctl.err().contains(file), qPrintable(ctl.err()));
        QCOMPARE(ctl.sensor().openings(), 0);
    }

    void monitorEndsWhenTheConnectionIsCut()
    {
        Ctl ctl({u"monitor"_s});
        ctl.start();
        ctl.sensor().cut();
        settle();
        VERIFY_ENDED(ctl, 1);
        QVERIFY2(ctl.err().contains(u"was cut") && ctl.err().contains(u"0 answered"), qPrintable(ctl.err()));
        ctl.pass(20'000);
        QCOMPARE(ctl.finishes, 1);
    }

    void monitorGoesOnWhileTheSensorIsInItsMenu() // §5.2.2
    {
        Ctl ctl({u"monitor"_s, u"--seconds"_s, u"1"_s});
        ctl.start();
        ctl.sensor().refusePoll(ports::FailureCode::NotReady);
        settle();
        QCOMPARE(ctl.finishes, 0);
        QVERIFY2(ctl.err().contains(u"not ready"), qPrintable(ctl.err()));
        ctl.sensor().refusePoll(ports::FailureCode::None);
        settle();
        QVERIFY2(ctl.err().contains(u"answers again"), qPrintable(ctl.err()));
        ctl.pass(1'010);
        VERIFY_ENDED(ctl, 0);
    }

    void interruptEndsTheMonitorAsTimeDoes()
    {
        Ctl ctl({u"monitor"_s});
        ctl.start();
        qobject_cast<MonitorCommand*>(ctl.command.get())->interrupt();
        VERIFY_ENDED(ctl, 0);
        QVERIFY(ctl.err().contains(u"0 answered"));
    }
};

QTEST_GUILESS_MAIN(TestSessionCommandsOfCtl)
#include "tst_session_commands_of_ctl.moc"
