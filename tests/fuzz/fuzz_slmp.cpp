// The SLMP codec against bytes of any kind, as the sensor's server and as a client would see them. Whatever
// is accepted says exactly what the bytes say, holds the manual's limits (§5.4.3), and took memory in
// proportion to the bytes.

#include "allocation_watch.h"
#include "fuzz_check.h"
#include "slmp_server_request.h"

#include <cstdint>

using namespace lds::slmp;

namespace {

/// The one that the seeds name.
const Station station{0, 255, {{0x00, 0xf8, 0xa0, 0x01, 0x02, 0x03}}};

/// Structures hold a device in twice its wire size and more, and lists keep a header of their own. A count
/// taken from the message without looking at its size would cost far more.
std::size_t allowance(std::size_t size) { return 256 + 8 * size; }

struct LimitsHold {
    static bool points(qsizetype count) { return count >= 1 && count <= maximumPoints; }

    bool operator()(const ReadRequest& read) const { return points(read.points); }
    bool operator()(const WriteRequest& write) const
    {
        return points(write.words.size() + write.bits.size());
    }
    bool operator()(const ReadRandomRequest& read) const
    {
        return points(read.words.size() + read.doubleWords.size());
    }
    bool operator()(const WriteRandomRequest& write) const
    {
        return points(write.words.size() + write.doubleWords.size() + write.bits.size());
    }
    bool operator()(const SelfTestRequest& test) const
    {
        return !test.data.isEmpty() && test.data.size() <= maximumTestData;
    }
    bool operator()(const IpAddressSetRequest& set) const
    {
        return set.mac == station.mac && set.protocol == protocolUdp &&
               set.hostName.size() <= maximumHostNameToSet;
    }
    template <typename Other>
    bool operator()(const Other&) const
    {
        return true;
    }
};

void asServer(const QByteArray& datagram)
{
    const auto accepted = decodeServerRequest(datagram, station);
    if (accepted) {
        FUZZ_CHECK(datagram.size() <= maximumMessageSize);
        FUZZ_CHECK(encodeRequestFrame(accepted->frame) == datagram);
        const auto encode = [](const auto& request) { return encodeRequest(request); };
        FUZZ_CHECK(std::visit(encode, accepted->request) == accepted->frame.message);
        FUZZ_CHECK(std::visit(LimitsHold(), accepted->request));
        return;
    }
    const auto& [code, asked] = accepted.error();
    if (!code)
        return;
    FUZZ_CHECK(*code != CompleteCode::Success && meaning(*code));
    const auto answer = decodeAnswer(asked, encodeErrorAnswer(asked, *code));
    FUZZ_CHECK(!answer && answer.error().error == ResponseError::Refused);
    FUZZ_CHECK(answer.error().completeCode == *code);
}

/// Changed bytes rarely keep a length that fits. With one that does, the data's decoders see them.
void asServerWithAHeadThatFits(const QByteArray& datagram)
{
    const auto frame = decodeRequestFrame(datagram);
    RequestFrame fitting = frame ? *frame : frame.error().request;
    fitting.route = localStation;
    asServer(encodeRequestFrame(fitting));
}

template <typename Decoded>
void keepsItsBytes(const Decoded& decoded, const QByteArray& data)
{
    FUZZ_CHECK(!decoded || encodeResponse(*decoded) == data);
}

void asRead(const QByteArray& data)
{
    const auto words = quint16(qMin<qsizetype>(data.size() / 2, 0xffff));
    const auto bits = quint16(qMin<qsizetype>(2 * data.size(), 0xffff));
    for (const int points : {int(words), words + 1}) {
        const ReadRequest read{AccessUnit::Word, {}, quint16(points)};
        const auto decoded = decodeReadResponse(read, data);
        FUZZ_CHECK(!decoded || encodeResponse(read, *decoded) == data);
    }
    for (const int points : {int(bits), qMax(0, bits - 1)}) {
        const ReadRequest read{AccessUnit::Bit, {DeviceCode::Output, 0}, quint16(points)};
        const auto decoded = decodeReadResponse(read, data);
        FUZZ_CHECK(!decoded || encodeResponse(read, *decoded) == data);
    }
}

/// `data` as what follows the head of a normal response, to whichever command.
void asData(const QByteArray& data)
{
    asRead(data);
    ReadRandomRequest random;
    random.words = QList<Device>(data.size() % 4 / 2);
    random.doubleWords = QList<Device>(data.size() / 4);
    keepsItsBytes(decodeReadRandomResponse(random, data), data);
    FUZZ_CHECK(decodeEmptyResponse(data).has_value() == data.isEmpty());

    const SelfTestRequest test{data.mid(2)};
    const bool same = decodeSelfTestResponse(test, data).has_value();
    FUZZ_CHECK(!same || encodeResponse(test) == data);

    const ClientAddress client{{{1, 2, 3, 4, 5, 6}}, 0xc0a8010a};
    keepsItsBytes(decodeNodeSearchResponse({client}, data), data);
    IpAddressSetRequest set;
    set.client = client;
    keepsItsBytes(decodeIpAddressSetResponse(set, data), data);
    for (const quint16 targets : {compareEverything, compareVersion})
        keepsItsBytes(decodeDeviceInfoCompareResponse({targets, {}}, data), data);

    // Filling may be spaces or zeros, so here it is the name that stays.
    const auto typeName = decodeReadTypeNameResponse(data);
    FUZZ_CHECK(!typeName || decodeReadTypeNameResponse(encodeResponse(*typeName)) == *typeName);
}

void asClient(const QByteArray& datagram)
{
    const auto response = decodeResponseFrame(datagram);
    if (!response)
        return;
    FUZZ_CHECK(datagram.size() <= maximumMessageSize);
    FUZZ_CHECK(encodeResponseFrame(*response) == datagram);
    FUZZ_CHECK(response->completeCode == CompleteCode::Success || response->data.isEmpty());
    RequestFrame request{response->type, response->serial, response->route, 0, 0, {}};
    request.message.command = response->command;
    request.message.subcommand = response->subcommand;
    if (const auto data = decodeAnswer(request, datagram))
        FUZZ_CHECK(*data == response->data);
    request.route.node ^= 1;
    FUZZ_CHECK(!decodeAnswer(request, datagram));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray datagram(reinterpret_cast<const char*>(data), qsizetype(size));
    const fuzz::AllocationWatch watch;
    asServer(datagram);
    asServerWithAHeadThatFits(datagram);
    asClient(datagram);
    for (const int head : {11, 15, 28}) // where the data of ST, MT and LMT responses begins
        asData(datagram.mid(head));
    FUZZ_CHECK(watch.largest() <= allowance(size));
    return 0;
}
