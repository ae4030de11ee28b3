#include "rtu_emulator.h"

using namespace Qt::StringLiterals;
using namespace lds::test;

/// The checks stand in pymodbus_rtu_client.py. Debian's own Python has Debian's pymodbus and pyserial.
class PymodbusRtuClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsAndWritesTwoUnits_data();
    void readsAndWritesTwoUnits();
};

namespace {

const QString python = u"/usr/bin/python3"_s;

struct Ran {
    int exitCode = -1;
    QByteArray output;
};

Ran run(const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(python, arguments);
    const bool finished = process.waitForFinished(90'000);
    return {finished ? process.exitCode() : -1, process.readAll()};
}

} // namespace

void PymodbusRtuClientTest::initTestCase()
{
    const Ran probe = run({u"-c"_s, u"import pymodbus, serial, serial_asyncio"_s});
    QVERIFY2(probe.exitCode == 0,
             "python3-pymodbus or python3-serial is not installed; scripts/setup does it");
}

void PymodbusRtuClientTest::readsAndWritesTwoUnits_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<int>("speedCode");
    QTest::addColumn<QString>("parity");
    QTest::addColumn<int>("parityCode");
    QTest::newRow("9600 none") << 9600 << 0 << u"N"_s << 0;
    QTest::newRow("38400 even") << 38400 << 2 << u"E"_s << 1;
    QTest::newRow("115200 odd") << 115200 << 3 << u"O"_s << 2;
}

void PymodbusRtuClientTest::readsAndWritesTwoUnits()
{
    QFETCH(int, speed);
    QFETCH(int, speedCode);
    QFETCH(QString, parity);
    QFETCH(int, parityCode);
    TwoUnits units(11, 12);
    QVERIFY2(!units.line().isEmpty(), units.errors());
    // Both take the settings over by a broadcast at the factory's.
    const QString change = u"import time\n"
                           "from pymodbus.client import ModbusSerialClient\n"
                           "c = ModbusSerialClient('%1', baudrate=38400, parity='E', stopbits=1, timeout=3,\n"
                           "                       strict=False, broadcast_enable=True)\n"
                           "c.connect()\n"
                           "for address, value in (166, %2), (167, %3), (170, 0):\n"
                           "    c.write_register(address, value, slave=0)\n"
                           "    time.sleep(0.1)\n" // the pause after a broadcast
                           "c.close()\n"_s.arg(units.link())
                               .arg(speedCode)
                               .arg(parityCode);
    const Ran changed = run({u"-B"_s, u"-c"_s, change});
    QVERIFY2(changed.exitCode == 0, changed.output);

    const QString script = qEnvironmentVariable("LDS_SOURCE") + u"/tests/interop/pymodbus_rtu_client.py"_s;
    QVERIFY2(QFile::exists(script), qPrintable(script + u" is missing (LDS_SOURCE)"_s));
    const Ran checks = run({u"-B"_s, script, units.link(), QString::number(speed), parity});
    QVERIFY2(checks.exitCode == 0, checks.output);
    QVERIFY2(checks.output.endsWith("done\n"), checks.output);
}

QTEST_GUILESS_MAIN(PymodbusRtuClientTest)
#include "tst_pymodbus_rtu_client.moc"
