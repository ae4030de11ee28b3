#include "scripted_line.h"

#include <algorithm>
#include <fcntl.h>
#include <pty.h>
#include <QTimer>
#include <termios.h>
#include <unistd.h>

namespace lds::tests {

namespace {

QByteArray crcOf(const QByteArray& bytes)
{
    unsigned crc = 0xffff;
    for (const char byte : bytes) {
        crc ^= quint8(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1) != 0 ? crc >> 1 ^ 0xa001 : crc >> 1;
    }
    return QByteArray(1, char(crc & 0xff)) + char(crc >> 8);
}

QByteArray wordBytes(int value) { return QByteArray(1, char(value >> 8)) + char(value & 0xff); }

} // namespace

ScriptedLine::ScriptedLine()
{
    int port = -1;
    termios raw = {};
    cfmakeraw(&raw);
    cfsetspeed(&raw, B9600);
    char name[64] = {};
    if (openpty(&m_master, &port, name, &raw, nullptr) != 0)
        qFatal("no pseudo-terminal");
    ::close(port);
    fcntl(m_master, F_SETFL, O_NONBLOCK);
    m_port = QString::fromLocal8Bit(name);
    m_notifier = std::make_unique<QSocketNotifier>(m_master, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &ScriptedLine::onReadable);
}

ScriptedLine::~ScriptedLine() { unplug(); }

void ScriptedLine::unplug()
{
    m_notifier.reset();
    if (m_master >= 0)
        ::close(std::exchange(m_master, -1));
}

void ScriptedLine::send(const QByteArray& bytes)
{
    if (m_holding) {
        m_held.append(bytes);
        return;
    }
    if (m_master >= 0 && ::write(m_master, bytes.constData(), std::size_t(bytes.size())) != bytes.size())
        qFatal("the pseudo-terminal takes no bytes");
}

void ScriptedLine::hold(int ms)
{
    m_holding = true;
    QTimer::singleShot(ms, Qt::PreciseTimer, this, [this] {
        m_holding = false;
        for (const QByteArray& bytes : std::exchange(m_held, {}))
            send(bytes);
    });
}

void ScriptedLine::onReadable()
{
    char bytes[512];
    const auto size = ::read(m_master, bytes, sizeof bytes);
    if (size <= 0) { // Nobody has the port open; look again when the event loop comes round.
        m_buffer.clear();
        return;
    }
    m_buffer.append(bytes, size);
    while (m_master >= 0 && takeRequest()) {
    }
}

bool ScriptedLine::takeRequest()
{
    if (m_buffer.size() < 8)
        return false;
    qsizetype length = 8;
    if (quint8(m_buffer.at(1)) == 0x10)
        length = 9 + quint8(m_buffer.at(6));
    if (m_buffer.size() < length)
        return false;
    const QByteArray message = m_buffer.first(length);
    if (message.last(2) != crcOf(message.first(length - 2))) {
        m_buffer.clear();
        return false;
    }
    m_buffer.remove(0, length);
    const Received request{quint8(message.at(0)), message.sliced(1, length - 3)};
    received.append(request);
    handle(request);
    return true;
}

void ScriptedLine::handle(const Received& request)
{
    auto& scripts = request.isCoils() ? m_coilScripts : m_scripts;
    if (!scripts.isEmpty())
        scripts.dequeue()(request);
    else if (m_always)
        m_always(request);
    else if (units.contains(request.unit))
        send(goodFrame(request));
}

QByteArray ScriptedLine::goodPdu(const Received& request)
{
    QByteArray pdu(1, char(request.function()));
    switch (request.function()) {
    case 0x01:
        pdu += char((request.count() + 7) / 8);
        pdu += QByteArray((request.count() + 7) / 8, char(0x55));
        break;
    case 0x03:
        pdu += char(2 * request.count());
        for (int i = 0; i < request.count(); ++i)
            pdu += wordBytes(registers.value(request.first() + i, quint16(1000 * request.unit)));
        break;
    case 0x06:
        registers[request.first()] = quint16(request.word(3));
        pdu = request.pdu;
        break;
    case 0x10:
        for (int i = 0; i < request.count(); ++i)
            registers[request.first() + i] = quint16(request.word(6 + 2 * i));
        pdu = request.pdu.first(5);
        break;
    }
    return pdu;
}

QByteArray ScriptedLine::goodFrame(const Received& request) { return frame(request.unit, goodPdu(request)); }

QByteArray ScriptedLine::frame(quint8 unit, const QByteArray& pdu)
{
    const QByteArray bytes = QByteArray(1, char(unit)) + pdu;
    return bytes + crcOf(bytes);
}

QList<ScriptedLine::Received> ScriptedLine::data() const
{
    QList<Received> some = received;
    some.removeIf([](const Received& request) { return request.isCoils(); });
    return some;
}

int ScriptedLine::writes() const
{
    return int(std::ranges::count_if(received, [](const Received& request) { return request.isWrite(); }));
}

} // namespace lds::tests
