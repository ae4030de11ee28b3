#include "modbus_register_map.h"

namespace lds::emulator {

using namespace catalog;

ModbusRegisterMap::ModbusRegisterMap()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        for (int word = 0; item.modbus && word < item.registerCount(); ++word)
            m_places.insert(item.modbus->address() + word, Place{&item, word, false});
    }
}

ModbusRegisterMap::Place ModbusRegisterMap::at(int address) const
{
    const auto place = m_places.constFind(address);
    if (place != m_places.constEnd())
        return *place;
    return Place{nullptr, 0, address <= 0xffff && Catalog::hlG2().isUsageProhibited(quint16(address))};
}

} // namespace lds::emulator
