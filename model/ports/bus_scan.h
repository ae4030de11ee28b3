#pragma once

#include "serial_settings.h"

#include <memory>
#include <QList>
#include <QMetaType>
#include <QObject>
#include <QString>

namespace lds::ports {

/// Where to look for sensors on one serial line, in this order: every unit of the first settings, then of
/// the next.
struct ScanPlan {
    QString port;                   ///< As it is opened.
    QList<SerialSettings> settings; ///< The common ones first.
    quint8 firstUnit = 1;           ///< 1 … 247
    quint8 lastUnit = 247;
};

/// What answered at one address.
struct ScanFinding {
    enum class Kind : quint8 {
        Sensor,      ///< As an HL-G2 does.
        OtherDevice, ///< Well-formed Modbus, but no HL-G2.
        TwoUnits,    ///< More than one unit answers to this address: bytes of both, at the time of an answer.
        Noise, ///< Bytes that are no answer, whoever is asked: wrong speed or parity, or a disturbed line.
    };
    Kind kind = Kind::Sensor;
    SerialSettings serial;
    quint8 unit = 0; ///< 0 when it belongs to no address (Noise).
    friend bool operator==(const ScanFinding&, const ScanFinding&) = default;
};

struct ScanProgress {
    int asked = 0; ///< Addresses, of all settings together.
    int total = 0;
    SerialSettings serial; ///< Being asked now.
    quint8 unit = 0;
};

enum class ScanEnd : quint8 { Complete, Cancelled, PortFailed };

/// Looks for units on a line. Lives in a thread of its own; start() and cancel() may be called from any
/// thread and only post. Signals are emitted in its thread: connect with a context object.
class BusScan : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void start(const ScanPlan& plan); ///< When none runs.
    void cancel();

Q_SIGNALS:
    void progressed(const lds::ports::ScanProgress& progress);
    void found(const lds::ports::ScanFinding& finding);
    /// Exactly once for each start(). `detail`: the system's own words when the port failed.
    void finished(lds::ports::ScanEnd end, const QString& detail);

protected:
    virtual void doStart(const ScanPlan& plan) = 0;
    virtual void doCancel() = 0;
};

/// Deletes a scan in its own thread; one that runs ends without a signal.
struct BusScanDeleter {
    void operator()(BusScan* scan) const;
};
using BusScanPointer = std::unique_ptr<BusScan, BusScanDeleter>;

/// Makes scans. A line that has links open is shared with them: one request at a time.
class BusScanFactory {
public:
    virtual ~BusScanFactory() = default;
    virtual BusScanPointer createScan() = 0;
};

} // namespace lds::ports

Q_DECLARE_METATYPE(lds::ports::ScanPlan)
Q_DECLARE_METATYPE(lds::ports::ScanFinding)
Q_DECLARE_METATYPE(lds::ports::ScanProgress)
