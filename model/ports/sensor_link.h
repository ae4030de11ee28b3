#pragma once

#include "connection_url.h"
#include "measurement.h"
#include "values.h"

#include <memory>
#include <QList>
#include <QMetaType>
#include <QObject>
#include <QString>

namespace lds::ports {

using RequestId = quint64;

/// A person's request goes before a procedure's, both before the slow walk, and all before polls.
enum class Urgency : quint8 { Person, Procedure, Background };

enum class RequestKind : quint8 { Read, Write };

struct Request {
    RequestId id = 0; ///< Chosen by the caller, unique per link.
    RequestKind kind = RequestKind::Read;
    Urgency urgency = Urgency::Person;
    QList<catalog::ItemId> items; ///< Read: the link packs them into as few messages as the protocol allows.
    settings::Write write;        ///< Write: one message; more than one item only for one WriteGroup.
    int timeoutMs = 0;            ///< 0: the link's own. Saving silences the sensor for seconds (§5.3.3).
};

/// Every request ends exactly once with one of these.
enum class Status : quint8 {
    Done,
    Refused, ///< The sensor or the link said no; nothing was changed by this message (see WriteFailed).
    Unknown, ///< No answer: a write may or may not have been carried out. It is never repeated.
};

enum class FailureCode : quint8 {
    None,
    FunctionNotSupported, ///< 01
    AddressRefused,       ///< 02
    ValueRefused,         ///< 03: out of range or inconsistent
    NotReady,             ///< 04 to a read, or to a write: in its menu, saving, or the write failed (§5.2.2)
    OtherRefusal,         ///< A code the manual does not list; see wireCode
    NoAnswer,             ///< Timeout
    Malformed,            ///< Cut short, or not an answer to the request
    ConnectionLost,
    NotConnected,
    NotReachable, ///< The protocol has no address for the item
    ViewOnly,
};

struct Failure {
    FailureCode code = FailureCode::None;
    int wireCode = 0; ///< Exception code as received; 0 when there was none.
    QString detail;   ///< For logs; English or the system's own text. Never the only explanation.
};

struct Outcome {
    RequestId id = 0;
    RequestKind kind = RequestKind::Read;
    Status status = Status::Unknown;
    settings::Values values; ///< Read and Done: what was read.
    Failure failure;
    qint64 finishedNs = 0; ///< Monotonic time the answer arrived.
};

enum class LinkState : quint8 {
    Closed,
    Opening,
    Open,   ///< Connected, and what answers is an HL-G2 (word order proven).
    Failed, ///< Could not open, or was cut; see LinkReport::failure. open() tries again.
};

enum class OpenFailure : quint8 {
    None,
    HostNotFound,
    Refused,    ///< Nobody listens on that port.
    NoAnswer,   ///< Nobody answers, or connected but no reply to the first read.
    NotASensor, ///< Answers, but not as an HL-G2 does.
    NotReady,   ///< An HL-G2 in its menu (exception 04).
    Lost,       ///< Cut while open.
    // Of serial lines:
    NoSuchPort,         ///< No port of that name, or the adapter known by it is not plugged in.
    PortBusy,           ///< Another program has it open.
    PortNotPermitted,   ///< The system does not let this person open it.
    PortUnusable,       ///< It is no serial port, or cannot do the settings.
    PortSettingsDiffer, ///< It is open for other sensors with other settings.
    PortGone,           ///< It vanished while open: unplugged.
};

struct LinkReport {
    LinkState state = LinkState::Closed;
    OpenFailure failure = OpenFailure::None;
    QString detail;           ///< The system's own words.
    bool lowWordFirst = true; ///< Found by the probe; meaningful when Open.
};

struct PollStatistics {
    quint64 answered = 0; ///< Polls with a measurement since opening.
    quint64 lost = 0;     ///< Polls that ended without one.
    quint64 dropped = 0;  ///< Ticks not sent because the connection was busy: never queued.
};

/// A connection to one sensor. Lives in its own thread; the public functions may be called from any
/// thread and only post. Signals are emitted in the link's thread: connect with a context object.
/// One request is on the wire at a time. Deleting goes through LinkDeleter.
class SensorLink : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The items this protocol can reach. Constant and thread-safe.
    virtual bool reaches(catalog::ItemId item) const = 0;

    void open();  ///< When Closed or Failed.
    void close(); ///< Ends every outstanding request as Unknown/ConnectionLost and polling.
    void submit(const Request& request);
    /// Polls state, value and intensity in one message every `intervalMs` ≥ 1; 0 stops.
    void poll(int intervalMs);

Q_SIGNALS:
    void reported(const lds::ports::LinkReport& report); ///< At every change of state.
    void finished(const lds::ports::Outcome& outcome);   ///< Exactly once for every submitted request.
    void measured(const lds::measurement::MeasurementBatch& batch,
                  const lds::ports::PollStatistics& statistics);
    /// A poll was refused: NotReady while the sensor is in its menu; None when polls succeed again.
    void pollRefused(const lds::ports::Failure& failure);

protected:
    virtual void doOpen() = 0;
    virtual void doClose() = 0;
    virtual void doSubmit(const Request& request) = 0;
    virtual void doPoll(int intervalMs) = 0;
};

/// Deletes a link in its own thread.
struct LinkDeleter {
    void operator()(SensorLink* link) const;
};
using LinkPointer = std::unique_ptr<SensorLink, LinkDeleter>;

/// Makes links for URLs. The only place that knows which class speaks which protocol.
class LinkFactory {
public:
    virtual ~LinkFactory() = default;
    virtual LinkPointer create(const ConnectionUrl& url) = 0;
};

void registerMetaTypes(); ///< Once, before links and sessions meet across threads.

} // namespace lds::ports

Q_DECLARE_METATYPE(lds::ports::Request)
Q_DECLARE_METATYPE(lds::ports::Outcome)
Q_DECLARE_METATYPE(lds::ports::LinkReport)
Q_DECLARE_METATYPE(lds::ports::PollStatistics)
Q_DECLARE_METATYPE(lds::ports::Failure)
