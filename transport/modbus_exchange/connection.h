#pragma once

#include "frame_recorder.h"
#include "modbus_pdu.h"
#include "scheduler.h"
#include "sensor_link.h"

#include <functional>
#include <memory>
#include <QObject>
#include <tl/expected.hpp>

namespace lds::modbus {

/// Which exchange goes first where several wait: ports::Urgency, and polls after all of them.
enum class Turn : quint8 { Person, Procedure, Background, Poll };
constexpr Turn turnOf(ports::Urgency urgency) { return Turn(quint8(urgency)); }

/// A way to one sensor that carries one request at a time: a TCP connection, or a place on a serial bus.
///
/// Everything happens in the thread that calls open(). Nothing is ever repeated here.
class Connection : public QObject {
    Q_OBJECT

public:
    struct Exchange {
        tl::expected<Response, ports::Failure> result;
        qint64 endedNs = 0; ///< When the answer arrived, or when it was given up.
        qint64 endedWallMs = 0;
    };
    using Ended = std::function<void(const Exchange&)>;

    using QObject::QObject;

    virtual void open(int timeoutMs) = 0; ///< Then opened() or failed(), once.
    /// Silent: no signal, no Ended. Does nothing when closed. `reason` is for the frame log.
    virtual void close(const QString& reason) = 0;
    virtual bool isOpen() const = 0;

    /// When open and not busy for that turn. `ended` is called exactly once unless close() comes first.
    /// `timeoutMs` is the sensor's time to answer; what the line itself takes is added where it counts.
    virtual void send(const Request& request, Turn turn, int timeoutMs, const Ended& ended) = 0;
    virtual bool isBusy(Turn turn) const = 0;

    /// Whether exchanges wait for those of other sensors. Then a poll and a request may be waiting at the
    /// same time, and a request that waits long does not hold up the polls.
    virtual bool isShared() const { return false; }
    /// Lets the request that is waiting wait no longer than one of `turn` would. Never the other way.
    virtual void hurry(Turn turn) { Q_UNUSED(turn) }

Q_SIGNALS:
    void opened();
    void failed(lds::ports::OpenFailure failure, const QString& detail);
    /// Once, after opened(); the request under way has ended before.
    void lost(lds::ports::OpenFailure failure, const QString& detail);
};

/// Makes the connection of a link, in the link's thread. All three outlive it.
using ConnectionMaker = std::function<std::unique_ptr<Connection>(
    const ports::ConnectionUrl& url, ports::Scheduler& scheduler, FrameRecorder& recorder)>;

} // namespace lds::modbus
