#include "answer_failure.h"

namespace lds::modbus {

using ports::Failure;
using ports::FailureCode;

FailureCode refusalOf(quint8 exceptionCode)
{
    switch (Exception(exceptionCode)) {
    case Exception::FunctionCode:
        return FailureCode::FunctionNotSupported;
    case Exception::Address:
        return FailureCode::AddressRefused;
    case Exception::Data:
        return FailureCode::ValueRefused;
    case Exception::Other:
        return FailureCode::NotReady;
    }
    return FailureCode::OtherRefusal;
}

QString wordOf(ResponseError error)
{
    switch (error) {
    case ResponseError::Empty:
        return QStringLiteral("short");
    case ResponseError::Function:
        return QStringLiteral("function");
    case ResponseError::Length:
        return QStringLiteral("length");
    case ResponseError::Echo:
        return QStringLiteral("echo");
    case ResponseError::Refused:
        break;
    }
    return QString();
}

Failure malformed(const QString& what) { return Failure{FailureCode::Malformed, 0, what}; }

} // namespace lds::modbus
