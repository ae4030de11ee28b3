#include "control_socket.h"

#include <memory>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocalSocket>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

namespace lds::app {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 readBufferSize = 4096;
constexpr int answerOfLivingMs = 1000;

/// A socket in the file system at which nobody listens any more. Never true of another kind of file.
bool isLeftBehind(const QString& path)
{
#ifdef Q_OS_UNIX
    struct stat facts = {};
    if (::lstat(QFile::encodeName(path).constData(), &facts) != 0 || !S_ISSOCK(facts.st_mode))
        return false;
    QLocalSocket probe;
    probe.connectToServer(path);
    return !probe.waitForConnected(answerOfLivingMs) && probe.error() == QLocalSocket::ConnectionRefusedError;
#else
    Q_UNUSED(path)
    return false; // named pipes end with their program
#endif
}

} // namespace

ControlSocket::ControlSocket(ControlDesk& desk, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
{
    m_server.setSocketOptions(QLocalServer::UserAccessOption);
    connect(&m_server, &QLocalServer::newConnection, this, &ControlSocket::acceptClients);
}

tl::expected<void, QString> ControlSocket::listen(const QString& name)
{
    // QLocalServer with access options replaces whatever has the name, so look first.
    const QString path = name.startsWith(u'/') ? name : QDir::tempPath() + u'/' + name;
    if (isLeftBehind(path))
        QLocalServer::removeServer(name);
    else if (QFileInfo::exists(path))
        return tl::unexpected(
            u"%1: is there already; another program has it, or it is no socket"_s.arg(path));
    if (!m_server.listen(name))
        return tl::unexpected(u"%1: %2"_s.arg(path, m_server.errorString()));
    return {};
}

void ControlSocket::acceptClients()
{
    while (QLocalSocket* socket = m_server.nextPendingConnection()) {
        connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
        if (m_clients < mostClients) {
            serve(socket);
            continue;
        }
        socket->write("{\"error\":\"there are too many control connections already\",\"ok\":false}\n");
        socket->disconnectFromServer();
    }
}

void ControlSocket::serve(QLocalSocket* socket)
{
    ++m_clients;
    socket->setReadBufferSize(readBufferSize);
    const auto splitter = std::make_shared<LineSplitter>(ControlDesk::longestLine);
    connect(socket, &QLocalSocket::readyRead, this, [this, socket, splitter] { read(socket, *splitter); });
    connect(socket, &QLocalSocket::disconnected, this, [this] { --m_clients; });
    read(socket, *splitter); // what came with the connection
}

void ControlSocket::read(QLocalSocket* socket, LineSplitter& splitter)
{
    const auto lines = splitter.feed(socket->readAll());
    for (const LineSplitter::Line& line : lines) {
        socket->write(line.overlong ? ControlDesk::answerToOverlongLine() : m_desk.answer(line.text));
        if (socket->bytesToWrite() > largestBacklog) {
            socket->abort();
            return;
        }
    }
    socket->flush(); // a client that has sent its last line gets its answers all the same
}

} // namespace lds::app
