#pragma once

#include "slmp_device.h"
#include "slmp_response_frame.h"

/// Read Random (0403H) and Write Random (1402H): devices named one by one, words before double words.
/// Read: word count 1, double-word count 1, devices. Write: the same with the data after each device; with
/// subcommand 0001H bit count 1, then device 4 and state 1 (0 or 1). Read Random has no bit form.
namespace lds::slmp {

struct ReadRandomRequest {
    QList<Device> words;       ///< At most 255 fit the count; 144 together are allowed.
    QList<Device> doubleWords; ///< Each names its lower device.

    bool operator==(const ReadRandomRequest&) const = default;
};

struct ReadRandomResponse {
    QList<quint16> words;
    QList<quint32> doubleWords;

    bool operator==(const ReadRandomResponse&) const = default;
};

Message encodeRequest(const ReadRandomRequest& request);
/// C059H subcommand, CEE1H and C05CH as checkPoints says, C061H size, C05CH as checkDevices says.
tl::expected<ReadRandomRequest, CompleteCode> decodeReadRandomRequest(const Message& message);
QByteArray encodeResponse(const ReadRandomResponse& response);
tl::expected<ReadRandomResponse, ResponseFailure> decodeReadRandomResponse(const ReadRandomRequest& request,
                                                                           const QByteArray& data);

struct WordValue {
    Device device;
    quint16 value = 0;

    bool operator==(const WordValue&) const = default;
};

struct DoubleWordValue {
    Device device;
    quint32 value = 0;

    bool operator==(const DoubleWordValue&) const = default;
};

struct BitValue {
    Device device;
    bool value = false;

    bool operator==(const BitValue&) const = default;
};

/// Either bits, or words and double words: bits make the message one in bit units.
struct WriteRandomRequest {
    QList<WordValue> words;
    QList<DoubleWordValue> doubleWords;
    QList<BitValue> bits;

    bool operator==(const WriteRandomRequest&) const = default;
};

Message encodeRequest(const WriteRandomRequest& request);
/// As decodeReadRandomRequest; also C05CH for a bit that is neither 0 nor 1.
tl::expected<WriteRandomRequest, CompleteCode> decodeWriteRandomRequest(const Message& message);

} // namespace lds::slmp
