#include "slmp_complete_code.h"

namespace lds::slmp {

const char* meaning(CompleteCode code)
{
    switch (code) {
    case CompleteCode::Success:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode", "The request has been processed.");
    case CompleteCode::Command:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode", "The command or its subcommand is not supported.");
    case CompleteCode::Request:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode",
                                 "The request has an error, is addressed to another node, or its write "
                                 "was refused.");
    case CompleteCode::RequestDataSize:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode",
                                 "The size of the request's data does not match the size of the message.");
    case CompleteCode::Busy:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode", "Another function of the sensor is in operation.");
    case CompleteCode::RequestTooLarge:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode",
                                 "The request names more than 144 devices or exceeds 1472 bytes.");
    case CompleteCode::ResponseTooLarge:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode", "The response would exceed 1472 bytes.");
    case CompleteCode::IpSetting:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode",
                                 "The combination of IP address, subnet mask and default gateway is not "
                                 "allowed, or the protocol is not UDP.");
    case CompleteCode::Divided:
        return QT_TRANSLATE_NOOP("SlmpCompleteCode", "The sensor does not take divided messages.");
    }
    return nullptr;
}

} // namespace lds::slmp
