#include "register_image.h"

#include "catalog.h"

namespace lds::tests {

RegisterImage factoryImage(bool lowWordFirst)
{
    using catalog::ItemId;
    RegisterImage image;
    const auto put = [&](const catalog::SettingItem& item, catalog::Value value) {
        const int address = item.modbus->number - 400001;
        if (item.size == 4) {
            image[address + (lowWordFirst ? 0 : 1)] = int(quint32(value) & 0xffff);
            image[address + (lowWordFirst ? 1 : 0)] = int(quint32(value) >> 16);
        } else {
            image[address] = value;
        }
    };
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.modbus && item.isReadable())
            put(item, item.hasDefault ? item.limits.front().defaultValue : 0);
    }
    put(catalog::hlG2(ItemId::MeasuredValue), -12'345);
    put(catalog::hlG2(ItemId::PeakIntensity), 600);
    put(catalog::hlG2(ItemId::SensorState), 0x0408); // Laser, GO
    return image;
}

} // namespace lds::tests
