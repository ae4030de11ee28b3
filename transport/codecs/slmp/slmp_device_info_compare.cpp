#include "slmp_device_info_compare.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

namespace {

/// Which way is said once, and only of a version that differs.
bool isConsistent(const DeviceInfoCompareResponse& response)
{
    const quint16 direction = response.mismatches & (deviceIsNewer | deviceIsOlder);
    if (direction == (deviceIsNewer | deviceIsOlder))
        return false;
    if (direction != 0 && !(response.mismatches & compareVersion))
        return false;
    return (response.mismatches & ~(response.targets | direction)) == 0;
}

} // namespace

Message encodeRequest(const DeviceInfoCompareRequest& request)
{
    Writer writer;
    writer.u16(request.targets).u16(request.expected.vendorCode);
    writer.u32(request.expected.modelCode).u16(request.expected.version);
    return {Command::DeviceInfoCompare, 0, writer.result()};
}

tl::expected<DeviceInfoCompareRequest, CompleteCode> decodeDeviceInfoCompareRequest(const Message& message)
{
    if (message.subcommand != 0)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    DeviceInfoCompareRequest request;
    request.targets = reader.u16();
    request.expected.vendorCode = reader.u16();
    request.expected.modelCode = reader.u32();
    request.expected.version = reader.u16();
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (request.targets & ~compareEverything)
        return tl::unexpected(CompleteCode::Request);
    return request;
}

DeviceInfoCompareResponse compare(const DeviceInfoCompareRequest& request, const DeviceInfo& own)
{
    quint16 mismatches = 0;
    if (own.vendorCode != request.expected.vendorCode)
        mismatches |= compareVendor;
    if (own.modelCode != request.expected.modelCode)
        mismatches |= compareModel;
    if (own.version != request.expected.version)
        mismatches |= compareVersion;
    mismatches &= request.targets;
    if (mismatches & compareVersion)
        mismatches |= own.version > request.expected.version ? deviceIsNewer : deviceIsOlder;
    return {request.targets, mismatches};
}

QByteArray encodeResponse(const DeviceInfoCompareResponse& response)
{
    return Writer().u16(response.targets).u16(response.mismatches).result();
}

tl::expected<DeviceInfoCompareResponse, ResponseFailure>
decodeDeviceInfoCompareResponse(const DeviceInfoCompareRequest& request, const QByteArray& data)
{
    Reader reader(data);
    const DeviceInfoCompareResponse response{reader.u16(), reader.u16()};
    if (!reader.finished())
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    if (response.targets != request.targets)
        return tl::unexpected(ResponseFailure{ResponseError::AnotherAnswer});
    if (!isConsistent(response))
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    return response;
}

} // namespace lds::slmp
