#include "catalog.h"
#include "frame.h"
#include "modbus_link_factory.h"
#include "register_image.h"

#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <pty.h>
#include <QProcess>
#include <QTest>
#include <QThread>
#include <termios.h>
#include <unistd.h>

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::LinkState;
using ports::Status;

namespace {

class NoLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override {}
};

/// Two pseudo-terminals with a wire between them, so that each program has a port of its own.
class SerialPair final : public QThread {
public:
    SerialPair()
    {
        for (int end = 0; end < 2; ++end) {
            int port = -1;
            termios raw = {};
            cfmakeraw(&raw);
            cfsetspeed(&raw, B4800);
            char name[64] = {};
            if (openpty(&m_masters[end], &port, name, &raw, nullptr) != 0)
                qFatal("no pseudo-terminal");
            m_kept[end] = port; // So that a port nobody uses is not a hung-up one.
            m_names[end] = QString::fromLocal8Bit(name);
        }
        start();
    }
    ~SerialPair() override
    {
        requestInterruption();
        wait();
        for (int end = 0; end < 2; ++end) {
            ::close(m_masters[end]);
            ::close(m_kept[end]);
        }
    }
    QString name(int end) const { return m_names[end]; }

protected:
    void run() override
    {
        while (!isInterruptionRequested()) {
            pollfd ends[2] = {{m_masters[0], POLLIN, 0}, {m_masters[1], POLLIN, 0}};
            if (::poll(ends, 2, 20) <= 0)
                continue;
            for (int end = 0; end < 2; ++end) {
                char bytes[512];
                const auto size =
                    (ends[end].revents & POLLIN) != 0 ? ::read(m_masters[end], bytes, sizeof bytes) : 0;
                if (size > 0 && ::write(m_masters[1 - end], bytes, std::size_t(size)) != size)
                    return;
            }
        }
    }

private:
    int m_masters[2] = {-1, -1};
    int m_kept[2] = {-1, -1};
    QString m_names[2];
};

} // namespace

/// The link against a Modbus RTU server of others.
class RtuLinkInteropTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void init();
    void cleanup();
    void readsWritesAndPollsAtEverySetting_data();
    void readsWritesAndPollsAtEverySetting();
    void refusalOfTheServerIsARefusal();
    void otherUnitIsSilent();

private:
    void openLink(int unit = 17);
    void startServer(int registers, const ports::SerialSettings& settings);
    ports::Outcome run(ports::Request request);

    std::unique_ptr<SerialPair> m_pair;
    std::unique_ptr<QProcess> m_server;
    NoLog m_log;
    std::unique_ptr<modbus::ModbusLinkFactory> m_factory;
    ports::LinkPointer m_link;
    ports::SerialSettings m_settings;
    QList<ports::LinkReport> m_reports;
    QList<ports::Outcome> m_outcomes;
    measurement::MeasurementBatch m_samples;
    ports::RequestId m_nextId = 1;
};

void RtuLinkInteropTest::init()
{
    m_reports.clear();
    m_outcomes.clear();
    m_samples.clear();
    m_pair = std::make_unique<SerialPair>();
    m_factory = std::make_unique<modbus::ModbusLinkFactory>(m_log);
}

void RtuLinkInteropTest::cleanup()
{
    m_link.reset();
    m_factory.reset();
    if (m_server) {
        m_server->kill();
        m_server->waitForFinished();
    }
    m_server.reset();
    m_pair.reset();
}

void RtuLinkInteropTest::startServer(int registers, const ports::SerialSettings& settings)
{
    m_settings = settings;
    const char parity = settings.parity == ports::SerialParity::None   ? 'N'
                        : settings.parity == ports::SerialParity::Even ? 'E'
                                                                       : 'O';
    QStringList arguments{m_pair->name(1), QString::number(settings.baud), QString(QLatin1Char(parity)),
                          QStringLiteral("17"), QString::number(registers)};
    const RegisterImage image = factoryImage(true);
    for (auto it = image.cbegin(); it != image.cend(); ++it)
        arguments.append(QStringLiteral("%1=%2").arg(it.key()).arg(it.value()));
    m_server = std::make_unique<QProcess>();
    m_server->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_server->start(QStringLiteral(LDS_LIBMODBUS_RTU_SERVER), arguments);
    QTRY_VERIFY_WITH_TIMEOUT(m_server->canReadLine(), 20'000);
}

void RtuLinkInteropTest::openLink(int unit)
{
    ports::ConnectionUrl url;
    url.protocol = ports::Protocol::ModbusRtu;
    url.host = m_pair->name(0);
    url.serial = m_settings;
    url.unit = quint8(unit);
    m_link = m_factory->create(url);
    connect(m_link.get(), &ports::SensorLink::reported, this,
            [this](const auto& report) { m_reports.append(report); });
    connect(m_link.get(), &ports::SensorLink::finished, this,
            [this](const auto& outcome) { m_outcomes.append(outcome); });
    connect(m_link.get(), &ports::SensorLink::measured, this,
            [this](const auto& batch) { m_samples += batch; });
    m_link->open();
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().state != LinkState::Opening);
}

ports::Outcome RtuLinkInteropTest::run(ports::Request request)
{
    request.id = m_nextId++;
    const qsizetype before = m_outcomes.size();
    m_link->submit(request);
    if (!QTest::qWaitFor([&] { return m_outcomes.size() > before; }))
        return {};
    return m_outcomes.last();
}

void RtuLinkInteropTest::readsWritesAndPollsAtEverySetting_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("parity");
    for (const int baud : {9600, 19'200, 38'400, 115'200, 230'400}) {
        for (int parity = 0; parity < 3; ++parity)
            QTest::addRow("%d bps, parity %d", baud, parity) << baud << parity;
    }
}

void RtuLinkInteropTest::readsWritesAndPollsAtEverySetting()
{
    QFETCH(int, baud);
    QFETCH(int, parity);
    startServer(200, {baud, ports::SerialParity(parity)});
    openLink();
    QCOMPARE(m_reports.last().state, LinkState::Open);
    ports::Request request;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        request.items.append(item.id);
    const ports::Outcome all = run(request);
    QCOMPARE(all.status, Status::Done);
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.role == catalog::Role::Setting && item.modbus)
            QVERIFY2(all.values.value(item.id) == item.limits.front().defaultValue, item.key);
    }
    QCOMPARE(all.values.value(ItemId::MeasuredValue), -12'345);

    ports::Request write;
    write.kind = ports::RequestKind::Write;
    write.write = {{ItemId::OutputDelayTimerSetting, 77}}; // Function 06
    QCOMPARE(run(write).status, Status::Done);
    write.write = {{ItemId::HighSetValue, -70'000}}; // Function 10h
    QCOMPARE(run(write).status, Status::Done);
    request.items = {ItemId::OutputDelayTimerSetting, ItemId::HighSetValue};
    const ports::Outcome back = run(request);
    QCOMPARE(back.values.value(ItemId::OutputDelayTimerSetting), 77);
    QCOMPARE(back.values.value(ItemId::HighSetValue), -70'000);

    m_link->poll(5);
    QTRY_VERIFY(m_samples.size() >= 10);
    for (const measurement::Measurement& sample : m_samples)
        QCOMPARE(sample.value, -12'345);
}

void RtuLinkInteropTest::refusalOfTheServerIsARefusal()
{
    startServer(150, {});
    openLink();
    QCOMPARE(m_reports.last().state, LinkState::Open);
    ports::Request request;
    request.items = {ItemId::CommunicationSpeed}; // 400167
    const ports::Outcome read = run(request);
    QCOMPARE(read.status, Status::Refused);
    QCOMPARE(read.failure.code, ports::FailureCode::AddressRefused);
}

void RtuLinkInteropTest::otherUnitIsSilent()
{
    startServer(200, {});
    openLink(18);
    QCOMPARE(m_reports.last().state, LinkState::Failed);
    QCOMPARE(m_reports.last().failure, ports::OpenFailure::NoAnswer);
}

QTEST_GUILESS_MAIN(RtuLinkInteropTest)
#include "tst_rtu_link_interop.moc"
