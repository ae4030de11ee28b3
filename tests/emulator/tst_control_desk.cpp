// Control lines carried out on running stations, directly and over a local socket.
#include "control_desk.h"
#include "control_socket.h"
#include "manual_clock.h"

#include <memory>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocalSocket>
#include <QTemporaryDir>
#include <QTest>

using namespace lds::app;
using namespace lds::emulator;
using namespace Qt::StringLiterals;

class ControlDeskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void everyAnswerIsOneLineOfJson_data();
    void everyAnswerIsOneLineOfJson();
    void anAnswerIsTheStateAfterIt();
    void aRefusedLineChangesNothing();
    void aPowerCycleForgetsWhatWasNotSaved();
    void oneOfSeveralSensorsHasToBeNamed();
    void statusWithoutANameTellsOfAll();

    void aSocketAnswersSeveralClients();
    void aSocketIsForTheSameUserOnly();
    void furtherClientsAreToldAndClosed();
    void aClientThatLeavesMakesRoom();
    void anEndlessLineIsAnsweredOnce();
    void aClientThatReadsNothingIsCutOff();
    void aSocketLeftBehindIsReplaced();
    void aLivingSocketAndOtherFilesAreNotReplaced();

private:
    void start(int count);
    QJsonObject ask(const QByteArray& line) { return object(m_desk->answer(line)); }
    static QJsonObject object(const QByteArray& line) { return QJsonDocument::fromJson(line).object(); }
    static QString errorOf(const QJsonObject& answer) { return answer.value("error"_L1).toString(); }
    std::unique_ptr<QLocalSocket> connectTo(const ControlSocket& server);
    QString path() const { return m_folder->filePath(u"control"_s); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ManualClock> m_clock;
    std::vector<std::unique_ptr<SensorStation>> m_stations;
    std::unique_ptr<ControlDesk> m_desk;
};

void ControlDeskTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_clock = std::make_unique<ManualClock>();
    start(1);
}

void ControlDeskTest::cleanup()
{
    m_desk.reset();
    m_stations.clear();
}

void ControlDeskTest::start(int count)
{
    cleanup();
    QList<SensorStation*> stations;
    for (int i = 0; i < count; ++i) {
        m_stations.push_back(std::move(*SensorStation::start({}, *m_clock)));
        stations.append(m_stations.back().get());
    }
    m_desk = std::make_unique<ControlDesk>(stations);
}

void ControlDeskTest::everyAnswerIsOneLineOfJson_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<bool>("ok");
    QTest::newRow("status") << QByteArray("status") << true;
    QTest::newRow("help") << QByteArray("help") << true;
    QTest::newRow("empty") << QByteArray() << false;
    QTest::newRow("zero bytes") << QByteArray("status\0status", 13) << false;
    QTest::newRow("no UTF-8") << QByteArray("workpiece \xff\xfe") << false;
    QTest::newRow("cut UTF-8") << QByteArray("workpiece \xe2\x82") << false;
    QTest::newRow("control characters") << QByteArray("\x01\x02\x1b[31m\x7f") << false;
    QTest::newRow("quotes") << QByteArray(R"(fault "\" on)") << false;
    QTest::newRow("JSON") << QByteArray(R"({"fault": "noLight"})") << false;
    QTest::newRow("another script") << QByteArray("workpiece 黒いゴム") << false;
    QTest::newRow("a folder") << QByteArray("scene /") << false;
    QTest::newRow("a device that never ends") << QByteArray("scene /dev/zero") << false;
    QTest::newRow("the largest line") << QByteArray(ControlDesk::longestLine, 'a') << false;
}

void ControlDeskTest::everyAnswerIsOneLineOfJson()
{
    QFETCH(QByteArray, line);
    QFETCH(bool, ok);
    const QByteArray answer = m_desk->answer(line);
    QCOMPARE(answer.count('\n'), 1);
    QVERIFY(answer.endsWith('\n'));
    QJsonParseError error;
    QJsonDocument::fromJson(answer, &error);
    QVERIFY2(error.error == QJsonParseError::NoError, answer);
    QCOMPARE(object(answer).value("ok"_L1), QJsonValue(ok));
    QCOMPARE(errorOf(object(answer)).isEmpty(), ok);
    QVERIFY(answer.size() < 2000);
}

void ControlDeskTest::anAnswerIsTheStateAfterIt()
{
    QJsonObject answer = ask("scene rubber-and-steel");
    QCOMPARE(answer.value("scene"_L1).toString(), u"rubber-and-steel"_s);
    QVERIFY(answer.value("workpieces"_L1).toArray().contains(u"black rubber"_s));
    QCOMPARE(answer.value("workpiece"_L1).toString(), u"moving"_s);
    QCOMPARE(ask("workpiece black rubber").value("workpiece"_L1).toString(), u"black rubber"_s);
    QCOMPARE(ask("workpiece at -0.25").value("workpiece"_L1).toString(), u"at -0.2500"_s);
    QCOMPARE(ask("status").value("measuredValue"_L1).toInt(), -2500);
    QCOMPARE(ask("scene gentle").value("scene"_L1).toString(), u"gentle"_s);
    answer = ask("fault slowAnswers on 40");
    const QJsonObject fault = answer.value("faults"_L1).toArray().first().toObject();
    QCOMPARE(fault.value("name"_L1).toString(), u"slowAnswers"_s);
    QCOMPARE(fault.value("by"_L1).toString(), u"person"_s);
    QCOMPARE(fault.value("milliseconds"_L1).toInt(), 40);
    QVERIFY(ask("fault slowAnswers off").value("faults"_L1).toArray().isEmpty());
    QCOMPARE(ask("trigger on").value("trigger"_L1), QJsonValue(true));
    QCOMPARE(ask("fault inMenu on").value("ready"_L1), QJsonValue(false));
}

void ControlDeskTest::aRefusedLineChangesNothing()
{
    const QByteArray before = m_desk->answer("status");
    for (const char* line :
         {"scene nothing", "workpiece nobody", "fault noLight perhaps", "trigger", "sensor 2 status"})
        QVERIFY2(!errorOf(ask(line)).isEmpty(), line);
    QCOMPARE(m_desk->answer("status"), before);
    QVERIFY(errorOf(ask("scene nothing")).contains(u"conveyor-step"_s));
    QVERIFY(errorOf(ask("workpiece nobody")).contains(u"moving"_s));
}

void ControlDeskTest::aPowerCycleForgetsWhatWasNotSaved()
{
    auto& sensor = m_stations.front()->sensor();
    sensor.write({{lds::catalog::ItemId::Offset, 7}});
    QCOMPARE(ask("power cycle").value("ok"_L1), QJsonValue(true));
    QCOMPARE(sensor.memory().value(lds::catalog::ItemId::Offset), 0);
}

void ControlDeskTest::oneOfSeveralSensorsHasToBeNamed()
{
    start(3);
    QVERIFY(errorOf(ask("trigger on")).contains(u"3"_s));
    QVERIFY(errorOf(ask("sensor 0 trigger on")).contains(u"1 to 3"_s));
    QVERIFY(errorOf(ask("sensor 4 trigger on")).contains(u"1 to 3"_s));
    QVERIFY(errorOf(ask("sensor -1 trigger on")).contains(u"1 to 3"_s));
    const QJsonObject answer = ask("sensor 2 trigger on");
    QCOMPARE(answer.value("sensor"_L1).toInt(), 2);
    QVERIFY(m_stations[1]->player().triggerByPerson());
    QVERIFY(!m_stations[0]->player().triggerByPerson() && !m_stations[2]->player().triggerByPerson());
}

void ControlDeskTest::statusWithoutANameTellsOfAll()
{
    start(3);
    const QJsonArray sensors = ask("status").value("sensors"_L1).toArray();
    QCOMPARE(sensors.size(), 3);
    QCOMPARE(sensors.at(2).toObject().value("sensor"_L1).toInt(), 3);
    QCOMPARE(ask("sensor 3 status").value("sensor"_L1).toInt(), 3);
}

std::unique_ptr<QLocalSocket> ControlDeskTest::connectTo(const ControlSocket& server)
{
    auto socket = std::make_unique<QLocalSocket>();
    socket->connectToServer(server.path());
    [&] { QTRY_COMPARE(socket->state(), QLocalSocket::ConnectedState); }();
    return socket;
}

void ControlDeskTest::aSocketAnswersSeveralClients()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    const auto first = connectTo(server);
    const auto second = connectTo(server);
    first->write("trigger on\nsta");
    QTRY_VERIFY(first->canReadLine());
    QCOMPARE(object(first->readLine()).value("trigger"_L1), QJsonValue(true));
    second->write("trigger off\n");
    QTRY_VERIFY(second->canReadLine());
    first->write("tus\n");
    QTRY_VERIFY(first->canReadLine());
    QCOMPARE(object(first->readLine()).value("trigger"_L1), QJsonValue(false));
    QCOMPARE(server.clientCount(), 2);
}

void ControlDeskTest::aSocketIsForTheSameUserOnly()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    QVERIFY(!(QFile::permissions(path()) & others));
}

void ControlDeskTest::furtherClientsAreToldAndClosed()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    std::vector<std::unique_ptr<QLocalSocket>> clients;
    for (int i = 0; i < ControlSocket::mostClients; ++i)
        clients.push_back(connectTo(server));
    QTRY_COMPARE(server.clientCount(), ControlSocket::mostClients);
    QLocalSocket tooMany;
    tooMany.connectToServer(server.path());
    QTRY_VERIFY(tooMany.canReadLine());
    QVERIFY(errorOf(object(tooMany.readLine())).contains(u"too many"_s));
    QTRY_COMPARE(tooMany.state(), QLocalSocket::UnconnectedState);
    QCOMPARE(server.clientCount(), ControlSocket::mostClients);
}

void ControlDeskTest::aClientThatLeavesMakesRoom()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    for (int i = 0; i < 3 * ControlSocket::mostClients; ++i) {
        const auto client = connectTo(server);
        client->write("status\n");
        QTRY_VERIFY(client->canReadLine());
        client->disconnectFromServer();
        QTRY_COMPARE(server.clientCount(), 0);
    }
}

void ControlDeskTest::anEndlessLineIsAnsweredOnce()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    const auto client = connectTo(server);
    client->write(QByteArray(500'000, 'x') + "\nstatus\n");
    QTRY_VERIFY(client->canReadLine());
    QVERIFY(errorOf(object(client->readLine())).contains(QString::number(ControlDesk::longestLine)));
    QTRY_VERIFY(client->canReadLine());
    QCOMPARE(object(client->readLine()).value("ok"_L1), QJsonValue(true));
    QVERIFY(!client->canReadLine());
}

void ControlDeskTest::aClientThatReadsNothingIsCutOff()
{
    ControlSocket server(*m_desk);
    QVERIFY(server.listen(path()).has_value());
    const auto client = connectTo(server);
    client->setReadBufferSize(1);
    QByteArray lines;
    for (int i = 0; i < 20'000; ++i)
        lines += "status\n";
    client->write(lines);
    QTRY_COMPARE_WITH_TIMEOUT(server.clientCount(), 0, 20'000);
    const auto other = connectTo(server);
    other->write("status\n");
    QTRY_VERIFY(other->canReadLine());
}

void ControlDeskTest::aSocketLeftBehindIsReplaced()
{
    // As after kill -9: the file is there and nobody listens.
    {
        QLocalServer dead;
        QVERIFY(dead.listen(path()));
        QVERIFY(QFile::rename(path(), path() + u".kept"_s));
    }
    QVERIFY(QFile::rename(path() + u".kept"_s, path()));
    ControlSocket server(*m_desk);
    const auto listening = server.listen(path());
    QVERIFY2(listening.has_value(), listening ? "" : qPrintable(listening.error()));
    const auto client = connectTo(server);
}

void ControlDeskTest::aLivingSocketAndOtherFilesAreNotReplaced()
{
    ControlSocket first(*m_desk);
    QVERIFY(first.listen(path()).has_value());
    ControlSocket second(*m_desk);
    const auto taken = second.listen(path());
    QVERIFY(!taken.has_value());
    QVERIFY2(taken.error().contains(path()), qPrintable(taken.error()));
    const auto client = connectTo(first);

    const QString text = m_folder->filePath(u"notes.txt"_s);
    QFile file(text);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("mine");
    file.close();
    QVERIFY(!ControlSocket(*m_desk).listen(text).has_value());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), "mine");
}

QTEST_GUILESS_MAIN(ControlDeskTest)
#include "tst_control_desk.moc"
