#pragma once

#include "slmp_response_frame.h"

/// Self Test (0619H), the wrap test: length 2 and data, sent back as they are.
namespace lds::slmp {

inline constexpr int maximumTestData = 960; ///< §5.4.3, C05CH above. At least 1 by the published standard.

struct SelfTestRequest {
    QByteArray data;

    bool operator==(const SelfTestRequest&) const = default;
};

Message encodeRequest(const SelfTestRequest& request);
/// C059H subcommand, C05CH for a length of 0 or above 960, C061H when the data has another length.
tl::expected<SelfTestRequest, CompleteCode> decodeSelfTestRequest(const Message& message);
QByteArray encodeResponse(const SelfTestRequest& request);
/// An error unless the data came back as it was sent.
tl::expected<void, ResponseFailure> decodeSelfTestResponse(const SelfTestRequest& request,
                                                           const QByteArray& data);

} // namespace lds::slmp
