#pragma once

#include <QtGlobal>

/// The codes that end every response (§5.4.3, "Supported complete codes").
namespace lds::slmp {

/// A response may carry any other number, which is then the number and none of these names.
enum class CompleteCode : quint16 {
    Success = 0x0000,
    Command = 0xc059,          ///< Command, or its combination with the subcommand.
    Request = 0xc05c,          ///< A wrong value, another node's address, a write that failed.
    RequestDataSize = 0xc061,  ///< The data's size is not what the message says.
    Busy = 0xcee0,             ///< Another function is in operation.
    RequestTooLarge = 0xcee1,  ///< More than 144 points or 1472 bytes.
    ResponseTooLarge = 0xcee2, ///< The answer would exceed 1472 bytes.
    IpSetting = 0xcf20,        ///< IP Address Set: illegal combination, or a protocol other than UDP.
    Divided = 0xcf44,          ///< A divided LMT message.
};

inline constexpr CompleteCode allCompleteCodes[] = {
    CompleteCode::Success,          CompleteCode::Command,   CompleteCode::Request,
    CompleteCode::RequestDataSize,  CompleteCode::Busy,      CompleteCode::RequestTooLarge,
    CompleteCode::ResponseTooLarge, CompleteCode::IpSetting, CompleteCode::Divided,
};

/// What the table says the code stands for: English, to be translated in the context
/// "SlmpCompleteCode"; null for a code that the table does not have.
const char* meaning(CompleteCode code);

} // namespace lds::slmp
