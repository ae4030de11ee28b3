#pragma once

#include <QMap>

namespace lds::tests {

/// Registers by their address on the wire.
using RegisterImage = QMap<int, int>;

/// What a sensor of the factory holds: the defaults of the catalog, and a measurement.
RegisterImage factoryImage(bool lowWordFirst);

} // namespace lds::tests
