// Sixteen units polled over one serial line at each of the five speeds, on a pseudo-terminal whose server
// keeps the time of a real line: 11 bits a character, the silence after a request, the sensor's answering
// time.
//
//     bench_rtu_bus [ANSWERING_MS…]      default: 0 and 1
//
// Prints what the links reach against what the line allows, from one run, and what QModbus adds to the
// silence in front of a request. Ends with 1 when a speed stays below 90 %.

#include "frame.h"
#include "item_registers.h"
#include "modbus_link_factory.h"
#include "modbus_rtu_framing.h"
#include "serial_choices.h"
#include "serial_timing.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <set>
#include <sys/prctl.h>
#include <termios.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace lds;

namespace {

constexpr int units = 16;
constexpr int warmUpMs = 1500;
constexpr int leastPercent = 90;

class NoLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override {}
};

qint64 nowNs()
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void sleepUntil(qint64 ns)
{
    timespec until = {};
    until.tv_sec = ns / 1'000'000'000;
    until.tv_nsec = ns % 1'000'000'000;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
}

/// All units of a line, in a thread of their own.
class TimedLine {
public:
    TimedLine(const ports::SerialSettings& settings, qint64 answeringNs)
        : m_rate(modbus::rateOf(settings))
        , m_answeringNs(answeringNs)
    {
        int port = -1;
        termios raw = {};
        cfmakeraw(&raw);
        cfsetspeed(&raw, B4800);
        char name[64] = {};
        if (openpty(&m_master, &port, name, &raw, nullptr) != 0)
            return;
        close(port);
        m_port = QString::fromLocal8Bit(name);
        m_thread = std::thread([this] { serve(); });
    }
    ~TimedLine()
    {
        m_ending = true;
        if (m_thread.joinable())
            m_thread.join();
        close(m_master);
    }
    TimedLine(const TimedLine&) = delete;
    TimedLine& operator=(const TimedLine&) = delete;

    const QString& port() const { return m_port; }
    int tooEarly() const { return m_tooEarly; } ///< Requests that came before the silence was over.

private:
    void serve()
    {
        prctl(PR_SET_TIMERSLACK, 1UL);
        QByteArray received;
        qint64 startNs = 0;
        while (!m_ending) {
            pollfd waiting = {m_master, POLLIN, 0};
            if (::poll(&waiting, 1, 50) <= 0)
                continue;
            char bytes[256];
            const auto size = ::read(m_master, bytes, sizeof bytes);
            if (size <= 0) { // Nobody has it open yet.
                sleepUntil(nowNs() + 5'000'000);
                continue;
            }
            if (received.isEmpty())
                startNs = nowNs();
            received.append(bytes, size);
            const auto request = modbus::decodeRtuFrame(received);
            if (!request)
                continue;
            if (startNs - m_lastEndNs < modbus::frameSilenceNs(m_rate))
                ++m_tooEarly;
            answer(*request, startNs + modbus::charactersNs(m_rate, received.size()));
            received.clear();
        }
    }

    /// The bytes arrive when the last of them would.
    void answer(const modbus::RtuFrame& frame, qint64 requestEndNs)
    {
        const auto request = modbus::decodeRequest(frame.pdu);
        if (!request)
            return;
        modbus::Response response;
        response.function = request->function;
        response.address = request->address;
        response.count = request->count;
        for (int i = 0; i < request->count; ++i) {
            response.registers.append(request->address + i == 115 ? 10'000 : 0); // Span
            response.coils.append(false);
        }
        const QByteArray bytes = modbus::encodeRtuFrame(frame.unit, modbus::encodeResponse(response));
        const qint64 endNs = requestEndNs + modbus::frameSilenceNs(m_rate) + m_answeringNs +
                             modbus::charactersNs(m_rate, bytes.size());
        sleepUntil(endNs);
        m_lastEndNs = endNs;
        if (::write(m_master, bytes.constData(), std::size_t(bytes.size())) != bytes.size())
            m_ending = true;
    }

    const modbus::RtuRate m_rate;
    const qint64 m_answeringNs;
    int m_master = -1;
    QString m_port;
    qint64 m_lastEndNs = 0;
    std::atomic<bool> m_ending = false;
    std::atomic<int> m_tooEarly = 0;
    std::thread m_thread;
};

template <typename Condition>
bool runUntil(const Condition& condition, int mostMs)
{
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        if (timer.elapsed() > mostMs)
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

struct Result {
    double perSecond = 0;     ///< Of all units together; 0 when it went wrong.
    double mostOverLeast = 0; ///< Polls of the unit that got most over those of the one that got least.
    quint64 lost = 0;
};

Result pollAll(const TimedLine& line, const ports::SerialSettings& settings, int measureMs)
{
    NoLog log;
    modbus::ModbusLinkFactory factory(log);
    QObject here;
    std::vector<ports::LinkPointer> links;
    std::vector<int> polls(units);
    std::vector<quint64> lost(units);
    std::set<int> open;
    qint64 firstNs = 0;
    qint64 lastNs = 0;
    int counted = 0;
    bool counting = false;
    for (int unit = 0; unit < units; ++unit) {
        ports::ConnectionUrl url;
        url.protocol = ports::Protocol::ModbusRtu;
        url.host = line.port();
        url.serial = settings;
        url.unit = quint8(unit + 1);
        links.push_back(factory.create(url));
        ports::SensorLink* const link = links.back().get();
        QObject::connect(link, &ports::SensorLink::reported, &here,
                         [&open, unit](const ports::LinkReport& report) {
                             if (report.state == ports::LinkState::Open)
                                 open.insert(unit);
                         });
        QObject::connect(
            link, &ports::SensorLink::measured, &here,
            [&, unit](const measurement::MeasurementBatch& batch, const ports::PollStatistics& all) {
                lost[std::size_t(unit)] = all.lost;
                if (!counting)
                    return;
                for (const measurement::Measurement& sample : batch) {
                    firstNs = firstNs == 0 ? sample.monotonicNs : qMin(firstNs, sample.monotonicNs);
                    lastNs = qMax(lastNs, sample.monotonicNs);
                    ++polls[std::size_t(unit)];
                    ++counted;
                }
            });
        link->open();
    }
    if (!runUntil([&] { return open.size() == units; }, 20'000))
        return {};
    for (const auto& link : links)
        link->poll(10); // As a session does.
    runUntil([] { return false; }, warmUpMs);
    counting = true;
    runUntil([] { return false; }, measureMs);
    const auto [least, most] = std::ranges::minmax(polls);
    if (least == 0 || lastNs <= firstNs)
        return {};
    Result result{double(counted - 1) * 1e9 / double(lastNs - firstNs), double(most) / least, 0};
    for (const quint64 polled : lost)
        result.lost += polled;
    return result;
}

/// What QModbusRtuSerialClient waits in front of a request: whole milliseconds, and never less than two.
double qmodbusSilenceMs(const ports::SerialSettings& settings)
{
    return settings.baud < 19'200 ? std::ceil(3500.0 * 11 / settings.baud) : 2;
}

/// False when the target is missed.
bool bench(double answeringMs)
{
    const modbus::Request poll = modbus::readRequest(modbus::measurementRange());
    std::printf("%d units, answering time %.1f ms; a poll is %d + %d characters\n", units, answeringMs,
                modbus::requestBytes(poll), modbus::answerBytes(poll));
    std::printf(
        "     bps  line allows    reached   share   per poll over the line's   of it QModbus's silence   "
        "most:least  lost  early\n");
    bool good = true;
    for (const int baud : ports::serialSpeeds()) {
        const ports::SerialSettings settings{baud, ports::SerialParity::Even};
        const auto answeringNs = qint64(answeringMs * 1e6);
        const double lineMs = double(modbus::shortestExchangeNs(settings, poll, answeringNs)) / 1e6;
        const double floorMs =
            qmodbusSilenceMs(settings) - double(modbus::frameSilenceNs(modbus::rateOf(settings))) / 1e6;
        const TimedLine line(settings, answeringNs);
        const int measureMs = baud < 38'400 ? 5000 : 3000;
        const Result result = pollAll(line, settings, measureMs);
        const double share = result.perSecond * lineMs / 10;
        std::printf("%8d %9.1f/s %9.1f/s  %5.1f %%  %19.3f ms  %12.3f ms = %4.1f %%  %11.2f  %4llu  %5d\n",
                    baud, 1000 / lineMs, result.perSecond, share,
                    result.perSecond > 0 ? 1000 / result.perSecond - lineMs : 0.0, floorMs,
                    100 * floorMs / (lineMs + floorMs), result.mostOverLeast,
                    static_cast<unsigned long long>(result.lost), line.tooEarly());
        std::fflush(stdout);
        good = good && share >= leastPercent;
    }
    return good;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    ports::registerMetaTypes();
    std::vector<double> answering;
    for (int i = 1; i < argc; ++i)
        answering.push_back(QByteArray(argv[i]).toDouble());
    if (answering.empty())
        answering = {0, 1};
    bool good = true;
    for (const double ms : answering)
        good = bench(ms) && good;
    return good ? 0 : 1;
}
