#include "emulator_process.h"

#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

using namespace Qt::StringLiterals;
using lds::test::EmulatorProcess;

/// mbpoll counts registers as the manual does after the 4: 400101 is reference 101.
class MbpollClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsRegisters();
    void reads32BitValuesLowWordFirst();
    void readsCoils();
    void writesOneAndSeveralRegisters();
    void writes32BitValues();
    void isToldEachErrorCode_data();
    void isToldEachErrorCode();

private:
    struct Result {
        int exitCode = -1;
        QString text; ///< Both outputs.
        /// The value printed for a reference.
        int value(int reference) const;
    };
    Result mbpoll(const QStringList& options, const QStringList& values = {});

    QString m_program;
    std::unique_ptr<EmulatorProcess> m_emulator;
};

void MbpollClientTest::initTestCase()
{
    m_program = QStandardPaths::findExecutable(u"mbpoll"_s);
    QVERIFY2(!m_program.isEmpty(), "mbpoll is not installed; scripts/setup installs it");
    m_emulator = std::make_unique<EmulatorProcess>(
        QStringList{u"--sensor"_s, u"HL-G205B-S-MK"_s, u"--modbus-port"_s, u"0"_s});
    QVERIFY2(m_emulator->modbusPort() > 0, m_emulator->errors());
}

MbpollClientTest::Result MbpollClientTest::mbpoll(const QStringList& options, const QStringList& values)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    const QStringList common{u"-m"_s, u"tcp"_s, u"-p"_s, QString::number(m_emulator->modbusPort()),
                             u"-1"_s, u"-o"_s,  u"5"_s};
    QStringList arguments = common + options + QStringList{u"127.0.0.1"_s};
    if (!values.isEmpty())
        arguments += QStringList{u"--"_s} + values;
    process.start(m_program, arguments);
    if (!process.waitForFinished(20'000))
        return {};
    return {process.exitCode(), QString::fromLocal8Bit(process.readAll())};
}

int MbpollClientTest::Result::value(int reference) const
{
    const QRegularExpression line(u"^\\[%1\\]:\\s+(-?\\d+)"_s.arg(reference),
                                  QRegularExpression::MultilineOption);
    const auto match = line.match(text);
    return match.hasMatch() ? match.captured(1).toInt() : INT_MIN;
}

void MbpollClientTest::readsRegisters()
{
    const Result result = mbpoll({u"-r"_s, u"108"_s, u"-c"_s, u"8"_s});
    QVERIFY2(result.exitCode == 0, qPrintable(result.text));
    const int expected[] = {0, 1, 8, 1, 0, 3, 5, 0}; // key lock … hold mode, factory defaults
    for (int i = 0; i < 8; ++i)
        QCOMPARE(result.value(108 + i), expected[i]);
}

void MbpollClientTest::reads32BitValuesLowWordFirst()
{
    const Result result = mbpoll({u"-r"_s, u"101"_s, u"-c"_s, u"3"_s, u"-t"_s, u"4:int"_s});
    QVERIFY2(result.exitCode == 0, qPrintable(result.text));
    QCOMPARE(result.value(101), 100'000);  // HIGH +10.000 mm
    QCOMPARE(result.value(103), -100'000); // LOW
    QCOMPARE(result.value(105), 200);      // hysteresis
}

void MbpollClientTest::readsCoils()
{
    const Result result = mbpoll({u"-r"_s, u"1"_s, u"-c"_s, u"14"_s, u"-t"_s, u"0"_s});
    QVERIFY2(result.exitCode == 0, qPrintable(result.text));
    for (int coil = 1; coil <= 14; ++coil)
        QCOMPARE(result.value(coil), coil == 4 || coil == 7 || coil == 11 ? 1 : 0); // GO, GO, laser
}

void MbpollClientTest::writesOneAndSeveralRegisters()
{
    const Result one = mbpoll({u"-r"_s, u"110"_s}, {u"1234"_s});
    QVERIFY2(one.exitCode == 0, qPrintable(one.text));
    const Result several = mbpoll({u"-r"_s, u"108"_s}, {u"1"_s, u"0"_s});
    QVERIFY2(several.exitCode == 0, qPrintable(several.text));
    const Result read = mbpoll({u"-r"_s, u"108"_s, u"-c"_s, u"3"_s});
    QCOMPARE(read.value(108), 1);
    QCOMPARE(read.value(109), 0);
    QCOMPARE(read.value(110), 1234);
}

void MbpollClientTest::writes32BitValues()
{
    const QStringList asInteger{u"-r"_s, u"101"_s, u"-t"_s, u"4:int"_s};
    const Result written = mbpoll(asInteger, {u"56789"_s, u"-12345"_s}); // together: HIGH and LOW
    QVERIFY2(written.exitCode == 0, qPrintable(written.text));
    const Result read = mbpoll(asInteger + QStringList{u"-c"_s, u"2"_s});
    QCOMPARE(read.value(101), 56'780); // rounded down to 1 µm
    QCOMPARE(read.value(103), -12'340);
}

void MbpollClientTest::isToldEachErrorCode_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QStringList>("values");
    QTest::addColumn<QString>("says");
    QTest::newRow("01 input registers")
        << QStringList{u"-r"_s, u"101"_s, u"-t"_s, u"3"_s} << QStringList() << u"Illegal function"_s;
    QTest::newRow("02 unmapped") << QStringList{u"-r"_s, u"900"_s} << QStringList()
                                 << u"Illegal data address"_s;
    QTest::newRow("02 prohibited") << QStringList{u"-r"_s, u"53"_s} << QStringList{u"0"_s}
                                   << u"Illegal data address"_s;
    QTest::newRow("03 out of range") << QStringList{u"-r"_s, u"109"_s} << QStringList{u"2"_s}
                                     << u"Illegal data value"_s;
    QTest::newRow("03 half a value") << QStringList{u"-r"_s, u"101"_s} << QStringList{u"2"_s}
                                     << u"Illegal data value"_s;
    QTest::newRow("04 tuning was not started")
        << QStringList{u"-r"_s, u"146"_s} << QStringList{u"0"_s} << u"Slave device or server failure"_s;
}

void MbpollClientTest::isToldEachErrorCode()
{
    QFETCH(QStringList, options);
    QFETCH(QStringList, values);
    QFETCH(QString, says);
    const Result result = mbpoll(options, values);
    QVERIFY(result.exitCode != -1);
    QVERIFY2(result.text.contains(says), qPrintable(result.text));
}

QTEST_GUILESS_MAIN(MbpollClientTest)
#include "tst_mbpoll_client.moc"
