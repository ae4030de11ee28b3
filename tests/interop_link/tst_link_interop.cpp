#include "catalog.h"
#include "frame.h"
#include "modbus_link_factory.h"
#include "register_image.h"

#include <atomic>
#include <memory>
#include <modbus.h>
#include <QProcess>
#include <QTest>

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::LinkState;
using ports::Status;

namespace {

/// Counts what goes out.
class SentCounter final : public ports::FrameLog {
public:
    void record(const ports::Frame& frame) override
    {
        if (frame.direction == ports::Direction::Sent && !frame.bytes.isEmpty())
            ++sent;
    }
    std::atomic<int> sent = 0;
};

QStringList argumentsOf(const RegisterImage& image)
{
    QStringList arguments;
    for (auto it = image.cbegin(); it != image.cend(); ++it)
        arguments.append(QStringLiteral("%1=%2").arg(it.key()).arg(it.value()));
    return arguments;
}

QList<ItemId> everyItem()
{
    QList<ItemId> items;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        items.append(item.id);
    return items;
}

} // namespace

/// The link against Modbus TCP servers of others.
class LinkInteropTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void init();
    void cleanup();
    void readsEverythingInTwoMessages_data() { servers(); }
    void readsEverythingInTwoMessages();
    void writesWhatTheServerThenHolds_data() { servers(); }
    void writesWhatTheServerThenHolds();
    void polls_data() { servers(); }
    void polls();
    void refusalOfTheServerIsARefusal_data() { servers(); }
    void refusalOfTheServerIsARefusal();
    void endOfTheServerIsALostConnection_data() { servers(); }
    void endOfTheServerIsALostConnection();

private:
    void servers();
    void startServer();
    void openLink();
    ports::Outcome run(ports::Request request);
    int heldByServer(int address); ///< Asked for with libmodbus; −1 when it does not answer.

    std::unique_ptr<QProcess> m_server;
    SentCounter m_log;
    std::unique_ptr<modbus::ModbusLinkFactory> m_factory;
    ports::LinkPointer m_link;
    QList<ports::LinkReport> m_reports;
    QList<ports::Outcome> m_outcomes;
    measurement::MeasurementBatch m_samples;
    RegisterImage m_image;
    quint16 m_port = 0;
    ports::RequestId m_nextId = 1;
};

void LinkInteropTest::servers()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<bool>("lowWordFirst");
    const QString libmodbus = QStringLiteral(LDS_LIBMODBUS_SERVER);
    const QString pymodbus = QStringLiteral(LDS_PYMODBUS_SERVER);
    QTest::newRow("libmodbus, low word first") << libmodbus << true;
    QTest::newRow("libmodbus, high word first") << libmodbus << false;
    QTest::newRow("pymodbus, low word first") << pymodbus << true;
    QTest::newRow("pymodbus, high word first") << pymodbus << false;
}

void LinkInteropTest::init()
{
    m_reports.clear();
    m_outcomes.clear();
    m_samples.clear();
    m_log.sent = 0;
    m_factory = std::make_unique<modbus::ModbusLinkFactory>(m_log);
    startServer();
    if (!QTest::currentTestFailed())
        openLink();
}

void LinkInteropTest::cleanup()
{
    m_link.reset();
    m_factory.reset();
    if (m_server) {
        m_server->kill();
        m_server->waitForFinished();
    }
    m_server.reset();
}

void LinkInteropTest::startServer()
{
    QFETCH(QString, program);
    QFETCH(bool, lowWordFirst);
    m_image = factoryImage(lowWordFirst);
    const bool isRefusing = qstrcmp(QTest::currentTestFunction(), "refusalOfTheServerIsARefusal") == 0;
    QStringList arguments = argumentsOf(m_image);
    arguments.prepend(QString::number(isRefusing ? 150 : 200));
    if (program.endsWith(QLatin1String(".py"))) {
        arguments.prepend(program);
        program = QStringLiteral("/usr/bin/python3"); // Where Debian's python3-pymodbus is.
    }
    m_server = std::make_unique<QProcess>();
    m_server->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_server->start(program, arguments);
    QTRY_VERIFY_WITH_TIMEOUT(m_server->canReadLine(), 20'000);
    m_port = m_server->readLine().trimmed().toUShort();
    QVERIFY(m_port != 0);
}

void LinkInteropTest::openLink()
{
    QFETCH(bool, lowWordFirst);
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = m_port;
    m_link = m_factory->create(url);
    connect(m_link.get(), &ports::SensorLink::reported, this,
            [this](const auto& report) { m_reports.append(report); });
    connect(m_link.get(), &ports::SensorLink::finished, this,
            [this](const auto& outcome) { m_outcomes.append(outcome); });
    connect(m_link.get(), &ports::SensorLink::measured, this,
            [this](const auto& batch) { m_samples += batch; });
    m_link->open();
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().state != LinkState::Opening);
    QCOMPARE(m_reports.last().state, LinkState::Open);
    QCOMPARE(m_reports.last().lowWordFirst, lowWordFirst);
    m_log.sent = 0;
}

ports::Outcome LinkInteropTest::run(ports::Request request)
{
    request.id = m_nextId++;
    const qsizetype before = m_outcomes.size();
    m_link->submit(request);
    if (!QTest::qWaitFor([&] { return m_outcomes.size() > before; }))
        return {};
    return m_outcomes.last();
}

int LinkInteropTest::heldByServer(int address)
{
    // libmodbus' server serves one client at a time.
    m_link->close();
    if (!QTest::qWaitFor([this] { return m_reports.last().state == LinkState::Closed; }))
        return -1;
    modbus_t* const client = modbus_new_tcp("127.0.0.1", m_port);
    uint16_t value = 0;
    const bool read = modbus_connect(client) == 0 && modbus_read_registers(client, address, 1, &value) == 1;
    modbus_close(client);
    modbus_free(client);
    return read ? value : -1;
}

void LinkInteropTest::readsEverythingInTwoMessages()
{
    ports::Request request;
    request.items = everyItem();
    const ports::Outcome outcome = run(request);
    QCOMPARE(outcome.status, Status::Done);
    QCOMPARE(m_log.sent.load(), 2);
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        QVERIFY2(outcome.values.contains(item.id) == (item.modbus && item.isReadable()), item.key);
        if (item.role == catalog::Role::Setting && item.modbus)
            QVERIFY2(outcome.values.value(item.id) == item.limits.front().defaultValue, item.key);
    }
    QCOMPARE(outcome.values.value(ItemId::MeasuredValue), -12'345);
    QCOMPARE(outcome.values.value(ItemId::PeakIntensity), 600);
}

void LinkInteropTest::writesWhatTheServerThenHolds()
{
    QFETCH(bool, lowWordFirst);
    const QList<settings::Write> writes{{{ItemId::OutputDelayTimerSetting, 77}},
                                        {{ItemId::HighSetValue, -70'000}},
                                        {{ItemId::IpAddress1stOctet, 10},
                                         {ItemId::IpAddress2ndOctet, 20},
                                         {ItemId::IpAddress3rdOctet, 30},
                                         {ItemId::IpAddress4thOctet, 40}}};
    ports::Request readBack;
    for (const settings::Write& write : writes) {
        ports::Request request;
        request.kind = ports::RequestKind::Write;
        request.write = write;
        QCOMPARE(run(request).status, Status::Done);
        for (const settings::ItemValue& wanted : write)
            readBack.items.append(wanted.item);
    }
    const ports::Outcome outcome = run(readBack);
    QCOMPARE(outcome.status, Status::Done);
    for (const settings::Write& write : writes) {
        for (const settings::ItemValue& wanted : write)
            QCOMPARE(outcome.values.value(wanted.item), wanted.value);
    }
    QCOMPARE(m_log.sent.load(), 4);
    // And what another client finds: −70,000 = FFFE EE90; 400155 is the 4th octet (§5.2.4).
    QCOMPARE(heldByServer(400123 - 400001), 77);
    QCOMPARE(heldByServer((lowWordFirst ? 400101 : 400102) - 400001), 0xee90);
    QCOMPARE(heldByServer((lowWordFirst ? 400102 : 400101) - 400001), 0xfffe);
    QCOMPARE(heldByServer(400155 - 400001), 40);
    QCOMPARE(heldByServer(400158 - 400001), 10);
}

void LinkInteropTest::polls()
{
    m_link->poll(5);
    QTRY_VERIFY(m_samples.size() >= 10);
    m_link->poll(0);
    for (const measurement::Measurement& sample : m_samples) {
        QCOMPARE(sample.value, -12'345);
        QCOMPARE(sample.kind, measurement::ValueKind::Valid);
        QCOMPARE(sample.state, quint16(measurement::LaserBit | measurement::GoBit));
        QCOMPARE(sample.intensity, quint16(600));
    }
}

void LinkInteropTest::refusalOfTheServerIsARefusal()
{
    // The servers hold 150 registers in this test's place of 200: what lies beyond is no address (02).
    ports::Request request;
    request.items = {ItemId::CommunicationSpeed}; // 400167
    const ports::Outcome read = run(request);
    QCOMPARE(read.status, Status::Refused);
    QCOMPARE(read.failure.code, ports::FailureCode::AddressRefused);
    QCOMPARE(read.failure.wireCode, 2);
    request.kind = ports::RequestKind::Write;
    request.write = {{ItemId::CommunicationSpeed, 1}};
    const ports::Outcome written = run(request);
    QCOMPARE(written.status, Status::Refused);
    QCOMPARE(written.failure.code, ports::FailureCode::AddressRefused);
}

void LinkInteropTest::endOfTheServerIsALostConnection()
{
    m_link->poll(5);
    QTRY_VERIFY(!m_samples.isEmpty());
    m_server->kill();
    QTRY_COMPARE(m_reports.last().state, LinkState::Failed);
    QCOMPARE(m_reports.last().failure, ports::OpenFailure::Lost);
    // A dying process may close its connection before its listener.
    QTRY_COMPARE(m_server->state(), QProcess::NotRunning);
    m_link->open();
    QTRY_COMPARE(m_reports.last().state, LinkState::Failed);
    QTRY_COMPARE(m_reports.last().failure, ports::OpenFailure::Refused);
}

QTEST_GUILESS_MAIN(LinkInteropTest)
#include "tst_link_interop.moc"
