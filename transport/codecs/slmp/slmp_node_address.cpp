#include "slmp_node_address.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

HardwareAddress readHardwareAddress(Reader& reader)
{
    HardwareAddress address;
    for (auto octet = address.octets.rbegin(); octet != address.octets.rend(); ++octet)
        *octet = reader.u8();
    return address;
}

void writeHardwareAddress(Writer& writer, const HardwareAddress& address)
{
    for (auto octet = address.octets.rbegin(); octet != address.octets.rend(); ++octet)
        writer.u8(*octet);
}

} // namespace lds::slmp
