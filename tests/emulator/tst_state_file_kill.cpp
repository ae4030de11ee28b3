// kill −9 at any moment: the state file has the old or the new content, never a mixture.
#include "emulator_process.h"
#include "state_file.h"

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include <signal.h>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace Qt::StringLiterals;

namespace {

constexpr int kills = 15;
constexpr qint64 longestLifeNs = 40'000'000;
constexpr int spanAtZero = 10'000;

/// Span and offset in one message, then saving; the offset is 0.01 mm × `number`.
QByteArray writeAndSave(int number)
{
    QByteArray message = QByteArray::fromHex("0001 0000 000f 01 10 0073 0004 08");
    for (const int value : {spanAtZero + number, 100 * number}) {
        for (const int word : {value & 0xffff, value >> 16})
            message += QByteArray{} + char(word >> 8) + char(word & 0xff);
    }
    return message + QByteArray::fromHex("0002 0000 0006 01 06 0035 0000");
}

constexpr qsizetype answersSize = 12 + 12; ///< Of both, when neither is an exception.

} // namespace

class StateFileKillTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void holdsTheOldOrTheNewContentAfterAKill();

private:
    /// The number the file holds; nothing when there is no file. Fails when it holds a mixture.
    void readNumber(const QString& path, std::optional<int>& number);
    int m_sent = 0; ///< The last number sent.
};

void StateFileKillTest::readNumber(const QString& path, std::optional<int>& number)
{
    const auto state = StateFile(path).load(SensorModel::HlG203);
    QVERIFY2(state.has_value(), state ? "" : qPrintable(state.error()));
    if (!state->has_value())
        return;
    const SettingsMemory& settings = (*state)->settings;
    number = settings.value(ItemId::Offset) / 100;
    QCOMPARE(settings.value(ItemId::Span), spanAtZero + *number);
}

void StateFileKillTest::holdsTheOldOrTheNewContentAfterAKill()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"state.json"_s);
    const quint32 seed = QRandomGenerator::global()->generate();
    qInfo("seed %u", seed);
    QRandomGenerator random(seed);
    std::optional<int> answered; // the last number whose saving was answered
    int killedWhileSaving = 0;
    for (int kill = 0; kill < kills; ++kill) {
        lds::test::EmulatorProcess emulator(
            {u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--state"_s, path});
        QVERIFY2(emulator.modbusPort() > 0, emulator.errors()); // it takes what the last one left
        QTcpSocket client;
        client.connectToHost(QHostAddress::LocalHost, emulator.modbusPort());
        QVERIFY(client.waitForConnected());
        const qint64 lifeNs = random.bounded(longestLifeNs);
        QElapsedTimer life;
        life.start();
        bool whole = true;
        while (whole && life.nsecsElapsed() < lifeNs) {
            client.write(writeAndSave(++m_sent));
            client.flush();
            QByteArray answers;
            while (answers.size() < answersSize && life.nsecsElapsed() < lifeNs) {
                client.waitForReadyRead(1);
                answers += client.readAll();
            }
            whole = answers.size() == answersSize;
            if (whole)
                answered = m_sent;
        }
        killedWhileSaving += whole ? 0 : 1;
        emulator.endWith(SIGKILL);
        std::optional<int> held;
        readNumber(path, held);
        if (QTest::currentTestFailed())
            return;
        QVERIFY2(held == answered || held == m_sent,
                 qPrintable(u"%1 after %2"_s.arg(held.value_or(-1)).arg(m_sent)));
        answered = held;
    }
    QVERIFY(answered.has_value());
    qInfo("%d savings, %d of %d kills with one under way", m_sent, killedWhileSaving, kills);
    QVERIFY(killedWhileSaving > 0);
}

QTEST_GUILESS_MAIN(StateFileKillTest)
#include "tst_state_file_kill.moc"
