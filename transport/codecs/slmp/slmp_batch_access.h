#pragma once

#include "slmp_device.h"
#include "slmp_response_frame.h"

/// Read (0401H) and Write (1401H): consecutive devices from a start device on. Cyclic writing sends
/// Write too (§5.4.3). Data: device 4, points 2, then the values to write. Words (subcommand 0000H) or
/// bits (0001H); a double word is two words, see toDoubleWord.
///
/// Here and in the other commands, encodeRequest writes what it is given, so that a test can send what a
/// sensor must refuse; decode…Request is the judge of every limit.
namespace lds::slmp {

struct ReadRequest {
    AccessUnit unit = AccessUnit::Word; ///< Word or Bit.
    Device start;
    quint16 points = 1;

    bool operator==(const ReadRequest&) const = default;
};

struct ReadResponse {
    QList<quint16> words; ///< One for each point in word units, else empty.
    QList<bool> bits;     ///< One for each point in bit units, else empty.

    bool operator==(const ReadResponse&) const = default;
};

Message encodeRequest(const ReadRequest& request);
/// C059H subcommand, C061H size, CEE1H and C05CH as checkPoints and checkDevices say.
tl::expected<ReadRequest, CompleteCode> decodeReadRequest(const Message& message);
QByteArray encodeResponse(const ReadRequest& request, const ReadResponse& response);
tl::expected<ReadResponse, ResponseFailure> decodeReadResponse(const ReadRequest& request,
                                                               const QByteArray& data);

struct WriteRequest {
    AccessUnit unit = AccessUnit::Word; ///< Word or Bit.
    Device start;
    QList<quint16> words; ///< In word units; its size is the number of points.
    QList<bool> bits;     ///< In bit units, likewise.

    bool operator==(const WriteRequest&) const = default;
};

Message encodeRequest(const WriteRequest& request);
/// As decodeReadRequest; also C05CH for a bit that is neither 0 nor 1.
tl::expected<WriteRequest, CompleteCode> decodeWriteRequest(const Message& message);

/// The normal response to Write, Write Random, Remote Run and Remote Stop has no data.
tl::expected<void, ResponseFailure> decodeEmptyResponse(const QByteArray& data);

} // namespace lds::slmp
