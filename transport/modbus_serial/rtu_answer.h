#pragma once

#include "modbus_pdu.h"

#include <QByteArray>
#include <QList>
#include <QString>

/// What the bytes say that were heard after a request went out on a serial line. Pure functions over
/// hostile bytes.
namespace lds::modbus {

/// A whole message that is not the answer, or bytes that are no message.
struct RtuStray {
    QByteArray bytes;
    QString what; ///< FrameRecorder::malformed(): "unit", "late", "noise", "short", "trailing".
};

struct RtuVerdict {
    enum class Kind : quint8 {
        Answer,  ///< One message of the unit asked, and it alone can be the answer.
        Silent,  ///< Nothing of the unit asked.
        Spoiled, ///< Bytes that may have been the answer or may hide it; `what` says why it is not taken.
    };
    Kind kind = Kind::Silent;
    QByteArray frame; ///< Answer: the message.
    QString what;
    QList<RtuStray> strays;
    QByteArray pdu() const { return frame.sliced(1, frame.size() - 3); }
};

/// The answer to a request of data. Whole messages of other units are left aside, and so are coils of this
/// one, which are never asked for as data (see RtuBus); any other byte beside the answer spoils it.
RtuVerdict judgeData(const QByteArray& heard, quint8 unit);

/// The answer to a Read Coils that only asks whether something older is under way: older answers in front of
/// it are left aside.
RtuVerdict judgeCoils(const QByteArray& heard, quint8 unit);

} // namespace lds::modbus
