#include "network_conditions.h"

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

bool firstOctetAllowed(quint32 address)
{
    const quint32 first = address >> 24;
    return first != 0 && first != 127 && first < 224;
}

/// A series of ones, then a series of zeros. Neither may be missing: an empty segment would be all
/// zeros and all ones at once, which the next conditions forbid.
bool maskAllowed(quint32 mask)
{
    const quint32 host = ~mask;
    return mask != 0 && host != 0 && (host & (host + 1)) == 0;
}

bool hostAllowed(quint32 address, quint32 mask)
{
    const quint32 host = address & ~mask;
    return host != 0 && host != ~mask;
}

} // namespace

QString networkObjection(quint32 address, quint32 mask, quint32 gateway)
{
    if (!firstOctetAllowed(address))
        return u"the address's first octet is 0, 127 or 224 to 255 (§5.2.1, 1)"_s;
    if (!maskAllowed(mask))
        return u"the mask is no series of ones followed by zeros (§5.2.1, 2)"_s;
    if (!hostAllowed(address, mask))
        return u"the address's host segment is all zeros or all ones (§5.2.1, 3)"_s;
    if ((address & mask) == 0)
        return u"the address's network segment is all zeros (§5.2.1, 3)"_s;
    if (gateway == 0) // no default gateway
        return {};
    if (!firstOctetAllowed(gateway))
        return u"the gateway's first octet is 0, 127 or 224 to 255 (§5.2.1, 4)"_s;
    if (!hostAllowed(gateway, mask))
        return u"the gateway's host segment is all zeros or all ones (§5.2.1, 5)"_s;
    if ((gateway & mask) != (address & mask))
        return u"the gateway is not in the address's network (§5.2.1, 6)"_s;
    return {};
}

} // namespace lds::emulator
