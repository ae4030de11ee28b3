// The built ldsctl against the built lds-emulator over TCP, as a script would use them.

#include "emulator_process.h"

#include <csignal>
#include <memory>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;
using lds::test::EmulatorProcess;

namespace {

constexpr int patienceMs = 30'000; ///< Only how long a hanging program is waited for.

QString program() { return QString::fromLocal8Bit(qgetenv("LDS_BIN")) + u"/ldsctl"_s; }

struct Result {
    int exitCode = -1;
    QString output;
    QString errors;
    QJsonObject json() const { return QJsonDocument::fromJson(output.toUtf8()).object(); }
    QStringList lines() const { return output.split(u'\n', Qt::SkipEmptyParts); }
};

Result finish(QProcess& process)
{
    Result result;
    if (process.state() != QProcess::NotRunning && !process.waitForFinished(patienceMs)) {
        process.kill();
        process.waitForFinished();
        result.errors = u"ldsctl does not end"_s;
        return result;
    }
    if (process.exitStatus() == QProcess::NormalExit)
        result.exitCode = process.exitCode();
    result.output = QString::fromUtf8(process.readAllStandardOutput());
    result.errors = QString::fromUtf8(process.readAllStandardError());
    return result;
}

Result run(const QStringList& arguments)
{
    QProcess process;
    process.start(program(), arguments);
    return finish(process);
}

#define VERIFY_EXIT(result, code)                                                                            \
    QVERIFY2((result).exitCode == (code), qPrintable((result).output + (result).errors))

} // namespace

class TestLdsctlProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        startEmulator();
    }

    void cleanup() { m_emulator.reset(); }

    void infoSaysWhichSensorAnswers()
    {
        const Result result = sensor({u"info"_s, u"--json"_s});
        VERIFY_EXIT(result, 0);
        QCOMPARE(result.json().value(u"sensor"_s), u"HL-G203B-S-MK"_s);
        QCOMPARE(result.json().value(u"lowWordFirst"_s), true);
        QCOMPARE(result.json().value(u"bankSwitching"_s).toObject().value(u"value"_s), 1);
    }

    void readGivesEveryReadableItem()
    {
        const Result result = sensor({u"read"_s, u"--json"_s});
        VERIFY_EXIT(result, 0);
        QCOMPARE(result.json().size(), 55);
        QCOMPARE(result.json().value(u"lowSetValue"_s).toObject(),
                 QJsonObject({{u"value"_s, -50'000}, {u"text"_s, u"-5.0000"_s}, {u"unit"_s, u"mm"_s}}));
    }

    void whatIsSetIsReadBackByTheNextProgram()
    {
        const Result set =
            sensor({u"set"_s, u"highSetValue=1.75"_s, u"lowSetValue=-0.5"_s, u"averageTimes=64 times"_s});
        VERIFY_EXIT(set, 0);
        QVERIFY2(set.errors.contains(u"Not saved"), qPrintable(set.errors));
        const Result read =
            sensor({u"read"_s, u"highSetValue"_s, u"lowSetValue"_s, u"averageTimes"_s, u"--json"_s});
        QCOMPARE(wireValue(read, u"highSetValue"_s), 17'500);
        QCOMPARE(wireValue(read, u"lowSetValue"_s), -5'000);
        QCOMPARE(wireValue(read, u"averageTimes"_s), 3);
    }

    void onlyWhatIsSavedOutlastsARestart() // §5.1
    {
        VERIFY_EXIT(sensor({u"set"_s, u"span=1.5"_s, u"--save"_s}), 0);
        VERIFY_EXIT(sensor({u"set"_s, u"offset=2"_s}), 0);
        m_emulator.reset();
        startEmulator();
        const Result read = sensor({u"read"_s, u"span"_s, u"offset"_s, u"--json"_s});
        QCOMPARE(wireValue(read, u"span"_s), 15'000);
        QCOMPARE(wireValue(read, u"offset"_s), 0);
    }

    void switchesAndCommandsRunInTheOrderGiven()
    {
        const Result set =
            sensor({u"set"_s, u"bankSwitching=2"_s, u"span=2"_s, u"laserStop=on"_s, u"--json"_s});
        VERIFY_EXIT(set, 0);
        const Result second = sensor({u"read"_s, u"bankSwitching"_s, u"span"_s, u"laserStop"_s, u"--json"_s});
        QCOMPARE(wireValue(second, u"bankSwitching"_s), 2);
        QCOMPARE(wireValue(second, u"span"_s), 20'000);
        QCOMPARE(wireValue(second, u"laserStop"_s), 1);
        VERIFY_EXIT(sensor({u"set"_s, u"bankSwitching=1"_s}), 0);
        QCOMPARE(wireValue(sensor({u"read"_s, u"span"_s, u"--json"_s}), u"span"_s), 10'000);
    }

    void aWindowThatBreaksARuleIsRefusedWhole() // §4.4.1
    {
        const Result set = sensor({u"set"_s, u"span=2"_s, u"highSetValue=-6"_s});
        VERIFY_EXIT(set, 1);
        QVERIFY2(set.errors.contains(u"must be greater than LOW"), qPrintable(set.errors));
        QCOMPARE(wireValue(sensor({u"read"_s, u"span"_s, u"--json"_s}), u"span"_s), 10'000);
    }

    void whatTheSensorRefusesIsNamed() // §4.9: there is no teaching to take a point for
    {
        const Result set = sensor({u"set"_s, u"teaching1stPoint=0"_s, u"--json"_s});
        VERIFY_EXIT(set, 1);
        QCOMPARE(set.json().value(u"results"_s).toArray().first().toObject().value(u"status"_s),
                 u"refused"_s);
        QVERIFY2(set.errors.contains(u"teaching1stPoint"), qPrintable(set.errors));
    }

    void wrongUsageEndsWith2AndChangesNothing()
    {
        VERIFY_EXIT(sensor({u"set"_s, u"span=2"_s, u"higSetValue=1"_s}), 2);
        VERIFY_EXIT(sensor({u"set"_s, u"span=2"_s, u"offset=10"_s}), 2); // out of range for this type only
        VERIFY_EXIT(sensor({u"read"_s, u"nonsense"_s}), 2);
        VERIFY_EXIT(run({u"read"_s}), 2);
        VERIFY_EXIT(run({u"catalog"_s, u"--family"_s, u"osm40"_s, u"--json"_s}), 2);
        QCOMPARE(wireValue(sensor({u"read"_s, u"span"_s, u"--json"_s}), u"span"_s), 10'000);
    }

    void catalogNeedsNoSensor()
    {
        const Result result = run({u"catalog"_s, u"--json"_s});
        VERIFY_EXIT(result, 0);
        QCOMPARE(QJsonDocument::fromJson(result.output.toUtf8()).array().size(), 70);
        VERIFY_EXIT(run({u"--help"_s}), 0);
        VERIFY_EXIT(run({u"--version"_s}), 0);
    }

    void aClosedPortEndsWith1()
    {
        QTcpServer closed;
        QVERIFY(closed.listen(QHostAddress::LocalHost));
        const quint16 port = closed.serverPort();
        closed.close();
        const Result result = run({u"-c"_s, urlOf(port), u"info"_s});
        VERIFY_EXIT(result, 1);
        QVERIFY2(result.errors.contains(u"nothing listens on port"), qPrintable(result.errors));
    }

    void aHostThatNeverAnswersEndsWith1()
    {
        QTcpServer silent;
        QVERIFY(silent.listen(QHostAddress::LocalHost));
        const Result result = run({u"-c"_s, urlOf(silent.serverPort()), u"read"_s});
        VERIFY_EXIT(result, 1);
        QVERIFY2(result.errors.contains(u"does not answer"), qPrintable(result.errors));
    }

    void monitorPrintsLinesAndWritesCsv()
    {
        const QString file = m_folder->filePath(u"values.csv"_s);
        const Result result = sensor({u"monitor"_s, u"--seconds"_s, u"2"_s, u"--json"_s, u"--csv"_s, file});
        VERIFY_EXIT(result, 0);
        const QStringList lines = result.lines();
        const QJsonObject summary =
            QJsonDocument::fromJson(lines.last().toUtf8()).object().value(u"summary"_s).toObject();
        QVERIFY2(lines.size() > 1, qPrintable(result.output));
        QCOMPARE(lines.size() - 1, summary.value(u"answered"_s).toInt());
        QVERIFY(summary.value(u"lost"_s).isDouble()); // how many depends on how busy the machine is
        const QJsonObject first = QJsonDocument::fromJson(lines.first().toUtf8()).object();
        QVERIFY(first.value(u"kind"_s).isString());
        QVERIFY(first.value(u"state"_s).toArray().contains(u"laser"_s));
        QFile csv(file);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), lines.size()); // one header, one summary
    }

    void monitorEndsAtCtrlC()
    {
        QProcess process;
        process.start(program(), {u"-c"_s, m_url, u"monitor"_s});
        QVERIFY(process.waitForReadyRead(patienceMs));
        QVERIFY(::kill(pid_t(process.processId()), SIGINT) == 0);
        const Result result = finish(process);
        VERIFY_EXIT(result, 0);
        QVERIFY2(result.errors.contains(u" answered, "), qPrintable(result.errors));
    }

    void monitorEndsWith1WhenTheSensorGoesAway()
    {
        QProcess process;
        process.start(program(), {u"-c"_s, m_url, u"monitor"_s});
        QVERIFY(process.waitForReadyRead(patienceMs));
        m_emulator.reset();
        const Result result = finish(process);
        VERIFY_EXIT(result, 1);
        QVERIFY2(result.errors.contains(u"was cut"), qPrintable(result.errors));
    }

private:
    void startEmulator()
    {
        m_emulator = std::make_unique<EmulatorProcess>(QStringList{u"--sensor"_s, u"HL-G203B-S-MK"_s,
                                                                   u"--modbus-port"_s, u"0"_s, u"--state"_s,
                                                                   m_folder->filePath(u"state.json"_s)});
        QVERIFY2(m_emulator->modbusPort() > 0, m_emulator->errors());
        m_url = urlOf(m_emulator->modbusPort());
    }

    static QString urlOf(quint16 port) { return u"modbus-tcp://127.0.0.1:%1"_s.arg(port); }
    Result sensor(const QStringList& arguments) const { return run(QStringList{u"-c"_s, m_url} + arguments); }
    static int wireValue(const Result& result, const QString& key)
    {
        return result.json().value(key).toObject().value(u"value"_s).toInt(-999'999);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<EmulatorProcess> m_emulator;
    QString m_url;
};

QTEST_GUILESS_MAIN(TestLdsctlProgram)
#include "tst_ldsctl_program.moc"
