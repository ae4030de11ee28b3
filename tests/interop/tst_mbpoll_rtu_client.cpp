#include "rtu_emulator.h"

#include <QRegularExpression>
#include <QStandardPaths>

using namespace Qt::StringLiterals;
using namespace lds::test;

/// mbpoll on a serial line, with libmodbus beneath it. It counts registers as the manual does after the 4.
class MbpollRtuClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsAndWritesAtEachSetting_data() { lineChoices(); }
    void readsAndWritesAtEachSetting();
    void isToldEachErrorCode_data();
    void isToldEachErrorCode();
    void getsNoAnswerAtOtherSettings_data();
    void getsNoAnswerAtOtherSettings();
    void reachesTwoUnitsOnOneLine();
    void reachesTheEmulatorThroughAPairOfTerminals();

private:
    struct Result {
        int exitCode = -1;
        QString text; ///< Both outputs.
        int value(int reference) const;
    };
    Result mbpoll(const QString& device, const LineChoice& line, const QStringList& options,
                  const QStringList& values = {});

    QString m_program;
    std::unique_ptr<RtuEmulator> m_emulator;
};

void MbpollRtuClientTest::initTestCase()
{
    m_program = QStandardPaths::findExecutable(u"mbpoll"_s);
    QVERIFY2(!m_program.isEmpty(), "mbpoll is not installed; scripts/setup installs it");
    m_emulator = std::make_unique<RtuEmulator>(u"HL-G205B-S-MK"_s);
    QVERIFY2(m_emulator->rtu() == m_emulator->link(), m_emulator->errors());
}

MbpollRtuClientTest::Result MbpollRtuClientTest::mbpoll(const QString& device, const LineChoice& line,
                                                        const QStringList& options, const QStringList& values)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    QStringList arguments = QStringList{u"-m"_s, u"rtu"_s,          u"-b"_s, QString::number(line.speed),
                                        u"-P"_s, line.parityWord(), u"-s"_s, QString::number(line.stopBits()),
                                        u"-1"_s} +
                            options + QStringList{device};
    if (!values.isEmpty())
        arguments += QStringList{u"--"_s} + values;
    process.start(m_program, arguments);
    if (!process.waitForFinished(30'000))
        return {};
    return {process.exitCode(), QString::fromLocal8Bit(process.readAll())};
}

int MbpollRtuClientTest::Result::value(int reference) const
{
    const QRegularExpression line(u"^\\[%1\\]:\\s+(-?\\d+)"_s.arg(reference),
                                  QRegularExpression::MultilineOption);
    const auto match = line.match(text);
    return match.hasMatch() ? match.captured(1).toInt() : INT_MIN;
}

void MbpollRtuClientTest::readsAndWritesAtEachSetting()
{
    QFETCH(int, speed);
    QFETCH(char, parity);
    const LineChoice line{speed, parity};
    QVERIFY(m_emulator->use(line));
    const auto run = [&](const QStringList& options, const QStringList& values = {}) {
        return mbpoll(m_emulator->link(), line, QStringList{u"-o"_s, u"5"_s} + options, values);
    };
    const Result defaults = run({u"-r"_s, u"111"_s, u"-c"_s, u"5"_s});
    QVERIFY2(defaults.exitCode == 0, qPrintable(defaults.text));
    const int expected[] = {1, 0, 3, 5, 0}; // display digit … hold mode, factory defaults
    for (int i = 0; i < 5; ++i)
        QCOMPARE(defaults.value(111 + i), expected[i]);
    const Result most = run({u"-r"_s, u"20"_s, u"-c"_s, u"125"_s}); // as much as fits into an answer
    QVERIFY2(most.exitCode == 0, qPrintable(most.text));
    const Result coils = run({u"-r"_s, u"1"_s, u"-c"_s, u"14"_s, u"-t"_s, u"0"_s});
    for (int coil = 1; coil <= 14; ++coil)
        QCOMPARE(coils.value(coil), coil == 4 || coil == 7 || coil == 11 ? 1 : 0);
    const QString delay = QString::number(speed / 100);
    QCOMPARE(run({u"-r"_s, u"110"_s}, {delay}).exitCode, 0);
    QCOMPARE(run({u"-r"_s, u"108"_s}, {u"0"_s, u"1"_s}).exitCode, 0);
    QCOMPARE(run({u"-r"_s, u"110"_s}).value(110), speed / 100);
    const QStringList asInteger{u"-r"_s, u"101"_s, u"-t"_s, u"4:int"_s};
    QCOMPARE(run(asInteger, {u"100000"_s, QString::number(-speed / 10 * 10)}).exitCode, 0);
    QCOMPARE(run(asInteger + QStringList{u"-c"_s, u"2"_s}).value(103), -speed / 10 * 10);
}

void MbpollRtuClientTest::isToldEachErrorCode_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QStringList>("values");
    QTest::addColumn<QString>("says");
    QTest::newRow("01 input registers")
        << QStringList{u"-r"_s, u"101"_s, u"-t"_s, u"3"_s} << QStringList() << u"Illegal function"_s;
    QTest::newRow("02 unmapped") << QStringList{u"-r"_s, u"900"_s} << QStringList()
                                 << u"Illegal data address"_s;
    QTest::newRow("03 out of range") << QStringList{u"-r"_s, u"109"_s} << QStringList{u"2"_s}
                                     << u"Illegal data value"_s;
    QTest::newRow("03 several, one out of range")
        << QStringList{u"-r"_s, u"108"_s} << QStringList{u"0"_s, u"2"_s} << u"Illegal data value"_s;
    QTest::newRow("04 tuning was not started")
        << QStringList{u"-r"_s, u"146"_s} << QStringList{u"0"_s} << u"Slave device or server failure"_s;
}

void MbpollRtuClientTest::isToldEachErrorCode()
{
    QFETCH(QStringList, options);
    QFETCH(QStringList, values);
    QFETCH(QString, says);
    QVERIFY(m_emulator->use({}));
    const Result result = mbpoll(m_emulator->link(), {}, QStringList{u"-o"_s, u"5"_s} + options, values);
    QVERIFY(result.exitCode != -1);
    QVERIFY2(result.text.contains(says), qPrintable(result.text));
}

void MbpollRtuClientTest::getsNoAnswerAtOtherSettings_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<char>("parity");
    QTest::addColumn<int>("unit");
    QTest::newRow("slower") << 19200 << 'E' << 1;
    QTest::newRow("faster") << 115200 << 'E' << 1;
    QTest::newRow("odd") << 38400 << 'O' << 1;
    QTest::newRow("none") << 38400 << 'N' << 1;
    QTest::newRow("another unit") << 38400 << 'E' << 2;
}

void MbpollRtuClientTest::getsNoAnswerAtOtherSettings()
{
    QFETCH(int, speed);
    QFETCH(char, parity);
    QFETCH(int, unit);
    QVERIFY(m_emulator->use({}));
    const QStringList options{u"-a"_s, QString::number(unit), u"-o"_s, u"0.3"_s, u"-r"_s, u"116"_s};
    const Result result = mbpoll(m_emulator->link(), {speed, parity}, options);
    QVERIFY2(result.text.contains(u"timed out"_s), qPrintable(result.text));
    const Result right = mbpoll(m_emulator->link(), {}, {u"-r"_s, u"116"_s, u"-o"_s, u"5"_s});
    QCOMPARE(right.value(116), 10'000); // and the line is none the worse
}

void MbpollRtuClientTest::reachesTwoUnitsOnOneLine()
{
    TwoUnits units(17, 247);
    QVERIFY2(!units.line().isEmpty(), units.errors());
    const QStringList high{u"-r"_s, u"101"_s, u"-t"_s, u"4:int"_s, u"-o"_s, u"5"_s};
    QCOMPARE(mbpoll(units.link(), {}, high + QStringList{u"-a"_s, u"17"_s}).value(101), 50'000);
    QCOMPARE(mbpoll(units.link(), {}, high + QStringList{u"-a"_s, u"247"_s}).value(101), 100'000);
}

/// socat joins the emulator's terminal to another one, as a cable would; its settings count on the line.
void MbpollRtuClientTest::reachesTheEmulatorThroughAPairOfTerminals()
{
    QVERIFY(m_emulator->use({}));
    QTemporaryDir folder;
    const QString device = folder.filePath(u"cable"_s);
    QProcess socat;
    socat.start(u"socat"_s, {u"pty,raw,echo=0,link="_s + device,
                             m_emulator->link() + u",raw,echo=0,b38400,cstopb=0,parenb=1,parodd=0"_s});
    QVERIFY2(socat.waitForStarted(20'000), "socat is not installed; scripts/setup installs it");
    QTRY_VERIFY(QFile::exists(device));
    const Result result = mbpoll(device, {}, {u"-r"_s, u"116"_s, u"-o"_s, u"5"_s});
    QVERIFY2(result.value(116) == 10'000, qPrintable(result.text));
    socat.terminate();
    socat.waitForFinished();
}

QTEST_GUILESS_MAIN(MbpollRtuClientTest)
#include "tst_mbpoll_rtu_client.moc"
