#include "slmp_self_test.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

Message encodeRequest(const SelfTestRequest& request)
{
    return {Command::SelfTest, 0, Writer().u16(quint16(request.data.size())).bytes(request.data).result()};
}

tl::expected<SelfTestRequest, CompleteCode> decodeSelfTestRequest(const Message& message)
{
    if (message.subcommand != 0)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    const quint16 length = reader.u16();
    if (reader.failed())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (length < 1 || length > maximumTestData)
        return tl::unexpected(CompleteCode::Request);
    if (reader.left() != length)
        return tl::unexpected(CompleteCode::RequestDataSize);
    return SelfTestRequest{reader.rest()};
}

QByteArray encodeResponse(const SelfTestRequest& request) { return encodeRequest(request).data; }

tl::expected<void, ResponseFailure> decodeSelfTestResponse(const SelfTestRequest& request,
                                                           const QByteArray& data)
{
    if (data != encodeResponse(request))
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    return {};
}

} // namespace lds::slmp
