#pragma once

#include "control_desk.h"
#include "line_splitter.h"

#include <QLocalServer>
#include <QObject>

class QLocalSocket;

namespace lds::app {

/// Control lines over a local socket that only the same user may open. Several clients; each is bounded
/// in what it may send at once and leave unread.
class ControlSocket final : public QObject {
    Q_OBJECT

public:
    static constexpr int mostClients = 8;                ///< Further ones are told so and closed.
    static constexpr qint64 largestBacklog = 256 * 1024; ///< Bytes of answers a client leaves unread.

    explicit ControlSocket(ControlDesk& desk, QObject* parent = nullptr);

    /// A name, or a path. A socket left behind by a program that is gone is replaced. The error says why it
    /// cannot listen.
    tl::expected<void, QString> listen(const QString& name);
    QString path() const { return m_server.fullServerName(); }
    int clientCount() const { return m_clients; }

private:
    void acceptClients();
    void serve(QLocalSocket* socket);
    void read(QLocalSocket* socket, LineSplitter& splitter);

    ControlDesk& m_desk;
    QLocalServer m_server;
    int m_clients = 0;
};

} // namespace lds::app
