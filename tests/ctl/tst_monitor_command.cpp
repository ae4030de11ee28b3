// A line for every measurement, until the time is up or the sensor is gone.

#include "ctl_fixture.h"

#include <QTemporaryDir>

using namespace lds;
using namespace lds::ctl;

namespace {

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

} // namespace

class TestMonitorCommand : public QObject {
    Q_OBJECT

private Q_SLOTS:
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

QTEST_GUILESS_MAIN(TestMonitorCommand)
#include "tst_monitor_command.moc"
