#include "measurement.h"

#include "catalog.h"

namespace lds::measurement {

ValueKind kindOf(Value wireValue)
{
    switch (wireValue) {
    case catalog::sentinel::over:
        return ValueKind::Over;
    case catalog::sentinel::under:
        return ValueKind::Under;
    case catalog::sentinel::indeterminate:
        return ValueKind::Indeterminate;
    case catalog::sentinel::alarm:
        return ValueKind::Alarm;
    default:
        return ValueKind::Valid;
    }
}

} // namespace lds::measurement
