#pragma once

#include "slmp_complete_code.h"
#include "slmp_frame.h"
#include "slmp_request_frame.h"

#include <optional>
#include <QByteArray>
#include <tl/expected.hpp>

namespace lds::slmp {

/// Who refused and what: network 1, node 1, processor 2, reserved 1, command 2, subcommand 2. Follows the
/// complete code of ST and MT error responses; LMT responses name the command in every response instead.
struct ErrorInformation {
    Route route;
    Command command = Command::Read;
    quint16 subcommand = 0;

    bool operator==(const ErrorInformation&) const = default;
};

struct ResponseFrame {
    FrameType type = FrameType::Mt;
    quint16 serial = 0;
    Route route;
    CompleteCode completeCode = CompleteCode::Success;
    Command command = Command::Read; ///< LMT only, like the two below.
    quint16 subcommand = 0;
    quint8 dataId = 0;
    QByteArray data = {};                                  ///< Empty in an error response.
    std::optional<ErrorInformation> errorInformation = {}; ///< Only in an error response.

    bool operator==(const ResponseFrame&) const = default;
};

QByteArray encodeResponseFrame(const ResponseFrame& frame);
/// A server's answer to `request`: the normal response, or CEE2H when that would exceed 1472 bytes.
QByteArray encodeAnswer(const RequestFrame& request, const QByteArray& data);
/// A server's refusal of `request`.
QByteArray encodeErrorAnswer(const RequestFrame& request, CompleteCode code);

enum class ResponseError {
    NoResponse,    ///< Not the head of a response of the three types, up to where its data begins.
    Length,        ///< Cut short, bytes left over, or longer than 1472 bytes.
    Reserved,      ///< A reserved field is not 0.
    Divided,       ///< A part of a message (LMT).
    AnotherAnswer, ///< The answer to another request: type, serial number, route or command differ.
    Refused,       ///< The sensor's refusal: see `completeCode`.
    Data,          ///< The data does not fit the request.
};

struct ResponseFailure {
    ResponseError error = ResponseError::NoResponse;
    CompleteCode completeCode = CompleteCode::Success; ///< As received; may be none of the table.
};

/// One datagram. An error response's information must be there in ST and MT; in LMT, where no table shows
/// it, both its presence and its absence are taken.
tl::expected<ResponseFrame, ResponseError> decodeResponseFrame(const QByteArray& datagram);

/// A client's view: the data of the answer to `request` and to nothing else. ST has no serial number, so
/// there only the route, and in a refusal the command, tell a late answer from the one waited for.
tl::expected<QByteArray, ResponseFailure> decodeAnswer(const RequestFrame& request,
                                                       const QByteArray& datagram);

} // namespace lds::slmp
