// The emulator's end of a pseudo-terminal, with a real client at the other.
#include "pseudo_terminal.h"
#include "serial_client.h"
#include "system_clock.h"

#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <sys/ioctl.h>

using namespace lds::emulator;
using namespace Qt::StringLiterals;
using lds::catalog::LineParity;
using lds::test::SerialClient;

class PseudoTerminalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_terminal.reset(); }

    void theLinkLeadsToTheTerminalAndGoesWithIt();
    void bytesGoBothWaysUnchanged();
    void seesTheClientsSettings_data();
    void seesTheClientsSettings();
    void aSpeedThatIsNoneIsNotTold();
    void aClientThatSetsNothingSpeaksAsASensorIsDelivered();
    void theSameSettingsAreTakenFromTheNextClient();
    void aClientThatWasKilledLeavesNothingBehind();
    void survivesClientsThatComeAndGo();
    void aClientThatLeavesAtOnceIsHeard();
    void whatAClientDidNotReadIsNotForTheNext();
    void nothingIsKeptForAClientThatIsNotThere();
    void aClientThatLeftEchoOnDoesNotSpoilTheLine();
    void aClientThatDoesNotReadLosesBytes();

    void aFileInTheWayStays_data();
    void aFileInTheWayStays();
    void aForeignLinkStays();
    void aLinkLeftBehindIsTakenOver();
    void aLinkInUseIsRefused();
    void aMissingFolderIsTold();
    void aLinkThatWasReplacedIsNotRemoved();

private:
    void open();
    QString path(const QString& name = u"line"_s) const { return m_folder->filePath(name); }
    static QString errorOf(const PseudoTerminal::Opened& opened)
    {
        return opened ? QString() : opened.error();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    SystemClock m_clock;
    std::unique_ptr<PseudoTerminal> m_terminal;
    QByteArray m_received;
};

void PseudoTerminalTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_received.clear();
}

void PseudoTerminalTest::open()
{
    auto opened = PseudoTerminal::open(path(), m_clock);
    QVERIFY2(opened.has_value(), qPrintable(errorOf(opened)));
    m_terminal = std::move(*opened);
    connect(m_terminal.get(), &LineTerminal::received, this,
            [this](const QByteArray& bytes) { m_received += bytes; });
}

void PseudoTerminalTest::theLinkLeadsToTheTerminalAndGoesWithIt()
{
    open();
    QCOMPARE(m_terminal->link(), path());
    QVERIFY(QFileInfo(path()).isSymLink());
    QCOMPARE(QFileInfo(path()).canonicalFilePath(), m_terminal->device());
    m_terminal.reset();
    QVERIFY(!QFileInfo(path()).isSymLink());
}

void PseudoTerminalTest::bytesGoBothWaysUnchanged()
{
    open();
    SerialClient client(path());
    QVERIFY(client.isOpen());
    QByteArray all(256, Qt::Uninitialized);
    for (int i = 0; i < 256; ++i)
        all[i] = char(i); // among them every control character of a terminal
    QVERIFY(client.send(all));
    QTRY_COMPARE(m_received, all);
    m_terminal->send(all);
    QByteArray taken;
    QTRY_COMPARE(taken += client.take(), all);
    QCOMPARE(m_received, all); // and no echo
}

void PseudoTerminalTest::seesTheClientsSettings_data()
{
    QTest::addColumn<speed_t>("code");
    QTest::addColumn<int>("speed");
    QTest::addColumn<LineParity>("parity");
    const std::pair<speed_t, int> speeds[] = {{B9600, 9600},     {B19200, 19200},   {B38400, 38400},
                                              {B115200, 115200}, {B230400, 230400}, {B57600, 57600}};
    for (const auto& [code, speed] : speeds) {
        QTest::addRow("%d none", speed) << code << speed << LineParity::None;
        QTest::addRow("%d even", speed) << code << speed << LineParity::Even;
        QTest::addRow("%d odd", speed) << code << speed << LineParity::Odd;
    }
}

void PseudoTerminalTest::seesTheClientsSettings()
{
    QFETCH(speed_t, code);
    QFETCH(int, speed);
    QFETCH(LineParity, parity);
    open();
    SerialClient client(path());
    client.configure(B1200, LineParity::Odd); // something else first
    QCOMPARE(m_terminal->clientSettings(), std::optional(LineSettings{1200, LineParity::Odd}));
    client.configure(code, parity);
    QCOMPARE(m_terminal->clientSettings(), std::optional(LineSettings{speed, parity}));
}

void PseudoTerminalTest::aSpeedThatIsNoneIsNotTold()
{
    open();
    SerialClient client(path());
    client.configure(B0, LineParity::Even);
    QCOMPARE(m_terminal->clientSettings(), std::nullopt);
}

void PseudoTerminalTest::aClientThatSetsNothingSpeaksAsASensorIsDelivered() // §6.2
{
    open();
    for (int time = 0; time < 2; ++time) {
        {
            const SerialClient client(path());
            QCOMPARE(m_terminal->clientSettings(), std::optional(LineSettings{38'400, LineParity::Even}));
            SerialClient other(path());
            other.configure(B9600, LineParity::None);
            QCOMPARE(m_terminal->clientSettings(), std::optional(LineSettings{9'600, LineParity::None}));
            QVERIFY(other.send("x"));
            QTRY_COMPARE(m_received, QByteArray(time + 1, 'x'));
        }
        QTRY_VERIFY(!m_terminal->isOpen()); // and the next one begins anew
    }
}

void PseudoTerminalTest::theSameSettingsAreTakenFromTheNextClient()
{
    open();
    for (int time = 0; time < 3; ++time) {
        {
            SerialClient client(path());
            QVERIFY(client.configure(B38400, LineParity::Even)); // refused where it would change nothing
            QVERIFY(client.send("x"));
            QTRY_COMPARE(m_received, QByteArray(time + 1, 'x'));
        }
        if (time > 0) // and from one that comes before the last is known to have left
            QTRY_VERIFY(!m_terminal->isOpen());
    }
}

/// One that had the port for itself, as serial port libraries do, and could not give it back.
void PseudoTerminalTest::aClientThatWasKilledLeavesNothingBehind()
{
    open();
    {
        SerialClient client(path());
        QCOMPARE(::ioctl(client.descriptor(), TIOCEXCL), 0);
        client.send("x");
        QTRY_COMPARE(m_received, QByteArray("x"));
    }
    std::unique_ptr<SerialClient> next;
    QTRY_VERIFY((next = std::make_unique<SerialClient>(path()))->isOpen()); // root may at once
    next->send("y");
    QTRY_COMPARE(m_received, QByteArray("xy"));
    QCOMPARE(QFileInfo(path()).canonicalFilePath(), m_terminal->device());
}

void PseudoTerminalTest::survivesClientsThatComeAndGo()
{
    open();
    for (int time = 0; time < 4; ++time) {
        {
            SerialClient client(path());
            m_received.clear();
            QVERIFY(client.send("hello"));
            QTRY_COMPARE(m_received, QByteArray("hello"));
            m_terminal->send("answer");
            QByteArray taken;
            QTRY_COMPARE(taken += client.take(), QByteArray("answer"));
        }
        QTRY_VERIFY(!m_terminal->isOpen());
    }
}

void PseudoTerminalTest::aClientThatLeavesAtOnceIsHeard()
{
    open();
    for (int time = 1; time <= 3; ++time) {
        SerialClient(path()).send("x"); // also while the last one is known to have left
        QTRY_COMPARE(m_received, QByteArray(time, 'x'));
        QTRY_VERIFY(!m_terminal->isOpen());
    }
}

void PseudoTerminalTest::whatAClientDidNotReadIsNotForTheNext()
{
    open();
    {
        SerialClient client(path());
        client.send("?");
        QTRY_COMPARE(m_received, QByteArray("?"));
        m_terminal->send("stale");
    }
    QTRY_VERIFY(!m_terminal->isOpen());
    SerialClient next(path());
    next.send("!");
    QTRY_COMPARE(m_received, QByteArray("?!"));
    m_terminal->send("fresh");
    QByteArray taken;
    QTRY_COMPARE(taken += next.take(), QByteArray("fresh"));
}

void PseudoTerminalTest::nothingIsKeptForAClientThatIsNotThere()
{
    open();
    SerialClient(path()).send("?");
    QTRY_VERIFY(!m_terminal->isOpen());
    m_terminal->send("late");
    SerialClient next(path());
    next.send("!");
    QTRY_COMPARE(m_received, QByteArray("?!"));
    m_terminal->send("fresh");
    QByteArray taken;
    QTRY_COMPARE(taken += next.take(), QByteArray("fresh"));
}

void PseudoTerminalTest::aClientThatLeftEchoOnDoesNotSpoilTheLine()
{
    open();
    {
        SerialClient client(path());
        termios cooked = {};
        ::tcgetattr(client.descriptor(), &cooked);
        cooked.c_lflag |= ECHO | ICANON;
        cooked.c_oflag |= OPOST | ONLCR;
        ::tcsetattr(client.descriptor(), TCSANOW, &cooked);
        client.send("?");
        QTRY_COMPARE(m_received, QByteArray("?"));
    }
    QTRY_VERIFY(!m_terminal->isOpen());
    SerialClient next(path());
    next.send("\n");
    QTRY_COMPARE(m_received, QByteArray("?\n"));
    m_terminal->send("\r");
    QByteArray taken;
    QTRY_COMPARE(taken += next.take(), QByteArray("\r"));
    QCOMPARE(m_received, QByteArray("?\n"));
}

void PseudoTerminalTest::aClientThatDoesNotReadLosesBytes()
{
    open();
    SerialClient client(path());
    client.send("?");
    QTRY_COMPARE(m_received, QByteArray("?"));
    for (int i = 0; i < 1000; ++i)
        m_terminal->send(QByteArray(255, 'x')); // much more than the system keeps, and it does not block
    client.send("!");
    QTRY_COMPARE(m_received, QByteArray("?!"));
}

void PseudoTerminalTest::aFileInTheWayStays_data()
{
    QTest::addColumn<bool>("isFolder");
    QTest::newRow("file") << false;
    QTest::newRow("folder") << true;
}

void PseudoTerminalTest::aFileInTheWayStays()
{
    QFETCH(bool, isFolder);
    if (isFolder) {
        QVERIFY(QDir().mkdir(path()));
    } else {
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("precious") == 8);
    }
    const auto opened = PseudoTerminal::open(path(), m_clock);
    QVERIFY(!opened.has_value());
    QVERIFY2(opened.error().startsWith(path() + u": exists"_s), qPrintable(opened.error()));
    QCOMPARE(QFileInfo(path()).isDir(), isFolder);
    QVERIFY(isFolder || QFileInfo(path()).size() == 8);
}

void PseudoTerminalTest::aForeignLinkStays()
{
    QVERIFY(QFile::link(u"/dev/pts/0"_s, path())); // as socat makes them
    const auto opened = PseudoTerminal::open(path(), m_clock);
    QVERIFY(!opened.has_value());
    QVERIFY2(opened.error().contains(u"somebody else's link to /dev/pts/0"_s), qPrintable(opened.error()));
    QVERIFY(QFileInfo(path()).isSymLink());
}

void PseudoTerminalTest::aLinkLeftBehindIsTakenOver()
{
    QVERIFY(QFile::link(u"/dev/pts/./99999"_s, path())); // of one that was killed
    open();
    QCOMPARE(QFileInfo(path()).canonicalFilePath(), m_terminal->device());
}

void PseudoTerminalTest::aLinkInUseIsRefused()
{
    open();
    const auto second = PseudoTerminal::open(m_folder->path() + u"/../"_s + QDir(m_folder->path()).dirName() +
                                                 u"/line"_s, // the same, by another name
                                             m_clock);
    QVERIFY(!second.has_value());
    QVERIFY2(second.error().contains(u"another emulator serves this link"_s), qPrintable(second.error()));
    QCOMPARE(QFileInfo(path()).canonicalFilePath(), m_terminal->device());
    QVERIFY(PseudoTerminal::open(path(u"other"_s), m_clock).has_value());
}

void PseudoTerminalTest::aMissingFolderIsTold()
{
    const auto opened = PseudoTerminal::open(path(u"none/line"_s), m_clock);
    QVERIFY(!opened.has_value());
    QVERIFY2(opened.error().contains(u"the folder does not exist"_s), qPrintable(opened.error()));
}

void PseudoTerminalTest::aLinkThatWasReplacedIsNotRemoved()
{
    open();
    QVERIFY(QFile::remove(path()));
    QVERIFY(QFile::link(u"/dev/null"_s, path()));
    m_terminal.reset();
    QVERIFY(QFileInfo(path()).isSymLink());
}

QTEST_GUILESS_MAIN(PseudoTerminalTest)
#include "tst_pseudo_terminal.moc"
