// The poll of the link against the same read by libmodbus, on one lds-emulator: one request at a time,
// the next as soon as the last is answered. Both rates and their ratio come from one run.

#include "emulator_process.h"
#include "frame.h"
#include "item_registers.h"
#include "manual_scheduler.h"
#include "modbus_link.h"
#include "modbus_link_factory.h"
#include "tcp_connection.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <modbus.h>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QModbusReply>
#include <QModbusTcpClient>
#include <QTimer>
#include <vector>

using namespace lds;

namespace {

constexpr int rounds = 7;
constexpr int pollsPerRound = 10'000;

/// The link decodes every message for the log, as it does for the messages page; this one keeps nothing.
class CountingLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override { ++m_frames; }

private:
    std::atomic<qint64> m_frames = 0;
};

ports::ConnectionUrl urlOf(quint16 port)
{
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = port;
    return url;
}

/// What a number of polls took; the processor's time tells more than the clock on a busy machine.
struct Cost {
    double perSecond = 0; ///< 0 when a poll was not answered.
    double processorUs = 0;
};

class Stopwatch {
public:
    Stopwatch() { m_timer.start(); }
    Cost cost(int polls) const
    {
        const double processorUs = double(std::clock() - m_processor) * 1e6 / CLOCKS_PER_SEC;
        return {polls * 1e9 / double(m_timer.nsecsElapsed()), processorUs / polls};
    }

private:
    QElapsedTimer m_timer;
    std::clock_t m_processor = std::clock();
};

double median(std::vector<double> figures)
{
    std::ranges::sort(figures);
    return figures.at(figures.size() / 2);
}

Cost median(const std::vector<Cost>& costs)
{
    std::vector<double> rates;
    std::vector<double> times;
    for (const Cost& cost : costs) {
        rates.push_back(cost.perSecond);
        times.push_back(cost.processorUs);
    }
    return {median(rates), median(times)};
}

/// Runs the event loop as a program does, until the condition holds after some event.
template <typename Condition>
bool runUntil(const Condition& condition, int mostMs)
{
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        if (timer.elapsed() > mostMs)
            return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

Cost libmodbusCost(modbus_t* client)
{
    const modbus::RegisterRange range = modbus::measurementRange();
    uint16_t registers[modbus::maximumReadRegisters];
    const Stopwatch watch;
    for (int poll = 0; poll < pollsPerRound; ++poll) {
        if (modbus_read_registers(client, range.first, range.count, registers) != range.count)
            return {};
    }
    return watch.cost(pollsPerRound);
}

/// The same with a bare QModbusTcpClient, on which the link stands.
Cost qmodbusCost(QModbusTcpClient& client)
{
    const modbus::RegisterRange range = modbus::measurementRange();
    const QModbusRequest request(QModbusPdu::ReadHoldingRegisters, range.first, range.count);
    int polls = 0;
    const std::function<void()> poll = [&] {
        QModbusReply* const reply = client.sendRawRequest(request, 1);
        QObject::connect(reply, &QModbusReply::finished, reply, [&, reply] {
            reply->deleteLater();
            if (reply->error() == QModbusDevice::NoError && ++polls < pollsPerRound)
                poll();
        });
    };
    const Stopwatch watch;
    poll();
    return runUntil([&] { return polls >= pollsPerRound; }, 60'000) ? watch.cost(polls) : Cost();
}

/// The link on a clock that jumps to the next tick with each measurement.
class EagerLink {
public:
    explicit EagerLink(quint16 port)
    {
        auto scheduler = std::make_unique<ports::ManualScheduler>();
        m_clock = scheduler.get();
        m_link = std::make_unique<modbus::ModbusLink>(urlOf(port), std::move(scheduler), m_log,
                                                      modbus::TcpConnection::maker());
        QObject::connect(
            m_link.get(), &ports::SensorLink::reported, m_link.get(),
            [this](const ports::LinkReport& report) { m_open = report.state == ports::LinkState::Open; });
        QObject::connect(m_link.get(), &ports::SensorLink::measured, m_link.get(),
                         [this](const measurement::MeasurementBatch& batch) {
                             m_polls += int(batch.size());
                             if (m_polls < pollsPerRound)
                                 m_clock->advanceMs(intervalMs);
                         });
    }

    bool open()
    {
        m_link->open();
        return runUntil([this] { return m_open; }, 5000);
    }

    Cost cost()
    {
        m_polls = 0;
        m_link->poll(intervalMs);
        QCoreApplication::processEvents();
        const Stopwatch watch;
        m_clock->advanceMs(0);
        const bool done = runUntil([this] { return m_polls >= pollsPerRound; }, 60'000);
        const Cost cost = done ? watch.cost(m_polls) : Cost();
        m_link->poll(0);
        QCoreApplication::processEvents();
        return cost;
    }

private:
    static constexpr int intervalMs = 5; ///< The shortest at which each poll is handed over by itself.
    QTimer m_heartbeat;
    CountingLog m_log;
    ports::ManualScheduler* m_clock = nullptr;
    std::unique_ptr<modbus::ModbusLink> m_link;
    bool m_open = false;
    int m_polls = 0;
};

/// As the programs use it: the link in its own thread, on the real clock. False when it does not open.
bool printPacedPolls(quint16 port, int intervalMs)
{
    constexpr int seconds = 2;
    CountingLog log;
    modbus::ModbusLinkFactory factory(log);
    const ports::LinkPointer link = factory.create(urlOf(port));
    QObject here;
    bool open = false;
    std::vector<qint64> stamps;
    ports::PollStatistics statistics;
    QObject::connect(link.get(), &ports::SensorLink::reported, &here,
                     [&](const ports::LinkReport& report) { open = report.state == ports::LinkState::Open; });
    QObject::connect(link.get(), &ports::SensorLink::measured, &here,
                     [&](const measurement::MeasurementBatch& batch, const ports::PollStatistics& polls) {
                         for (const measurement::Measurement& sample : batch)
                             stamps.push_back(sample.monotonicNs);
                         statistics = polls;
                     });
    link->open();
    if (!runUntil([&] { return open; }, 5000))
        return false;
    link->poll(intervalMs);
    const auto wanted = std::size_t(seconds * 1000 / intervalMs);
    runUntil([&] { return stamps.size() >= wanted; }, 2000 * seconds);
    if (stamps.size() < 2)
        return false;
    std::vector<double> gaps;
    for (std::size_t i = 1; i < stamps.size(); ++i)
        gaps.push_back(double(stamps[i] - stamps[i - 1]) / 1e6);
    std::ranges::sort(gaps);
    const double spanS = double(stamps.back() - stamps.front()) / 1e9;
    std::printf(
        "  every %2d ms: %7.1f/s of %4d asked for, %llu ticks dropped; apart: median %.2f ms, 99%% %.2f ms\n",
        intervalMs, double(stamps.size() - 1) / spanS, 1000 / intervalMs,
        static_cast<unsigned long long>(statistics.dropped), median(gaps), gaps.at(gaps.size() * 99 / 100));
    return true;
}

void print(const char* who, const Cost& cost)
{
    std::printf("  %-17s %8.0f/s %8.1f us of processor each\n", who, cost.perSecond, cost.processorUs);
}

int fail(const char* what)
{
    std::fprintf(stderr, "bench_poll_loop: %s\n", what);
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    ports::registerMetaTypes();
    if (!qEnvironmentVariableIsSet("LDS_BIN"))
        qputenv("LDS_BIN", LDS_BIN_FOLDER);
    const test::EmulatorProcess emulator({QStringLiteral("--sensor"), QStringLiteral("HL-G203B-S-MK"),
                                          QStringLiteral("--modbus-port"), QStringLiteral("0")});
    const quint16 port = emulator.modbusPort();
    if (port == 0)
        return fail("lds-emulator did not start");
    modbus_t* const client = modbus_new_tcp("127.0.0.1", port);
    QModbusTcpClient qmodbus;
    qmodbus.setConnectionParameter(QModbusDevice::NetworkAddressParameter, QStringLiteral("127.0.0.1"));
    qmodbus.setConnectionParameter(QModbusDevice::NetworkPortParameter, port);
    qmodbus.connectDevice();
    EagerLink link(port);
    if (modbus_connect(client) != 0 || !link.open() ||
        !runUntil([&] { return qmodbus.state() == QModbusDevice::ConnectedState; }, 5000))
        return fail("no connection to lds-emulator");

    std::vector<Cost> ofLibmodbus;
    std::vector<Cost> ofQmodbus;
    std::vector<Cost> ofLink;
    for (int round = 0; round < rounds; ++round) { // In turn, so that both meet the same machine.
        ofLibmodbus.push_back(libmodbusCost(client));
        ofQmodbus.push_back(qmodbusCost(qmodbus));
        ofLink.push_back(link.cost());
    }
    modbus_close(client);
    modbus_free(client);
    for (const auto& costs : {ofLibmodbus, ofQmodbus, ofLink}) {
        if (std::ranges::min(costs, {}, &Cost::perSecond).perSecond <= 0)
            return fail("a poll was not answered");
    }
    std::printf("poll of 12 registers, one at a time, median of %d rounds of %d\n", rounds, pollsPerRound);
    print("libmodbus", median(ofLibmodbus));
    print("QModbusTcpClient", median(ofQmodbus));
    print("link", median(ofLink));
    std::printf("  link : libmodbus = %.2f\n", median(ofLink).perSecond / median(ofLibmodbus).perSecond);
    std::printf("paced, in the I/O thread\n");
    return printPacedPolls(port, 10) && printPacedPolls(port, 1) ? 0 : fail("the link did not poll");
}
