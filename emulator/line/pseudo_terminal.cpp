#include "pseudo_terminal.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_LINUX
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace lds::emulator {

using namespace Qt::StringLiterals;

#ifdef Q_OS_LINUX

namespace {

/// A client that opens the terminal again is noticed within this time.
constexpr int openingPollMs = 10;
constexpr std::size_t readSize = 4096;
/// Terminals stand in this folder. The link says so with a detour, by which it is known as an emulator's.
const QString devices = u"/dev/pts/"_s;
const QString devicesInLink = u"/dev/pts/./"_s;

struct Speed {
    speed_t code;
    int bitsPerSecond;
};
/// A speed that nobody uses: the client has not set any. It counts as the one a sensor is delivered with, so
/// that a program which takes the terminal for a plain file is heard.
constexpr speed_t neverSet = B134;
/// Those a sensor may have, and their neighbours.
constexpr std::array<Speed, 13> speeds{{{neverSet, LineSettings().speed},
                                        {B1200, 1200},
                                        {B2400, 2400},
                                        {B4800, 4800},
                                        {B9600, 9600},
                                        {B19200, 19200},
                                        {B38400, 38400},
                                        {B57600, 57600},
                                        {B115200, 115200},
                                        {B230400, 230400},
                                        {B460800, 460800},
                                        {B500000, 500000},
                                        {B921600, 921600}}};

QString systemError() { return QString::fromLocal8Bit(std::strerror(errno)); }

LineSettings settingsOf(const termios& terminal, int bitsPerSecond)
{
    using catalog::LineParity;
    const bool odd = terminal.c_cflag & PARODD;
    const LineParity parity = terminal.c_cflag & CSTOPB ? LineParity::None
                              : odd                     ? LineParity::Odd
                                                        : LineParity::Even;
    return {bitsPerSecond, parity};
}

/// Empty when it is no link.
QString targetOf(const QString& link)
{
    std::array<char, 4096> target = {};
    const auto length = ::readlink(QFile::encodeName(link).constData(), target.data(), target.size());
    return length > 0 ? QFile::decodeName(QByteArray(target.data(), length)) : QString();
}

QString linkTo(const QString& device) { return devicesInLink + device.mid(devices.size()); }

std::optional<termios> settingsNow(int descriptor)
{
    termios terminal = {};
    return ::tcgetattr(descriptor, &terminal) == 0 ? std::optional(terminal) : std::nullopt;
}

bool isSame(const termios& one, const termios& other)
{
    return one.c_iflag == other.c_iflag && one.c_oflag == other.c_oflag && one.c_cflag == other.c_cflag &&
           one.c_lflag == other.c_lflag && ::cfgetospeed(&one) == ::cfgetospeed(&other);
}

/// As a client finds it: raw, without echo, at no speed of its own, and as a modem's line. Each client
/// changes the last two. The C library refuses settings with parity, which a pseudo-terminal cannot have,
/// when they change nothing else.
termios asFound(termios terminal)
{
    ::cfmakeraw(&terminal);
    terminal.c_cflag &= ~tcflag_t(CLOCAL | PARODD | CSTOPB);
    ::cfsetspeed(&terminal, neverSet);
    return terminal;
}

} // namespace

PseudoTerminal::PseudoTerminal(const QString& link, EmulatorClock& clock)
    : m_link(QFileInfo(link).absoluteFilePath())
    , m_clock(clock)
{}

PseudoTerminal::Opened PseudoTerminal::open(const QString& link, EmulatorClock& clock)
{
    std::unique_ptr<PseudoTerminal> terminal(new PseudoTerminal(link, clock));
    auto opened = terminal->reserveLink();
    if (opened)
        opened = terminal->openTerminal();
    if (opened)
        opened = terminal->makeLink();
    if (!opened)
        return tl::unexpected(u"%1: %2"_s.arg(link, opened.error()));
    return terminal;
}

PseudoTerminal::~PseudoTerminal()
{
    m_notifier.reset();
    if (m_linked && targetOf(m_link) == linkTo(m_device))
        ::unlink(QFile::encodeName(m_link).constData());
    if (m_master >= 0)
        ::close(m_master);
    if (m_reservation >= 0)
        ::close(m_reservation);
}

/// A name that the system gives back when the program ends, however it ends: so a link whose name is free
/// was left behind.
tl::expected<void, QString> PseudoTerminal::reserveLink()
{
    const QFileInfo info(m_link);
    const QString folder = info.dir().canonicalPath();
    if (folder.isEmpty())
        return tl::unexpected(u"the folder does not exist"_s);
    const QByteArray place = QCryptographicHash::hash(QFile::encodeName(folder + u'/' + info.fileName()),
                                                      QCryptographicHash::Sha256);
    const QByteArray name = QByteArray(1, '\0') + "lds-emulator-rtu-" + place.toHex();
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    static_assert(sizeof address.sun_path > 1 + 17 + 64);
    std::copy(name.cbegin(), name.cend(), address.sun_path);
    const auto length = socklen_t(offsetof(sockaddr_un, sun_path) + std::size_t(name.size()));
    m_reservation = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (m_reservation < 0)
        return tl::unexpected(systemError());
    if (::bind(m_reservation, reinterpret_cast<const sockaddr*>(&address), length) != 0) {
        return tl::unexpected(errno == EADDRINUSE ? u"another emulator serves this link"_s : systemError());
    }
    return {};
}

tl::expected<void, QString> PseudoTerminal::openTerminal()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    std::array<char, 128> name = {};
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0 ||
        ::ptsname_r(m_master, name.data(), name.size()) != 0)
        return tl::unexpected(u"cannot make a pseudo-terminal: "_s + systemError());
    m_device = QFile::decodeName(name.data());
    if (const auto now = settingsNow(m_master)) {
        const termios found = asFound(*now);
        ::tcsetattr(m_master, TCSANOW, &found);
    }
    m_notifier = std::make_unique<QSocketNotifier>(m_master, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &PseudoTerminal::readArrived);
    return {};
}

tl::expected<void, QString> PseudoTerminal::makeLink()
{
    const QByteArray link = QFile::encodeName(m_link);
    const QString target = targetOf(m_link);
    if (target.startsWith(devicesInLink))
        ::unlink(link.constData());
    else if (!target.isEmpty())
        return tl::unexpected(
            u"is somebody else's link to %1; remove it or choose another name"_s.arg(target));
    if (::symlink(QFile::encodeName(linkTo(m_device)).constData(), link.constData()) == 0) {
        m_linked = true;
        return {};
    }
    if (errno == EEXIST)
        return tl::unexpected(u"exists and is no link of an emulator; remove it or choose another name"_s);
    return tl::unexpected(u"cannot make the link: "_s + systemError());
}

std::optional<LineSettings> PseudoTerminal::clientSettings() const
{
    const auto terminal = settingsNow(m_master); // of a pseudo-terminal: what the client has set
    if (!terminal)
        return std::nullopt;
    const speed_t code = ::cfgetospeed(&*terminal);
    const auto* const speed =
        std::find_if(speeds.begin(), speeds.end(), [code](const Speed& each) { return each.code == code; });
    if (speed == speeds.end())
        return std::nullopt;
    return settingsOf(*terminal, speed->bitsPerSecond);
}

void PseudoTerminal::readArrived()
{
    QByteArray bytes(readSize, Qt::Uninitialized);
    const auto count = ::read(m_master, bytes.data(), readSize);
    if (count > 0) {
        bytes.truncate(count);
        forgetClient();
        Q_EMIT received(bytes);
    } else if (count < 0 && errno == EIO) {
        clientLeft();
    }
}

/// So that a client that opens it again at once, and sets the same again, changes something (asFound()).
void PseudoTerminal::forgetClient()
{
    auto terminal = settingsNow(m_master);
    if (!terminal || !(terminal->c_cflag & CLOCAL))
        return;
    terminal->c_cflag &= ~tcflag_t(CLOCAL);
    ::tcsetattr(m_master, TCSANOW, &*terminal);
}

void PseudoTerminal::clientLeft()
{
    m_open = false;
    m_notifier->setEnabled(false);
    // What the client has not read would wait for the next one.
    const int client =
        ::open(QFile::encodeName(m_device).constData(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    if (client < 0) {
        replaceTerminal();
        return;
    }
    ::tcflush(client, TCIFLUSH);
    const auto before = settingsNow(client);
    const auto found = before ? std::optional(asFound(*before)) : std::nullopt;
    if (found)
        ::tcsetattr(client, TCSANOW, &*found);
    ::close(client);
    if (found && hasClient()) {
        // The next one was quick; perhaps it had set already what has just been set otherwise.
        const auto now = settingsNow(m_master);
        if (now && isSame(*now, *found))
            ::tcsetattr(m_master, TCSANOW, &*before);
    }
    waitForClient();
}

/// False when nobody has it open and nothing is left to be read.
bool PseudoTerminal::hasClient() const
{
    pollfd state{m_master, POLLIN, 0};
    return ::poll(&state, 1, 0) < 0 || (state.revents & (POLLHUP | POLLIN)) != POLLHUP;
}

/// A client that had it for itself and was killed has locked it for good: the link leads to a new one.
void PseudoTerminal::replaceTerminal()
{
    m_notifier.release()->deleteLater(); // it is being served
    ::close(m_master);
    const bool isOwn = targetOf(m_link) == linkTo(m_device);
    m_open = openTerminal() && isOwn && makeLink();
}

/// Nothing tells of it but asking.
void PseudoTerminal::waitForClient()
{
    if (hasClient()) {
        m_open = true;
        m_notifier->setEnabled(true);
        return;
    }
    m_clock.after(openingPollMs, this, [this] { waitForClient(); });
}

void PseudoTerminal::send(const QByteArray& bytes)
{
    if (!m_open)
        return;
    // What does not fit is lost: the client's receive buffer has run over.
    [[maybe_unused]] const auto written = ::write(m_master, bytes.constData(), std::size_t(bytes.size()));
}

#else

PseudoTerminal::PseudoTerminal(const QString& link, EmulatorClock& clock)
    : m_link(link)
    , m_clock(clock)
{}

PseudoTerminal::~PseudoTerminal() = default;

PseudoTerminal::Opened PseudoTerminal::open(const QString& link, EmulatorClock&)
{
    return tl::unexpected(u"%1: a virtual serial line needs the pseudo-terminals of Linux"_s.arg(link));
}

std::optional<LineSettings> PseudoTerminal::clientSettings() const { return std::nullopt; }
void PseudoTerminal::send(const QByteArray&) {}

#endif

} // namespace lds::emulator
