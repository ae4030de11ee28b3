#pragma once

#include "slmp_frame.h"
#include "slmp_reader.h"
#include "slmp_writer.h"

#include <optional>

/// The part in front of timer or complete code, the same in requests and responses: subheader 2; serial
/// number 2 and reserved 2 (MT, LMT); network 1, node 1, processor 2; reserved 1 (in LMT processor
/// sub-number 1, reserved 1, extended station 2); length 2. Used by the frame codecs only.
namespace lds::slmp {

enum class Direction : quint8 { Request, Response };

struct FrameHead {
    FrameType type = FrameType::Mt;
    quint16 serial = 0; ///< 0 in ST.
    Route route;
    quint16 length = 0;         ///< Bytes that follow the head.
    bool reservedIsZero = true; ///< All reserved fields, the processor sub-number and extended station.
};

/// Nothing when the subheader is none of the three types' or the bytes end inside the head.
std::optional<FrameHead> readHead(Reader& reader, Direction direction);
/// `reservedIsZero` is not looked at: reserved fields are written as 0.
void writeHead(Writer& writer, Direction direction, const FrameHead& head);

/// LMT only: reserved 1, data id 1, total number of divisions 2, division number 2.
struct Division {
    quint8 dataId = 0;
    bool divided = false;
    bool reservedIsZero = true;
};
Division readDivision(Reader& reader);
void writeDivision(Writer& writer, quint8 dataId);

} // namespace lds::slmp
