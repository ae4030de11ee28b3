#include "rtu_link_fixture.h"

#include <QFile>
#include <QSerialPort>
#include <QTemporaryDir>

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::LinkState;
using ports::OpenFailure;

namespace {

const QString adapter = QStringLiteral("0403:6001:A1");

} // namespace

/// Ports that are missing, in use, unplugged and plugged in elsewhere.
class RtuPortsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void portThatIsNotThere();
    void portInUseByAnotherProgram();
    void fileThatIsNoPort();
    void otherSettingsForAnOpenPortAreRefused();
    void lastLinkClosesThePort();
    void portLeftAsItWasOpensAgain();
    void adapterComesBackUnderAnotherName();
    void anotherAdapterIsNotTakenForIt();
    void twoAdaptersThatLookAlikeAreNotGuessedAt();
    void pseudoTerminalIsKnownByItsName();
};

void RtuPortsTest::portThatIsNotThere()
{
    RtuLinkFixture f;
    ports::ConnectionUrl url = f.url(1);
    url.host = QStringLiteral("/dev/lds-no-such-port");
    RtuSubject& subject = f.add(url);
    subject.link->open();
    QTRY_COMPARE(subject.state(), LinkState::Failed);
    QCOMPARE(subject.failure(), OpenFailure::NoSuchPort);
}

void RtuPortsTest::portInUseByAnotherProgram()
{
    RtuLinkFixture f;
    QSerialPort other(f.line.port());
    QVERIFY(other.open(QIODevice::ReadWrite));
    f.subject().link->open();
    QTRY_COMPARE(f.subject().state(), LinkState::Failed);
    QCOMPARE(f.subject().failure(), OpenFailure::PortBusy);
    other.close();
    f.openAll();
}

void RtuPortsTest::fileThatIsNoPort()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    RtuLinkFixture f;
    ports::ConnectionUrl url = f.url(1);
    url.host = file.fileName();
    RtuSubject& subject = f.add(url);
    subject.link->open();
    QTRY_COMPARE(subject.state(), LinkState::Failed);
    QCOMPARE(subject.failure(), OpenFailure::PortUnusable);
}

void RtuPortsTest::otherSettingsForAnOpenPortAreRefused()
{
    RtuLinkFixture f({1, 2});
    f.openAll();
    ports::ConnectionUrl url = f.url(3);
    url.serial.parity = ports::SerialParity::Odd;
    RtuSubject& other = f.add(url);
    other.link->open();
    QTRY_COMPARE(other.state(), LinkState::Failed);
    QCOMPARE(other.failure(), OpenFailure::PortSettingsDiffer);
    const auto id = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).status, ports::Status::Done);
    // When nobody has it open any more, the settings are free.
    f.line.units.insert(3);
    f.subjects.at(0)->link->close();
    f.subjects.at(1)->link->close();
    QTRY_COMPARE(f.subjects.at(1)->state(), LinkState::Closed);
    other.link->open();
    QTRY_COMPARE(other.state(), LinkState::Open);
}

void RtuPortsTest::lastLinkClosesThePort()
{
    RtuLinkFixture f({1, 2});
    f.openAll();
    QSerialPort other(f.line.port());
    f.subjects.at(0)->link->close();
    QTRY_COMPARE(f.subjects.at(0)->state(), LinkState::Closed);
    QVERIFY(!other.open(QIODevice::ReadWrite));
    f.subjects.at(1)->link->close();
    QTRY_COMPARE(f.subjects.at(1)->state(), LinkState::Closed);
    QVERIFY(other.open(QIODevice::ReadWrite));
}

/// A pseudo-terminal keeps what a program that was killed has set.
void RtuPortsTest::portLeftAsItWasOpensAgain()
{
    RtuLinkFixture f;
    f.subject().link->open();
    QTRY_COMPARE(f.subject().state(), LinkState::Open);
    QFile kept(f.line.port());
    QVERIFY(kept.open(QIODevice::ReadWrite | QIODevice::Unbuffered));
    for (int i = 0; i < 2; ++i) {
        f.subject().link->close();
        QTRY_COMPARE(f.subject().state(), LinkState::Closed);
        f.subject().link->open();
        QTRY_COMPARE(f.subject().state(), LinkState::Open);
    }
}

void RtuPortsTest::adapterComesBackUnderAnotherName()
{
    RtuLinkFixture f({1, 2});
    f.listed->append({f.line.port(), QStringLiteral("adapter"), adapter});
    f.openAll();
    f.line.unplug();
    for (const auto& subject : f.subjects)
        QTRY_COMPARE(subject->failure(), OpenFailure::PortGone);
    f.listed->clear();
    f.subject().link->open();
    QTRY_COMPARE(f.subject().failure(), OpenFailure::NoSuchPort);

    ScriptedLine elsewhere;
    elsewhere.units = {1, 2};
    f.listed->append(
        {QStringLiteral("/dev/lds-no-such-port"), QStringLiteral("another"), QStringLiteral("1:2:3")});
    f.listed->append({elsewhere.port(), QStringLiteral("adapter"), adapter});
    f.openAll();
    for (const auto& subject : f.subjects) {
        const auto id = subject->read({ItemId::Span});
        QTRY_COMPARE(subject->endings(id), 1);
        QCOMPARE(subject->outcome(id).values.value(ItemId::Span), 10'000);
    }
    QVERIFY(!elsewhere.received.isEmpty());
}

void RtuPortsTest::anotherAdapterIsNotTakenForIt()
{
    RtuLinkFixture f;
    f.listed->append({f.line.port(), QStringLiteral("adapter"), adapter});
    f.openAll();
    f.subject().link->close();
    QTRY_COMPARE(f.subject().state(), LinkState::Closed);
    // Now another one has the name.
    *f.listed = {{f.line.port(), QStringLiteral("another"), QStringLiteral("1:2:3")}};
    const qsizetype asked = f.line.received.size();
    f.subject().link->open();
    QTRY_COMPARE(f.subject().failure(), OpenFailure::NoSuchPort);
    QCOMPARE(f.line.received.size(), asked);
}

void RtuPortsTest::twoAdaptersThatLookAlikeAreNotGuessedAt()
{
    RtuLinkFixture f;
    f.listed->append({f.line.port(), QStringLiteral("adapter"), adapter});
    f.openAll();
    f.subject().link->close();
    QTRY_COMPARE(f.subject().state(), LinkState::Closed);
    const ScriptedLine one;
    const ScriptedLine two;
    *f.listed = {{one.port(), QString(), adapter}, {two.port(), QString(), adapter}};
    f.subject().link->open();
    QTRY_COMPARE(f.subject().failure(), OpenFailure::NoSuchPort);
    // The one with the name is the one.
    f.listed->append({f.line.port(), QString(), adapter});
    f.openAll();
}

void RtuPortsTest::pseudoTerminalIsKnownByItsName()
{
    RtuLinkFixture f;
    f.openAll();
    f.subject().link->close();
    QTRY_COMPARE(f.subject().state(), LinkState::Closed);
    f.listed->append({QStringLiteral("/dev/ttyUSB0"), QString(), adapter});
    f.openAll();
}

QTEST_GUILESS_MAIN(RtuPortsTest)
#include "tst_rtu_ports.moc"
