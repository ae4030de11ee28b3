#include "emulator_process.h"

#include <QFile>
#include <QTest>

using namespace Qt::StringLiterals;
using lds::test::EmulatorProcess;

/// The checks stand in pymodbus_client.py. Debian's own Python has Debian's pymodbus.
class PymodbusClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsAndWritesTheEmulator();
};

namespace {
const QString python = u"/usr/bin/python3"_s;
}

void PymodbusClientTest::initTestCase()
{
    QProcess probe;
    probe.start(python, {u"-c"_s, u"import pymodbus"_s});
    QVERIFY2(probe.waitForFinished(60'000) && probe.exitCode() == 0,
             "python3-pymodbus is not installed; scripts/setup installs it");
}

void PymodbusClientTest::readsAndWritesTheEmulator()
{
    EmulatorProcess emulator({u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s});
    QVERIFY2(emulator.modbusPort() > 0, emulator.errors());
    const QString script = qEnvironmentVariable("LDS_SOURCE") + u"/tests/interop/pymodbus_client.py"_s;
    QVERIFY2(QFile::exists(script), qPrintable(script + u" is missing (LDS_SOURCE)"_s));
    QProcess client;
    client.setProcessChannelMode(QProcess::MergedChannels);
    client.start(python, {u"-B"_s, script, QString::number(emulator.modbusPort())});
    QVERIFY(client.waitForFinished(90'000));
    const QByteArray output = client.readAll();
    QVERIFY2(client.exitCode() == 0, output);
    QVERIFY2(output.endsWith("done\n"), output);
}

QTEST_GUILESS_MAIN(PymodbusClientTest)
#include "tst_pymodbus_client.moc"
