#include "frame_reader.h"

namespace lds::modbus {

namespace {
constexpr int shortestPdu = 1;
constexpr int longestPdu = 253; // What FC 03 with 125 registers needs, with room; the Modbus limit.
} // namespace

tl::expected<std::optional<ReceivedFrame>, FrameReader::Fault> FrameReader::next()
{
    if (m_bytes.size() < headerSize)
        return std::nullopt;
    const TcpHeader header = decodeHeader(m_bytes);
    const int pduSize = header.length - 1; // The length counts the unit identifier, too.
    if (header.protocol != 0 || pduSize < shortestPdu || pduSize > longestPdu)
        return tl::unexpected(Fault::Header);
    if (m_bytes.size() < headerSize + pduSize)
        return std::nullopt;
    ReceivedFrame frame{header, m_bytes.first(headerSize + pduSize)};
    m_bytes.remove(0, headerSize + pduSize);
    return frame;
}

} // namespace lds::modbus
