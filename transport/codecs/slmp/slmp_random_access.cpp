#include "slmp_random_access.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

namespace {

constexpr int wordEntrySize = deviceSize + 2;
constexpr int doubleWordEntrySize = deviceSize + 4;
constexpr int bitEntrySize = deviceSize + 1;

struct Counts {
    int words = 0;
    int doubleWords = 0;
};

/// The counts in front of words and double words, and that exactly their entries follow.
tl::expected<Counts, CompleteCode> decodeCounts(Reader& reader, int wordEntry, int doubleWordEntry)
{
    const Counts counts{reader.u8(), reader.u8()};
    if (reader.failed())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (const auto refused = checkPoints(counts.words + counts.doubleWords))
        return tl::unexpected(*refused);
    if (reader.left() != wordEntry * counts.words + doubleWordEntry * counts.doubleWords)
        return tl::unexpected(CompleteCode::RequestDataSize);
    return counts;
}

bool isRefused(const Device& device, AccessUnit unit) { return checkDevices(device, 1, unit).has_value(); }

tl::expected<WriteRandomRequest, CompleteCode> decodeWriteWords(Reader& reader)
{
    const auto counts = decodeCounts(reader, wordEntrySize, doubleWordEntrySize);
    if (!counts)
        return tl::unexpected(counts.error());
    WriteRandomRequest request;
    request.words.reserve(counts->words);
    request.doubleWords.reserve(counts->doubleWords);
    bool refused = false;
    for (int i = 0; i < counts->words; ++i) {
        const Device device = readDevice(reader);
        request.words.append({device, reader.u16()});
        refused |= isRefused(device, AccessUnit::Word);
    }
    for (int i = 0; i < counts->doubleWords; ++i) {
        const Device device = readDevice(reader);
        request.doubleWords.append({device, reader.u32()});
        refused |= isRefused(device, AccessUnit::DoubleWord);
    }
    if (refused)
        return tl::unexpected(CompleteCode::Request);
    return request;
}

tl::expected<WriteRandomRequest, CompleteCode> decodeWriteBits(Reader& reader)
{
    const int count = reader.u8();
    if (reader.failed())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (const auto refused = checkPoints(count))
        return tl::unexpected(*refused);
    if (reader.left() != bitEntrySize * count)
        return tl::unexpected(CompleteCode::RequestDataSize);
    WriteRandomRequest request;
    request.bits.reserve(count);
    bool refused = false;
    for (int i = 0; i < count; ++i) {
        const Device device = readDevice(reader);
        const quint8 state = reader.u8();
        request.bits.append({device, state == 1});
        refused |= state > 1 || isRefused(device, AccessUnit::Bit);
    }
    if (refused)
        return tl::unexpected(CompleteCode::Request);
    return request;
}

} // namespace

Message encodeRequest(const ReadRandomRequest& request)
{
    Writer writer;
    writer.u8(quint8(request.words.size())).u8(quint8(request.doubleWords.size()));
    for (const Device& device : request.words)
        writeDevice(writer, device);
    for (const Device& device : request.doubleWords)
        writeDevice(writer, device);
    return {Command::ReadRandom, wordSubcommand, writer.result()};
}

tl::expected<ReadRandomRequest, CompleteCode> decodeReadRandomRequest(const Message& message)
{
    if (message.subcommand != wordSubcommand)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    const auto counts = decodeCounts(reader, deviceSize, deviceSize);
    if (!counts)
        return tl::unexpected(counts.error());
    ReadRandomRequest request;
    request.words.reserve(counts->words);
    request.doubleWords.reserve(counts->doubleWords);
    bool refused = false;
    for (int i = 0; i < counts->words; ++i) {
        request.words.append(readDevice(reader));
        refused |= isRefused(request.words.last(), AccessUnit::Word);
    }
    for (int i = 0; i < counts->doubleWords; ++i) {
        request.doubleWords.append(readDevice(reader));
        refused |= isRefused(request.doubleWords.last(), AccessUnit::DoubleWord);
    }
    if (refused)
        return tl::unexpected(CompleteCode::Request);
    return request;
}

QByteArray encodeResponse(const ReadRandomResponse& response)
{
    Writer writer;
    for (const quint16 word : response.words)
        writer.u16(word);
    for (const quint32 doubleWord : response.doubleWords)
        writer.u32(doubleWord);
    return writer.result();
}

tl::expected<ReadRandomResponse, ResponseFailure> decodeReadRandomResponse(const ReadRandomRequest& request,
                                                                           const QByteArray& data)
{
    if (data.size() != 2 * request.words.size() + 4 * request.doubleWords.size())
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    Reader reader(data);
    ReadRandomResponse response;
    response.words.reserve(request.words.size());
    response.doubleWords.reserve(request.doubleWords.size());
    for (qsizetype i = 0; i < request.words.size(); ++i)
        response.words.append(reader.u16());
    for (qsizetype i = 0; i < request.doubleWords.size(); ++i)
        response.doubleWords.append(reader.u32());
    return response;
}

Message encodeRequest(const WriteRandomRequest& request)
{
    Writer writer;
    if (!request.bits.isEmpty()) {
        writer.u8(quint8(request.bits.size()));
        for (const BitValue& bit : request.bits) {
            writeDevice(writer, bit.device);
            writer.u8(bit.value ? 1 : 0);
        }
        return {Command::WriteRandom, bitSubcommand, writer.result()};
    }
    writer.u8(quint8(request.words.size())).u8(quint8(request.doubleWords.size()));
    for (const WordValue& word : request.words) {
        writeDevice(writer, word.device);
        writer.u16(word.value);
    }
    for (const DoubleWordValue& doubleWord : request.doubleWords) {
        writeDevice(writer, doubleWord.device);
        writer.u32(doubleWord.value);
    }
    return {Command::WriteRandom, wordSubcommand, writer.result()};
}

tl::expected<WriteRandomRequest, CompleteCode> decodeWriteRandomRequest(const Message& message)
{
    Reader reader(message.data);
    switch (message.subcommand) {
    case wordSubcommand:
        return decodeWriteWords(reader);
    case bitSubcommand:
        return decodeWriteBits(reader);
    default:
        return tl::unexpected(CompleteCode::Command);
    }
}

} // namespace lds::slmp
