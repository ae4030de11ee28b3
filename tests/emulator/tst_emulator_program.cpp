#include "emulator_process.h"

#include <QFile>
#include <QFileInfo>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalSocket>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include <signal.h>

using namespace Qt::StringLiterals;

namespace {

using Emulator = lds::test::EmulatorProcess;

QString program() { return Emulator::program(); }

QByteArray ask(quint16 port, const QByteArray& request)
{
    QTcpSocket client;
    client.connectToHost(QHostAddress::LocalHost, port);
    client.waitForConnected();
    client.write(QByteArray::fromHex(request));
    client.waitForReadyRead();
    return client.readAll();
}

quint16 port(const QJsonObject& ready, QLatin1StringView key) { return Emulator::port(ready, key); }

void writeFile(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QJsonObject answerTo(Emulator& emulator, const QByteArray& controlLine)
{
    return QJsonDocument::fromJson(emulator.control(controlLine)).object();
}

constexpr auto readHigh = "0001 0000 0006 01 03 0064 0002";

} // namespace

class EmulatorProgramTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void saysWhereItListensAndEndsOnASignal_data();
    void saysWhereItListensAndEndsOnASignal();
    void startsOnlyTheServersAskedFor();
    void wrongUsageIsToldAndExitsWith2_data();
    void wrongUsageIsToldAndExitsWith2();
    void aTakenPortExitsWith1();
    void helpAndVersionExitWith0();
    void aLineIsALinkThatGoesWithTheProgram();
    void aFileInTheWayOfALineStays();
    void sensorsWithTheSameLinkShareALine();
    void theUnitIsSavedOnlyWhenItIsSaved();
    void aConfigurationFileStartsSeveralSensors();
    void wrongConfigurationFilesNameTheField_data();
    void wrongConfigurationFilesNameTheField();
    void savedSettingsSurviveTheProgram();
    void aWrongStateFileIsNeverOverwritten();
    void aHalfWrittenStateFileIsNeverOverwritten();
    void aWrongSceneExitsWith2_data();
    void aWrongSceneExitsWith2();
    void nothingListensBeforeAllFilesAreRead();
    void listsTheExampleScenes();
    void everyExampleSceneStarts();
    void controlLinesAreAnsweredOneByOne();
    void theEndOfStandardInputEndsNothing();
    void aLocalSocketTakesControlLinesToo();
    void aTakenControlSocketExitsWith1();
    void sixteenSensorsInOneProgram();
    void aServerThatMovesSaysSo();
};

void EmulatorProgramTest::initTestCase()
{
    QVERIFY2(QFile::exists(program()), qPrintable(program() + u" is not built (LDS_BIN)"_s));
}

void EmulatorProgramTest::saysWhereItListensAndEndsOnASignal_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
}

void EmulatorProgramTest::saysWhereItListensAndEndsOnASignal()
{
    QFETCH(int, signal);
    Emulator emulator(
        {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--tool-port"_s, u"0"_s});
    const QJsonObject ready = emulator.ready();
    QVERIFY2(emulator.line().endsWith('\n'), emulator.line());
    QStringList keys = ready.keys();
    QCOMPARE(keys.join(u' '), u"eipPort modbusPort ready rtu sensor slmpPort toolPort"_s);
    QCOMPARE(ready.value("ready"_L1), QJsonValue(true));
    QCOMPARE(ready.value("sensor"_L1).toString(), u"HL-G203B-S-MK"_s);
    for (const auto key : {"slmpPort"_L1, "eipPort"_L1, "rtu"_L1})
        QVERIFY(ready.value(key).isNull());
    const QByteArray answer = QByteArray::fromHex("0001 0000 0007 01 03 04 c350 0000");
    QCOMPARE(ask(port(ready, "modbusPort"_L1), readHigh), answer);
    QCOMPARE(ask(port(ready, "toolPort"_L1), readHigh), answer);
    QCOMPARE(emulator.endWith(signal), 0);
}

void EmulatorProgramTest::startsOnlyTheServersAskedFor()
{
    const Emulator emulator({u"--sensor"_s, u"hl-g212b-s-mk"_s, u"--tool-port"_s, u"0"_s});
    const QJsonObject ready = emulator.ready();
    QVERIFY(ready.value("modbusPort"_L1).isNull());
    QVERIFY(port(ready, "toolPort"_L1) > 0);
    QCOMPARE(ready.value("sensor"_L1).toString(), u"HL-G212B-S-MK"_s);
}

void EmulatorProgramTest::wrongUsageIsToldAndExitsWith2_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("says");
    QTest::newRow("nothing") << QString() << u"--sensor"_s;
    for (const char* model : {"203", "205", "208", "212", "225"}) {
        QTest::newRow(model) << u"--sensor HL-G2 --modbus-port 0"_s
                             << u"HL-G%1B-S-MK"_s.arg(QString::fromLatin1(model));
    }
    const QString sensor = u"--sensor HL-G203B-S-MK "_s;
    for (const char* option : {"slmp-port", "eip-port", "eip-io-port"}) {
        const QString name = u"--"_s + QString::fromLatin1(option);
        QTest::newRow(option) << sensor + u"--modbus-port 0 %1 1"_s.arg(name)
                              << name + u" is not in this version"_s;
    }
    QTest::newRow("unit without a line") << sensor + u"--modbus-port 0 --unit 1"_s << u"--rtu LINK"_s;
    for (const char* unit : {"0", "248", "x", "1.5"}) {
        QTest::addRow("unit %s", unit)
            << sensor + u"--rtu /nowhere/line --unit "_s + QString::fromLatin1(unit)
            << u"--unit %1: a device address"_s.arg(QString::fromLatin1(unit));
    }
    QTest::newRow("line beside a file") << u"--config x.json --rtu line"_s << u"--rtu"_s;
    QTest::newRow("no server") << sensor << u"nothing to serve"_s;
    QTest::newRow("port no number") << sensor + u"--modbus-port abc"_s << u"--modbus-port abc"_s;
    QTest::newRow("port too large") << sensor + u"--tool-port 65536"_s << u"--tool-port 65536"_s;
    QTest::newRow("port negative") << sensor + u"--tool-port=-1"_s << u"--tool-port -1"_s;
    QTest::newRow("bind a name") << sensor + u"--modbus-port 0 --bind localhost"_s << u"--bind"_s;
    QTest::newRow("unknown option") << sensor + u"--frobnicate"_s << u"frobnicate"_s;
    QTest::newRow("left over") << sensor + u"--modbus-port 0 extra"_s << u"extra"_s;
    QTest::newRow("both") << sensor + u"--config x.json"_s << u"--config"_s;
    QTest::newRow("port beside a file") << u"--config x.json --modbus-port 0"_s << u"--modbus-port"_s;
    QTest::newRow("no such file") << u"--config /nowhere/at/all.json"_s << u"/nowhere/at/all.json"_s;
}

void EmulatorProgramTest::wrongUsageIsToldAndExitsWith2()
{
    QFETCH(QString, arguments);
    QFETCH(QString, says);
    QProcess process;
    process.start(program(), arguments.split(u' ', Qt::SkipEmptyParts));
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 2);
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(says), qPrintable(message));
}

void EmulatorProgramTest::aTakenPortExitsWith1()
{
    QTcpServer taken;
    QVERIFY(taken.listen(QHostAddress::LocalHost));
    QProcess process;
    process.start(program(), {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s,
                              QString::number(taken.serverPort())});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 1);
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(QString::number(taken.serverPort())), qPrintable(message));
}

void EmulatorProgramTest::helpAndVersionExitWith0()
{
    for (const QString& option : {u"--help"_s, u"--version"_s}) {
        QProcess process;
        process.start(program(), {option});
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(process.readAllStandardOutput().size() > 10);
    }
}

void EmulatorProgramTest::aLineIsALinkThatGoesWithTheProgram()
{
    const QTemporaryDir folder;
    const QString link = folder.filePath(u"line"_s);
    Emulator emulator({u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--rtu"_s, link, u"--unit"_s, u"247"_s});
    QVERIFY2(emulator.ready().value("rtu"_L1).toString() == link, emulator.line() + emulator.errors());
    QVERIFY(emulator.ready().value("modbusPort"_L1).isNull());
    QVERIFY(QFileInfo(link).isSymLink() && QFileInfo(link).exists());
    QCOMPARE(emulator.endWith(SIGTERM), 0);
    QVERIFY(!QFileInfo(link).isSymLink());
}

void EmulatorProgramTest::aFileInTheWayOfALineStays()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"line"_s);
    writeFile(path, "precious");
    QProcess process;
    process.start(program(), {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--rtu"_s, path});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(path) && message.contains(u"no link of an emulator"_s), qPrintable(message));
    QCOMPARE(QFileInfo(path).size(), 8);
}

void EmulatorProgramTest::sensorsWithTheSameLinkShareALine()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"bus.json"_s);
    writeFile(path, R"({"sensors": [{"sensor": "HL-G203B-S-MK", "rtu": "line", "unit": 1, "modbusPort": 0},
                                    {"sensor": "HL-G205B-S-MK", "rtu": "./line", "unit": 2},
                                    {"sensor": "HL-G205B-S-MK", "rtu": "other", "answeringTimeMs": 5}]})");
    Emulator emulator({u"--config"_s, path});
    const QJsonArray sensors = emulator.ready().value("sensors"_L1).toArray();
    QVERIFY2(sensors.size() == 3, emulator.errors());
    QCOMPARE(sensors.at(0).toObject().value("rtu"_L1).toString(), folder.filePath(u"line"_s));
    QCOMPARE(sensors.at(1).toObject().value("rtu"_L1).toString(), folder.filePath(u"line"_s));
    QCOMPARE(sensors.at(2).toObject().value("rtu"_L1).toString(), folder.filePath(u"other"_s));
    QVERIFY(QFileInfo(folder.filePath(u"line"_s)).canonicalFilePath() !=
            QFileInfo(folder.filePath(u"other"_s)).canonicalFilePath());
}

void EmulatorProgramTest::theUnitIsSavedOnlyWhenItIsSaved()
{
    const QTemporaryDir folder;
    const QString state = folder.filePath(u"state.json"_s);
    const QStringList arguments{
        u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s,        u"0"_s, u"--state"_s,
        state,         u"--rtu"_s,         folder.filePath(u"line"_s)};
    const QByteArray readAddress = "0001 0000 0006 01 03 00a8 0001"; // 400169
    {
        Emulator emulator(arguments + QStringList{u"--unit"_s, u"42"_s});
        const quint16 modbus = port(emulator.ready(), "modbusPort"_L1);
        QCOMPARE(ask(modbus, readAddress).right(2), QByteArray::fromHex("002a"));
        QVERIFY(!QFile::exists(state));
        QVERIFY(!ask(modbus, "0001 0000 0006 01 06 0035 0000").isEmpty()); // save
        QCOMPARE(emulator.endWith(SIGTERM), 0);
    }
    const Emulator again(arguments);
    QCOMPARE(ask(port(again.ready(), "modbusPort"_L1), readAddress).right(2), QByteArray::fromHex("002a"));
}

void EmulatorProgramTest::aConfigurationFileStartsSeveralSensors()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"line.json"_s);
    writeFile(path, R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": 0, "toolPort": null},
                                    {"sensor": "HL-G225B-S-MK", "bind": "127.0.0.2", "modbusPort": 0, "toolPort": 0,
                                     "state": "second.json"}]})");
    Emulator emulator({u"--config"_s, path});
    const QJsonArray sensors = emulator.ready().value("sensors"_L1).toArray();
    QVERIFY2(emulator.ready().value("ready"_L1).toBool(), emulator.line() + emulator.errors());
    QCOMPARE(sensors.size(), 2);
    QVERIFY(sensors.at(0).toObject().value("toolPort"_L1).isNull());
    QCOMPARE(ask(port(sensors.at(0).toObject(), "modbusPort"_L1), readHigh).right(4),
             QByteArray::fromHex("c3500000"));
    QCOMPARE(sensors.at(1).toObject().value("sensor"_L1).toString(), u"HL-G225B-S-MK"_s);
    QTcpSocket client;
    client.connectToHost(QHostAddress(u"127.0.0.2"_s), port(sensors.at(1).toObject(), "toolPort"_L1));
    QVERIFY(client.waitForConnected());
    client.write(QByteArray::fromHex("0001 0000 0006 01 06 0035 0000")); // save
    QVERIFY(client.waitForReadyRead());
    QVERIFY(QFile::exists(folder.filePath(u"second.json"_s))); // beside the configuration file
    QCOMPARE(emulator.endWith(SIGTERM), 0);
}

void EmulatorProgramTest::wrongConfigurationFilesNameTheField_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("says");
    QTest::newRow("no JSON") << QByteArray("{") << u"is not JSON"_s;
    QTest::newRow("no sensors") << QByteArray(R"({"sensors": []})") << u"sensors"_s;
    QTest::newRow("more than sensors") << QByteArray(R"({"sensors": [{}], "x": 1})") << u"sensors"_s;
    QTest::newRow("unknown type") << QByteArray(R"({"sensors": [{"sensor": "X", "modbusPort": 0}]})")
                                  << u"sensors[0].sensor"_s;
    QTest::newRow("no type") << QByteArray(R"({"sensors": [{"modbusPort": 0}]})") << u"sensors[0].sensor"_s;
    QTest::newRow("port a text") << QByteArray(
                                        R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": "0"}]})")
                                 << u"sensors[0].modbusPort"_s;
    QTest::newRow("port a fraction") << QByteArray(
                                            R"({"sensors": [{"sensor": "HL-G203B-S-MK", "toolPort": 1.5}]})")
                                     << u"sensors[0].toolPort"_s;
    QTest::newRow("no port") << QByteArray(R"({"sensors": [{"sensor": "HL-G203B-S-MK"}]})")
                             << u"sensors[0]"_s;
    QTest::newRow("unknown field")
        << QByteArray(R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": 0, "color": 1}]})")
        << u"sensors[0].color"_s;
    QTest::newRow("later version")
        << QByteArray(R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": 0, "slmpPort": 0}]})")
        << u"sensors[0].slmpPort: is not in this version"_s;
    const auto withLine = [](const char* fields) {
        return QByteArray(R"({"sensors": [{"sensor": "HL-G203B-S-MK", )") + fields + "}]}";
    };
    QTest::newRow("unit without a line") << withLine(R"("modbusPort": 0, "unit": 2)") << u"belong to rtu"_s;
    QTest::newRow("answering without a line")
        << withLine(R"("modbusPort": 0, "answeringTimeMs": 2)") << u"belong to rtu"_s;
    QTest::newRow("unit of all") << withLine(R"("rtu": "line", "unit": 0)") << u"sensors[0].unit"_s;
    QTest::newRow("unit too large") << withLine(R"("rtu": "line", "unit": 248)") << u"sensors[0].unit"_s;
    QTest::newRow("unit a text") << withLine(R"("rtu": "line", "unit": "2")") << u"sensors[0].unit"_s;
    QTest::newRow("negative answering time")
        << withLine(R"("rtu": "line", "answeringTimeMs": -1)") << u"sensors[0].answeringTimeMs"_s;
    QTest::newRow("line a number") << withLine(R"("rtu": 1)") << u"sensors[0].rtu"_s;
    QTest::newRow("one state for two")
        << QByteArray(R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": 0, "state": "a"},
                                      {"sensor": "HL-G203B-S-MK", "modbusPort": 0, "state": "./a"}]})")
        << u"sensors[1].state"_s;
}

void EmulatorProgramTest::wrongConfigurationFilesNameTheField()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"wrong.json"_s);
    writeFile(path, json);
    QProcess process;
    process.start(program(), {u"--config"_s, path});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 2);
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(path) && message.contains(says), qPrintable(message));
}

void EmulatorProgramTest::savedSettingsSurviveTheProgram()
{
    const QTemporaryDir folder;
    const QString state = folder.filePath(u"state.json"_s);
    const QStringList arguments{u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s,
                                u"0"_s,        u"--state"_s,       state};
    {
        Emulator emulator(arguments);
        const quint16 modbus = port(emulator.ready(), "modbusPort"_L1);
        QVERIFY(!QFile::exists(state));
        QVERIFY(!ask(modbus, "0001 0000 000b 01 10 0075 0002 04 0007 0000").isEmpty()); // offset 7
        QVERIFY(!ask(modbus, "0001 0000 0006 01 06 0035 0000").isEmpty());              // save
        QVERIFY(!ask(modbus, "0001 0000 000b 01 10 0075 0002 04 0008 0000").isEmpty()); // offset 8, not saved
        QCOMPARE(emulator.endWith(SIGTERM), 0);
    }
    const Emulator again(arguments);
    QCOMPARE(ask(port(again.ready(), "modbusPort"_L1), "0001 0000 0006 01 03 0075 0002").right(4),
             QByteArray::fromHex("00070000"));
}

void EmulatorProgramTest::aWrongStateFileIsNeverOverwritten()
{
    const QTemporaryDir folder;
    const QString state = folder.filePath(u"state.json"_s);
    writeFile(state, R"({"format": "lds-emulator-state", "version": 2, "sensor": "HL-G205B-S-MK"})");
    QProcess process;
    process.start(program(),
                  {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--state"_s, state});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 2);
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(state + u": sensor"_s), qPrintable(message));
    QFile file(state);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().endsWith("\"HL-G205B-S-MK\"}"));
}

void EmulatorProgramTest::aHalfWrittenStateFileIsNeverOverwritten()
{
    const QTemporaryDir folder;
    const QString state = folder.filePath(u"state.json"_s);
    const QStringList arguments{u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s,
                                u"0"_s,        u"--state"_s,       state};
    {
        const Emulator emulator(arguments);
        QVERIFY(!ask(emulator.modbusPort(), "0001 0000 0006 01 06 0035 0000").isEmpty()); // save
    }
    QFile file(state);
    QVERIFY(file.open(QIODevice::ReadWrite));
    const qint64 half = file.size() / 2;
    QVERIFY(half > 100 && file.resize(half));
    file.close();
    QProcess process;
    process.start(program(), arguments);
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardError().contains(state.toUtf8()));
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    QCOMPARE(QFile(state).size(), half);
}

void EmulatorProgramTest::aWrongSceneExitsWith2_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("says");
    QTest::newRow("no JSON") << QByteArray("{\n  \"format\" 1}") << u"line 2"_s;
    QTest::newRow("another format") << QByteArray(R"({"format": "x"})") << u"format"_s;
    QTest::newRow("unknown field")
        << QByteArray(R"({"format": "lds-scene", "version": 1, "name": "N", "description": "D",
                          "workpieces": [{"name": "a", "height": 0, "colour": 1}],
                          "motion": {"kind": "still", "workpiece": "a"}})")
        << u"workpieces[0].colour"_s;
}

void EmulatorProgramTest::aWrongSceneExitsWith2()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    const QString scene = folder.filePath(u"wrong.json"_s);
    writeFile(scene, json);
    QProcess process;
    process.start(program(),
                  {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--scene"_s, scene});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 2);
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(scene) && message.contains(says), qPrintable(message));
}

void EmulatorProgramTest::nothingListensBeforeAllFilesAreRead()
{
    QTcpServer taken; // the first sensor could not listen here, but the second's scene is looked at before
    QVERIFY(taken.listen(QHostAddress::LocalHost));
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"line.json"_s);
    writeFile(path, R"({"sensors": [{"sensor": "HL-G203B-S-MK", "modbusPort": )" +
                        QByteArray::number(taken.serverPort()) +
                        R"(}, {"sensor": "HL-G203B-S-MK", "modbusPort": 0, "scene": "nothing.json"}]})");
    QProcess process;
    process.start(program(), {u"--config"_s, path});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 2);
    const QString message = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(message.contains(u"sensors[1]"_s) && message.contains(folder.filePath(u"nothing.json"_s)),
             qPrintable(message));
}

void EmulatorProgramTest::listsTheExampleScenes()
{
    QProcess process;
    process.start(program(), {u"--list-scenes"_s});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 0);
    const QByteArray list = process.readAllStandardOutput();
    QCOMPARE(list.count('\n'), 5);
    QVERIFY2(list.contains("conveyor-step  ") && list.contains("Step height"), list);
}

void EmulatorProgramTest::everyExampleSceneStarts()
{
    QProcess process;
    process.start(program(), {u"--list-scenes"_s});
    QVERIFY(process.waitForFinished(20'000));
    const auto lines = process.readAllStandardOutput().trimmed().split('\n');
    for (const QByteArray& line : lines) {
        const QString key = QString::fromUtf8(line.split(' ').first());
        Emulator emulator({u"--sensor"_s, u"HL-G225B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--scene"_s, key,
                           u"--control"_s});
        QVERIFY2(emulator.ready().value("ready"_L1).toBool(), line);
        QCOMPARE(answerTo(emulator, "status").value("scene"_L1).toString(), key);
    }
}

void EmulatorProgramTest::controlLinesAreAnsweredOneByOne()
{
    Emulator emulator({u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--control"_s});
    QCOMPARE(emulator.ready().value("control"_L1), QJsonValue(true));
    QCOMPARE(answerTo(emulator, "workpiece at 1.5").value("measuredValue"_L1).toInt(), 15'000);
    QVERIFY(answerTo(emulator, "fault nonsense on").value("error"_L1).toString().contains(u"noLight"_s));
    QVERIFY(!answerTo(emulator, QByteArray(100'000, 'x')).value("ok"_L1).toBool());
    QCOMPARE(answerTo(emulator, "fault inMenu on").value("ready"_L1), QJsonValue(false));
    QCOMPARE(ask(emulator.modbusPort(), readHigh), QByteArray::fromHex("0001 0000 0003 01 83 04"));
    QCOMPARE(answerTo(emulator, "fault inMenu off").value("ready"_L1), QJsonValue(true));
    QCOMPARE(ask(emulator.modbusPort(), readHigh).size(), 13);
}

void EmulatorProgramTest::theEndOfStandardInputEndsNothing()
{
    Emulator emulator({u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--control"_s});
    QVERIFY(answerTo(emulator, "status").value("ok"_L1).toBool());
    emulator.closeInput();
    for (int i = 0; i < 3; ++i)
        QCOMPARE(ask(emulator.modbusPort(), readHigh).size(), 13);
    QCOMPARE(emulator.endWith(SIGTERM), 0);
}

void EmulatorProgramTest::aLocalSocketTakesControlLinesToo()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"control"_s);
    const QStringList arguments{u"--sensor"_s, u"HL-G203B-S-MK"_s,    u"--modbus-port"_s,
                                u"0"_s,        u"--control-socket"_s, path};
    for (const int signal : {SIGKILL, SIGTERM}) { // the first one leaves its socket behind
        Emulator emulator(arguments);
        QCOMPARE(emulator.ready().value("controlSocket"_L1).toString(), path);
        QLocalSocket socket;
        socket.connectToServer(path);
        QVERIFY(socket.waitForConnected());
        socket.write("trigger on\n");
        while (!socket.canReadLine())
            QVERIFY(socket.waitForReadyRead());
        QCOMPARE(QJsonDocument::fromJson(socket.readLine()).object().value("trigger"_L1), QJsonValue(true));
        emulator.endWith(signal);
    }
    QVERIFY(!QFile::exists(path));
}

void EmulatorProgramTest::aTakenControlSocketExitsWith1()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"notes"_s);
    writeFile(path, "mine");
    QProcess process;
    process.start(program(), {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s,
                              u"--control-socket"_s, path});
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains(path.toUtf8()));
    QCOMPARE(QFile(path).size(), 4);
}

void EmulatorProgramTest::sixteenSensorsInOneProgram()
{
    QJsonArray sensors;
    for (int number = 1; number <= 16; ++number)
        sensors.append(QJsonObject{{u"sensor"_s, u"HL-G203B-S-MK"_s},
                                   {u"bind"_s, u"127.0.0.%1"_s.arg(number)},
                                   {u"modbusPort"_s, 0}});
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"sixteen.json"_s);
    writeFile(path, QJsonDocument(QJsonObject{{u"sensors"_s, sensors}}).toJson());
    Emulator emulator({u"--config"_s, path, u"--control"_s});
    QCOMPARE(emulator.ready().value("sensors"_L1).toArray().size(), 16);
    for (int number = 1; number <= 16; ++number) {
        const auto place = QByteArray::number(number);
        const QJsonObject answer = answerTo(emulator, "sensor " + place + " workpiece at 0.0" + place);
        QCOMPARE(answer.value("sensor"_L1).toInt(), number);
    }
    const QJsonArray states = answerTo(emulator, "status").value("sensors"_L1).toArray();
    for (int number = 1; number <= 16; ++number) {
        const int value = number < 10 ? 100 * number : 10 * number; // 0.0N mm
        QCOMPARE(states.at(number - 1).toObject().value("measuredValue"_L1).toInt(), value);
    }
}

void EmulatorProgramTest::aServerThatMovesSaysSo()
{
    Emulator emulator({u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--control"_s});
    QTcpServer taken;
    QVERIFY(taken.listen(QHostAddress::LocalHost));
    const QByteArray port = QByteArray::number(taken.serverPort(), 16).rightJustified(4, '0');
    QVERIFY(!ask(emulator.modbusPort(), "0001 0000 0006 01 06 0098 " + port).isEmpty());
    QVERIFY(!ask(emulator.modbusPort(), "0001 0000 0006 01 06 00aa 0000").isEmpty()); // reset
    QCOMPARE(answerTo(emulator, "status").value("modbusPort"_L1).toInt(), emulator.modbusPort());
    const QByteArray told = emulator.errors();
    QVERIFY2(told.contains(QByteArray::number(taken.serverPort())) && told.contains("stays on port"), told);
}

QTEST_GUILESS_MAIN(EmulatorProgramTest)
#include "tst_emulator_program.moc"
