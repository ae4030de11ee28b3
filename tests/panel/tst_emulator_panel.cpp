#include <csignal>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTest>

using namespace Qt::StringLiterals;

/// lds-emulator --panel.
class TestEmulatorPanel : public QObject {
    Q_OBJECT

private:
    static QString program() { return qEnvironmentVariable("LDS_BIN") + u"/lds-emulator"_s; }
    static QStringList sensor() { return {u"--sensor"_s, u"HL-G208B-S-MK"_s, u"--modbus-port"_s, u"0"_s}; }
    static QProcessEnvironment noDisplay()
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const QString& name : {u"DISPLAY"_s, u"WAYLAND_DISPLAY"_s, u"QT_QPA_PLATFORM"_s})
            environment.remove(name);
        return environment;
    }
    static QJsonObject readyLine(QProcess& process)
    {
        while (!process.canReadLine() && process.waitForReadyRead(20'000)) {
        }
        return QJsonDocument::fromJson(process.readLine()).object();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY2(QFile::exists(program()), qPrintable(program())); }

    void the_sensor_serves_with_its_panel_in_a_window()
    {
        QProcess process;
        process.start(program(), sensor() + QStringList{u"--panel"_s});
        QVERIFY(readyLine(process).value("ready"_L1).toBool());
        ::kill(pid_t(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
    }

    void without_a_display_it_says_so()
    {
        QProcess process;
        process.setProcessEnvironment(noDisplay());
        process.start(program(), sensor() + QStringList{u"--panel"_s});
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 1);
        const QByteArray errors = process.readAllStandardError();
        QVERIFY2(errors.contains("--panel: there is no display"), errors.constData());
    }

    void without_the_panel_no_display_is_needed()
    {
        QProcess process;
        process.setProcessEnvironment(noDisplay());
        process.start(program(), sensor());
        QVERIFY(readyLine(process).value("ready"_L1).toBool());
        ::kill(pid_t(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 0);
    }

    void help_needs_no_display_and_names_the_panel()
    {
        QProcess process;
        process.setProcessEnvironment(noDisplay());
        process.start(program(), {u"--panel"_s, u"--help"_s});
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(process.readAllStandardOutput().contains("--panel"));
    }
};

QTEST_GUILESS_MAIN(TestEmulatorPanel)
#include "tst_emulator_panel.moc"
