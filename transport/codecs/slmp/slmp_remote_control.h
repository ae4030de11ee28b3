#pragma once

#include "slmp_response_frame.h"

#include <QString>

/// Remote Run (1001H), Remote Stop (1002H) and Read Type Name (0101H), §5.4.2 "Remote control". The normal
/// response to Run and Stop has no data (decodeEmptyResponse); CEE0H refuses them while writing runs.
namespace lds::slmp {

/// Starts cyclic writing. Mode and clear mode are carried, but a sensor ignores both: it always runs
/// forcibly and clears nothing (§5.4.3 notes). So every value of them is legal.
struct RemoteRunRequest {
    quint16 mode = 0x0003;   ///< 0001H not forced, 0003H forced.
    quint8 clearMode = 0x00; ///< 00H clears nothing.

    bool operator==(const RemoteRunRequest&) const = default;
};

/// Data: mode 2, clear mode 1, 00H.
Message encodeRequest(const RemoteRunRequest& request);
/// C059H subcommand, C061H size, C05CH when the last byte is not 0.
tl::expected<RemoteRunRequest, CompleteCode> decodeRemoteRunRequest(const Message& message);

/// Stops cyclic writing. Data: 0001H.
struct RemoteStopRequest {
    bool operator==(const RemoteStopRequest&) const = default;
};

Message encodeRequest(const RemoteStopRequest& request);
/// C059H subcommand, C061H size, C05CH when the data is not the fixed 0001H.
tl::expected<RemoteStopRequest, CompleteCode> decodeRemoteStopRequest(const Message& message);

struct ReadTypeNameRequest {
    bool operator==(const ReadTypeNameRequest&) const = default;
};

struct ReadTypeNameResponse {
    QString name; ///< Printable ASCII, at most 16 characters, no spaces at its end.
    quint16 modelCode = 0;

    bool operator==(const ReadTypeNameResponse&) const = default;
};

inline constexpr int typeNameSize = 16;
/// What the HL-G2 is taken to send as its model code here. The manual gives none for this command; note 4 of
/// §5.4.3 prints "Type name code: 0109H", the only code of two bytes. Never recognise a sensor by it.
inline constexpr quint16 hlg2TypeNameCode = 0x0109;

/// No data.
Message encodeRequest(const ReadTypeNameRequest& request);
/// C059H subcommand, C061H size.
tl::expected<ReadTypeNameRequest, CompleteCode> decodeReadTypeNameRequest(const Message& message);
/// Name 16, filled with spaces, and model code 2. A longer name is cut.
QByteArray encodeResponse(const ReadTypeNameResponse& response);
/// Takes 00H as filling too. An empty name or anything but printable ASCII is an error.
tl::expected<ReadTypeNameResponse, ResponseFailure> decodeReadTypeNameResponse(const QByteArray& data);

} // namespace lds::slmp
