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
/// By which the kill may come after a request has been sent: longer than a saving takes, so that it comes
/// before, during and after.
constexpr qint64 longestDelayNs = 1'500'000;
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
    void send(QTcpSocket& client)
    {
        client.write(writeAndSave(++m_sent));
        client.flush();
    }
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
    int newContents = 0;
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
        while (life.nsecsElapsed() < lifeNs) {
            send(client);
            QByteArray answers;
            while (answers.size() < answersSize && client.waitForReadyRead(10'000))
                answers += client.readAll();
            QCOMPARE(answers.size(), answersSize);
            answered = m_sent;
        }
        send(client);
        const qint64 killNs = life.nsecsElapsed() + random.bounded(longestDelayNs);
        while (life.nsecsElapsed() < killNs) {
            // Nothing that waits is as exact.
        }
        emulator.endWith(SIGKILL);
        std::optional<int> held;
        readNumber(path, held);
        if (QTest::currentTestFailed())
            return;
        QVERIFY2(held == answered || held == m_sent,
                 qPrintable(u"%1 after %2"_s.arg(held.value_or(-1)).arg(m_sent)));
        newContents += held == m_sent ? 1 : 0;
        answered = held;
    }
    QVERIFY(answered.has_value());
    qInfo("%d savings; the last one before the kill was there after %d of %d", m_sent, newContents, kills);
}

QTEST_GUILESS_MAIN(StateFileKillTest)
#include "tst_state_file_kill.moc"
