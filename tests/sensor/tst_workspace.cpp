#include "fake_link.h"
#include "manual_scheduler.h"
#include "workspace.h"

#include <QPointer>
#include <QSignalSpy>
#include <QtTest>

using namespace lds::sensor;
using lds::ports::ConnectionUrl;

namespace {

ConnectionUrl urlOf(const char* host, quint16 port = 502)
{
    ConnectionUrl url;
    url.host = QString::fromLatin1(host);
    url.port = port;
    return url;
}

} // namespace

class WorkspaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_workspace = std::make_unique<Workspace>(m_links, m_scheduler); }
    void cleanup()
    {
        m_workspace.reset();
        lds::support::settle();
    }

    void anAddedSensorIsCurrentAndNotOpenedYet()
    {
        const QSignalSpy added(m_workspace.get(), &Workspace::added);
        const QSignalSpy current(m_workspace.get(), &Workspace::currentChanged);
        SensorSession* session = m_workspace->add(urlOf("127.0.0.1"), QStringLiteral("Left"));
        QCOMPARE(m_workspace->current(), session);
        QCOMPARE(session->name(), QStringLiteral("Left"));
        QCOMPARE(session->connection(), Connection::Closed);
        QCOMPARE(added.count(), 1);
        QCOMPARE(current.count(), 1);
    }

    void aSensorWithoutANameIsCalledByItsAddress()
    {
        QCOMPARE(m_workspace->add(urlOf("127.0.0.1"))->name(), QStringLiteral("127.0.0.1"));
        QCOMPARE(m_workspace->add(urlOf("127.0.0.2", 49152))->name(), QStringLiteral("127.0.0.2:49152"));
    }

    void onALineItIsPortAndAddressThatTellSensorsApart()
    {
        ConnectionUrl url = urlOf("/dev/ttyUSB0");
        url.protocol = lds::ports::Protocol::ModbusRtu;
        SensorSession* first = m_workspace->add(url);
        QCOMPARE(first->name(), QStringLiteral("ttyUSB0 \u00b7 1"));
        ConnectionUrl faster = url;
        faster.serial.baud = 115'200;
        QCOMPARE(m_workspace->add(faster), first);
        ConnectionUrl next = url;
        next.unit = 2;
        QVERIFY(m_workspace->add(next) != first);
        QCOMPARE(m_workspace->find(next)->name(), QStringLiteral("ttyUSB0 \u00b7 2"));
        ConnectionUrl elsewhere = url;
        elsewhere.host = QStringLiteral("/dev/ttyUSB1");
        QCOMPARE(m_workspace->find(elsewhere), nullptr);
        QVERIFY(!isSameSensor(url, urlOf("/dev/ttyUSB0"))); // a host of that name
    }

    void theSameAddressIsTheSameSensor()
    {
        SensorSession* first = m_workspace->add(urlOf("localhost"));
        SensorSession* other = m_workspace->add(urlOf("localhost", 5020));
        QVERIFY(first != other);
        const QSignalSpy added(m_workspace.get(), &Workspace::added);
        QCOMPARE(m_workspace->add(urlOf("LOCALHOST")), first);
        QCOMPARE(added.count(), 0);
        QCOMPARE(m_workspace->current(), first);
        QCOMPARE(m_workspace->sessions(), (QList{first, other}));
    }

    void removingTheCurrentOneMovesToItsNeighbour()
    {
        SensorSession* first = m_workspace->add(urlOf("127.0.0.1"));
        SensorSession* second = m_workspace->add(urlOf("127.0.0.2"));
        const QPointer<SensorSession> third = m_workspace->add(urlOf("127.0.0.3"));
        m_workspace->setCurrent(second);
        m_workspace->remove(second);
        QCOMPARE(m_workspace->current(), third.data());
        m_workspace->remove(third);
        QCOMPARE(m_workspace->current(), first);
        lds::support::settle();
        QVERIFY(!third);
        m_workspace->remove(first);
        QCOMPARE(m_workspace->current(), nullptr);
        QVERIFY(m_workspace->sessions().isEmpty());
    }

    void removingASensorClosesIt()
    {
        SensorSession* session = m_workspace->add(urlOf("127.0.0.1"));
        session->open();
        lds::support::settle();
        QVERIFY(m_links.sensor(urlOf("127.0.0.1")).isOpen());
        m_workspace->remove(session);
        lds::support::settle();
        QVERIFY(!m_links.sensor(urlOf("127.0.0.1")).isOpen());
    }

    void aSensorMayBeRemovedFromItsOwnSignal()
    {
        SensorSession* session = m_workspace->add(urlOf("127.0.0.1"));
        connect(session, &SensorSession::heldChanged, this,
                [this, session] { m_workspace->remove(session); });
        session->open();
        lds::support::settle();
        QVERIFY(m_workspace->sessions().isEmpty());
    }

    void editsAndUnsavedSensorsAreCountedOverAll()
    {
        for (const char* host : {"127.0.0.1", "127.0.0.2"})
            m_workspace->add(urlOf(host))->open();
        lds::support::settle();
        m_workspace->sessions().at(0)->edit({{ItemId::DisplayInversion, 1}, {ItemId::Span, 20000}});
        m_workspace->sessions().at(1)->edit({{ItemId::DisplayInversion, 1}});
        QCOMPARE(m_workspace->pendingCount(), 3);
        QCOMPARE(m_workspace->unsavedCount(), 0);
        QVERIFY(m_workspace->sessions().at(0)->apply());
        lds::support::settle();
        QCOMPARE(m_workspace->pendingCount(), 1);
        QCOMPARE(m_workspace->unsavedCount(), 1);
    }

private:
    lds::ports::ManualScheduler m_scheduler;
    lds::support::FakeLinkFactory m_links{m_scheduler};
    std::unique_ptr<Workspace> m_workspace;
};

QTEST_GUILESS_MAIN(WorkspaceTest)
#include "tst_workspace.moc"
