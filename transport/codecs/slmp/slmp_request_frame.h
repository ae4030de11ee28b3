#pragma once

#include "slmp_complete_code.h"
#include "slmp_frame.h"

#include <optional>
#include <QByteArray>
#include <tl/expected.hpp>

namespace lds::slmp {

struct RequestFrame {
    FrameType type = FrameType::Mt;
    quint16 serial = 0; ///< MT and LMT; the response carries it back. 0 in ST.
    Route route;
    quint16 timer = 0; ///< How long the server may take, in units of 250 ms; 0: as long as it needs.
    quint8 dataId = 0; ///< LMT only.
    Message message;

    bool operator==(const RequestFrame&) const = default;
};

/// Why a datagram is no request to carry out, and what a server answers.
struct RequestFailure {
    std::optional<CompleteCode> answer; ///< Nothing: no response is sent.
    RequestFrame request;               ///< What the error response repeats; its data may be cut.
};

QByteArray encodeRequestFrame(const RequestFrame& frame);

/// Silence for what is not the head of a request up to its subcommand; otherwise, in this order, CEE1H
/// (too large), C061H (length), CF44H (divided) or C05CH (a reserved field is not 0). Whom it is for and
/// what it says is not judged here.
tl::expected<RequestFrame, RequestFailure> decodeRequestFrame(const QByteArray& datagram);

} // namespace lds::slmp
