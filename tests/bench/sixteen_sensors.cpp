// Sixteen virtual sensors on 127.0.0.1 … 127.0.0.16 in one lds-emulator, each polled 100 times a second
// over Modbus TCP by this one process. A poll is missed when its answer comes after the next tick.

#include "catalog.h"
#include "emulator_process.h"
#include "modbus_tcp_framing.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstdio>
#include <ctime>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <optional>
#include <poll.h>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

using namespace lds;
using namespace Qt::StringLiterals;
using catalog::ItemId;

namespace {

constexpr int sensorCount = 16;
constexpr qint64 intervalNs = 10'000'000; ///< 100 Hz
constexpr qint64 phaseNs = 5'000'000'000; ///< One setting of the sampling cycle.
constexpr qint64 patienceNs = 2'000'000'000;
constexpr double quietShare = 0.2; ///< Of the machine, used by others.

qint64 nowNs()
{
    timespec now = {};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

QByteArray request(quint8 function, quint16 address, quint16 value)
{
    QByteArray pdu(1, char(function));
    for (const quint16 word : {address, value})
        pdu += QByteArray{} + char(word >> 8) + char(word & 0xff);
    return modbus::encodeFrame(1, 1, pdu);
}

/// One connection to one sensor.
class Client {
public:
    Client(int number, quint16 port)
        : m_socket(::socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK - 1 + quint32(number));
        const int on = 1;
        ::setsockopt(m_socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        m_connected = ::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~Client() { ::close(m_socket); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool isConnected() const { return m_connected; }
    int socket() const { return m_socket; }
    void send(const QByteArray& message)
    {
        m_received.clear();
        m_connected = ::send(m_socket, message.constData(), std::size_t(message.size()), MSG_NOSIGNAL) ==
                          message.size() &&
                      m_connected;
    }
    /// True when the whole answer is there.
    bool receive()
    {
        std::array<char, 512> bytes;
        const ssize_t count = ::recv(m_socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count == 0)
            m_connected = false;
        if (count > 0)
            m_received.append(bytes.data(), count);
        return m_received.size() >= modbus::headerSize &&
               m_received.size() == 6 + modbus::decodeHeader(m_received).length;
    }
    /// Not an exception.
    bool answeredWell() const { return (quint8(m_received.at(modbus::headerSize)) & 0x80) == 0; }

private:
    int m_socket;
    bool m_connected = false;
    QByteArray m_received;
};

/// The processor's time of a process or of the whole machine, in ticks.
struct Ticks {
    qint64 ofProcess = 0;
    qint64 busy = 0;
    qint64 all = 0;
};

qint64 processTicks(qint64 process)
{
    QFile file(u"/proc/%1/stat"_s.arg(process));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    const QByteArray text = file.readAll();
    const auto fields = text.mid(text.lastIndexOf(')') + 2).split(' '); // from the third field on
    return fields.value(11).toLongLong() + fields.value(12).toLongLong();
}

Ticks ticks(qint64 process)
{
    Ticks ticks{processTicks(process), 0, 0};
    QFile file(u"/proc/stat"_s);
    if (!file.open(QIODevice::ReadOnly))
        return ticks;
    const auto fields = file.readLine().simplified().split(' ');
    for (qsizetype i = 1; i < std::min<qsizetype>(fields.size(), 9); ++i) {
        ticks.all += fields.at(i).toLongLong();
        if (i != 4 && i != 5) // idle, waiting
            ticks.busy += fields.at(i).toLongLong();
    }
    return ticks;
}

QByteArray loadAverage()
{
    QFile file(u"/proc/loadavg"_s);
    return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(0) : QByteArray("?");
}

struct Polled {
    qint64 due = 0;
    qint64 inTime = 0;
    qint64 wrong = 0;
    std::vector<double> latencies; ///< ms
    qint64 latestTickNs = 0;       ///< How late this process itself came to a tick.
    qint64 askedTooLate = 0;       ///< Polls that this process could not even ask before the next tick.
    bool broken = false;
};

class Poller {
public:
    explicit Poller(std::vector<std::unique_ptr<Client>>& clients)
        : m_clients(clients)
    {}

    /// All at the interval, one after the other within it.
    Polled run(qint64 durationNs)
    {
        const qint64 begin = nowNs();
        for (int i = 0; i < sensorCount; ++i)
            m_states[std::size_t(i)] = {begin + i * intervalNs / sensorCount, std::nullopt};
        const qint64 end = begin + durationNs;
        while (!m_polled.broken && nowNs() < end)
            turn(end);
        finish();
        return m_polled;
    }

private:
    struct State {
        qint64 nextNs = 0;
        std::optional<qint64> askedNs; ///< Not answered yet.
    };

    void turn(qint64 end)
    {
        qint64 next = end;
        for (std::size_t i = 0; i < m_states.size(); ++i) {
            if (nowNs() >= m_states[i].nextNs)
                tick(i);
            next = std::min(next, m_states[i].nextNs);
        }
        waitUntil(next);
    }

    void tick(std::size_t index)
    {
        State& state = m_states[index];
        const qint64 due = state.nextNs;
        const qint64 lateNs = nowNs() - due;
        state.nextNs += intervalNs;
        ++m_polled.due;
        m_polled.latestTickNs = std::max(m_polled.latestTickNs, lateNs);
        m_polled.askedTooLate += lateNs >= intervalNs ? 1 : 0;
        if (state.askedNs)
            return; // not answered yet: that one is missed, and this one cannot be asked
        m_clients[index]->send(m_request);
        state.askedNs = due;
    }

    void waitUntil(qint64 untilNs)
    {
        std::array<pollfd, sensorCount> sockets = {};
        for (std::size_t i = 0; i < sockets.size(); ++i)
            sockets[i] = {m_clients[i]->socket(), POLLIN, 0};
        const qint64 left = std::max<qint64>(0, untilNs - nowNs());
        const timespec timeout{time_t(left / 1'000'000'000), long(left % 1'000'000'000)};
        ::ppoll(sockets.data(), sockets.size(), &timeout, nullptr);
        for (std::size_t i = 0; i < sockets.size(); ++i) {
            if (sockets[i].revents != 0)
                take(i);
        }
    }

    void take(std::size_t index)
    {
        Client& client = *m_clients[index];
        State& state = m_states[index];
        const bool whole = client.receive();
        m_polled.broken = m_polled.broken || !client.isConnected();
        if (!whole || !state.askedNs)
            return;
        const qint64 latency = nowNs() - *state.askedNs; // from the tick, not from the sending
        state.askedNs.reset();
        if (!client.answeredWell())
            ++m_polled.wrong;
        else if (latency < intervalNs)
            ++m_polled.inTime;
        m_polled.latencies.push_back(double(latency) / 1e6);
    }

    /// Takes the last answers, so that the next phase begins without any.
    void finish()
    {
        const qint64 end = nowNs() + patienceNs;
        const auto asked = [](const State& state) { return state.askedNs.has_value(); };
        while (!m_polled.broken && std::ranges::any_of(m_states, asked) && nowNs() < end)
            waitUntil(end);
    }

    std::vector<std::unique_ptr<Client>>& m_clients;
    const QByteArray m_request =
        request(3, catalog::hlG2(ItemId::SensorState).modbus->address(), 12); // state, value, intensity
    std::array<State, sensorCount> m_states;
    Polled m_polled;
};

/// Every sensor at this code of the sampling cycle.
bool setSamplingCycle(std::vector<std::unique_ptr<Client>>& clients, quint16 code)
{
    const QByteArray message = request(6, catalog::hlG2(ItemId::SamplingFrequency).modbus->address(), code);
    for (const auto& client : clients) {
        client->send(message);
        const qint64 end = nowNs() + patienceNs;
        bool answered = false;
        while (!answered && client->isConnected() && nowNs() < end) {
            pollfd socket{client->socket(), POLLIN, 0};
            ::poll(&socket, 1, 100);
            answered = client->receive();
        }
        if (!answered || !client->answeredWell())
            return false;
    }
    return true;
}

/// False when a poll was missed although the machine was quiet.
bool print(const char* what, Polled polled, const Ticks& before, const Ticks& after, double seconds)
{
    std::ranges::sort(polled.latencies);
    const auto& sorted = polled.latencies;
    const double ticksPerSecond = double(::sysconf(_SC_CLK_TCK));
    const double own = double(after.ofProcess - before.ofProcess);
    const double all = double(after.all - before.all);
    const double others = std::max(0.0, double(after.busy - before.busy) - own) / std::max(1.0, all);
    const qint64 missed = polled.due - polled.inTime;
    std::printf("  %-14s %6lld polls due, %6lld answered in time, %lld missed (%lld with an error)\n", what,
                static_cast<long long>(polled.due), static_cast<long long>(polled.inTime),
                static_cast<long long>(missed), static_cast<long long>(polled.wrong));
    std::printf("  %-14s latency: median %.2f ms, 99 %% %.2f ms, worst %.2f ms\n", "",
                sorted.empty() ? 0 : sorted.at(sorted.size() / 2),
                sorted.empty() ? 0 : sorted.at(sorted.size() * 99 / 100), sorted.empty() ? 0 : sorted.back());
    std::printf(
        "  %-14s this process itself: at most %.2f ms late, %lld polls not asked before the next tick\n", "",
        double(polled.latestTickNs) / 1e6, static_cast<long long>(polled.askedTooLate));
    std::printf("  %-14s lds-emulator: %.1f %% of one core; others: %.0f %% of the machine, load %s\n", "",
                100 * own / ticksPerSecond / seconds, 100 * others, loadAverage().constData());
    return missed == polled.askedTooLate || others > quietShare;
}

bool measure(const char* what, std::vector<std::unique_ptr<Client>>& clients, qint64 process)
{
    const Ticks before = ticks(process);
    const qint64 begin = nowNs();
    const std::clock_t clientBefore = std::clock();
    Polled polled = Poller(clients).run(phaseNs);
    Ticks after = ticks(process);
    // The client's own share is no one else's.
    after.busy -=
        qint64(double(std::clock() - clientBefore) / CLOCKS_PER_SEC * double(::sysconf(_SC_CLK_TCK)));
    if (polled.broken) {
        std::fprintf(stderr, "sixteen_sensors: a connection ended\n");
        return false;
    }
    return print(what, std::move(polled), before, after, double(nowNs() - begin) / 1e9);
}

QByteArray configuration()
{
    QJsonArray sensors;
    for (int number = 1; number <= sensorCount; ++number) {
        sensors.append(QJsonObject{{u"sensor"_s, u"HL-G203B-S-MK"_s},
                                   {u"bind"_s, u"127.0.0.%1"_s.arg(number)},
                                   {u"modbusPort"_s, 0}});
    }
    return QJsonDocument(QJsonObject{{u"sensors"_s, sensors}}).toJson();
}

int fail(const char* what)
{
    std::fprintf(stderr, "sixteen_sensors: %s\n", what);
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    if (!qEnvironmentVariableIsSet("LDS_BIN"))
        qputenv("LDS_BIN", LDS_BIN_FOLDER);
    const QTemporaryDir folder;
    QFile file(folder.filePath(u"sixteen.json"_s));
    if (!file.open(QIODevice::WriteOnly) || file.write(configuration()) < 0)
        return fail("cannot write a configuration file");
    file.close();
    const test::EmulatorProcess emulator({u"--config"_s, file.fileName()});
    const QJsonArray sensors = emulator.ready().value("sensors"_L1).toArray();
    if (sensors.size() != sensorCount)
        return fail("lds-emulator did not start");
    std::vector<std::unique_ptr<Client>> clients;
    for (int i = 0; i < sensorCount; ++i) {
        const quint16 port = test::EmulatorProcess::port(sensors.at(i).toObject(), "modbusPort"_L1);
        clients.push_back(std::make_unique<Client>(i + 1, port));
        if (!clients.back()->isConnected())
            return fail("no connection to a sensor");
    }
    std::printf(
        "%d sensors in one lds-emulator, %lld polls of 12 registers a second each, for %lld s; %ld cores\n",
        sensorCount, 1'000'000'000LL / intervalNs, phaseNs / 1'000'000'000, ::sysconf(_SC_NPROCESSORS_ONLN));
    const auto usual = quint16(catalog::hlG2(ItemId::SamplingFrequency).limits[0].defaultValue);
    bool good = measure("default cycle", clients, emulator.processId());
    if (!setSamplingCycle(clients, 0))
        return fail("the sampling cycle could not be set");
    good = measure("100 us cycle", clients, emulator.processId()) && good;
    if (!setSamplingCycle(clients, usual))
        return fail("the sampling cycle could not be set");
    return good ? 0 : fail("polls were missed on a quiet machine");
}
