#pragma once

#include "catalog.h"

#include <QHash>

namespace lds::emulator {

/// Which item answers at which register: the register table of the catalog, by address on the wire.
class ModbusRegisterMap {
public:
    struct Place {
        const catalog::SettingItem* item = nullptr; ///< Nothing at an unmapped or prohibited address.
        int word = 0;                               ///< 0, or 1 for the second half of a 4-byte item.
        bool prohibited = false;                    ///< "Usage prohibited" (§5.2.4)
    };

    ModbusRegisterMap();
    /// Any number: what lies outside the table, or beyond 65535, is unmapped.
    Place at(int address) const;

private:
    QHash<int, Place> m_places;
};

} // namespace lds::emulator
