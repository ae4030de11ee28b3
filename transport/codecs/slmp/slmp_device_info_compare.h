#pragma once

#include "slmp_response_frame.h"

/// Device Info Compare (0E32H), MT only: whether the sensor is the device that a client expects.
namespace lds::slmp {

/// Bits of `targets` and `mismatches`.
inline constexpr quint16 compareVendor = 0x0001;
inline constexpr quint16 compareModel = 0x0002;
inline constexpr quint16 compareVersion = 0x0004;
inline constexpr quint16 compareEverything = compareVendor | compareModel | compareVersion;
/// Only in `mismatches`, beside compareVersion: which way the version differs.
inline constexpr quint16 deviceIsNewer = 0x4000;
inline constexpr quint16 deviceIsOlder = 0x8000;

/// The codes of the HL-G2 (§5.4.3, note 4). The manual prints "Type name code: 0109H, Vendor code:
/// 02000008H"; the message has 2 bytes for the vendor and 4 for the model, so the labels are swapped.
inline constexpr quint16 hlg2VendorCode = 0x0109;
inline constexpr quint32 hlg2ModelCode = 0x02000008;

struct DeviceInfo {
    quint16 vendorCode = hlg2VendorCode;
    quint32 modelCode = hlg2ModelCode;
    quint16 version = 0;

    bool operator==(const DeviceInfo&) const = default;
};

/// Data: targets 2, vendor 2, model 4, version 2.
struct DeviceInfoCompareRequest {
    quint16 targets = compareEverything;
    DeviceInfo expected;

    bool operator==(const DeviceInfoCompareRequest&) const = default;
};

/// Data: targets 2, mismatches 2.
struct DeviceInfoCompareResponse {
    quint16 targets = compareEverything; ///< Copied from the request.
    quint16 mismatches = 0;

    bool operator==(const DeviceInfoCompareResponse&) const = default;
};

Message encodeRequest(const DeviceInfoCompareRequest& request);
/// C059H subcommand, C061H size, C05CH for targets other than the three.
tl::expected<DeviceInfoCompareRequest, CompleteCode> decodeDeviceInfoCompareRequest(const Message& message);
/// What the device `own` answers.
DeviceInfoCompareResponse compare(const DeviceInfoCompareRequest& request, const DeviceInfo& own);
QByteArray encodeResponse(const DeviceInfoCompareResponse& response);
/// AnotherAnswer when it is about other targets; an error for a mismatch that was not asked for.
tl::expected<DeviceInfoCompareResponse, ResponseFailure>
decodeDeviceInfoCompareResponse(const DeviceInfoCompareRequest& request, const QByteArray& data);

} // namespace lds::slmp
