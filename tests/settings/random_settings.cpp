#include "random_settings.h"

#include "settings_text.h"
#include "value_text.h"

#include <algorithm>

namespace lds::settings::test {

using catalog::Kind;
using catalog::SettingItem;
using catalog::WriteGroup;

namespace {

bool isSetting(const SettingItem& item) { return item.role == catalog::Role::Setting && item.isWritable(); }

QString dotted(quint32 address)
{
    return QStringLiteral("%1.%2.%3.%4")
        .arg(address >> 24)
        .arg(address >> 16 & 255)
        .arg(address >> 8 & 255)
        .arg(address & 255);
}

void put(Values& values, WriteGroup group, quint32 address)
{
    values.insert(test::address(group, dotted(address).toLatin1()));
}

} // namespace

RandomSettings::RandomSettings(catalog::SensorModel model, quint32 seed)
    : m_model(model)
    , m_random(seed)
{}

int RandomSettings::below(int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(m_random); }

Value RandomSettings::legalValue(const SettingItem& item)
{
    const catalog::Limits& limits = item.limitsFor(m_model);
    if (item.kind == Kind::Choice) {
        for (;;) {
            const catalog::Choice& choice = item.choices[std::size_t(below(int(item.choices.size())))];
            if (choice.models & catalog::maskOf(m_model))
                return choice.code;
        }
    }
    const Value span = limits.maximum - limits.minimum;
    const Value value = oneIn(8)   ? limits.minimum
                        : oneIn(8) ? limits.maximum
                        : oneIn(3) ? limits.minimum + below(std::min(span, 20 * limits.resolution) + 1)
                                   : limits.minimum + below(span + 1);
    return std::max(limits.minimum, effectiveValue(item, m_model, value));
}

/// HIGH above LOW and a hysteresis that is often as large as the window allows.
void RandomSettings::makeWindow(Values& values)
{
    const SettingItem& high = catalog::hlG2(ItemId::HighSetValue);
    const Value step = high.limitsFor(m_model).resolution;
    Value top = legalValue(high);
    Value bottom = legalValue(catalog::hlG2(ItemId::LowSetValue));
    if (top < bottom)
        std::swap(top, bottom);
    if (top == bottom && top == high.limitsFor(m_model).minimum)
        top += step;
    else if (top == bottom)
        bottom -= step;
    const Value largestHysteresis = (top - bottom - 1) / 2;
    const Value hysteresis = oneIn(3) ? largestHysteresis : oneIn(3) ? 0 : below(largestHysteresis + 1);
    values[ItemId::HighSetValue] = top;
    values[ItemId::LowSetValue] = bottom;
    values[ItemId::Hysteresis] = effectiveValue(catalog::hlG2(ItemId::Hysteresis), m_model, hysteresis);
}

void RandomSettings::makeTolerance(Values& values)
{
    const catalog::Limits& limits = catalog::hlG2(ItemId::Tolerance).limitsFor(m_model);
    if (!oneIn(4)) // often just about the hysteresis
        values[ItemId::Tolerance] = std::clamp(
            values[ItemId::Hysteresis] + (below(5) - 2) * limits.resolution, limits.minimum, limits.maximum);
}

void RandomSettings::makePorts(Values& values)
{
    const QList<Value> popular{502, 503, 49'152, 49'153, 49'154, 44'817, 1, 65'535};
    const auto port = [&] { return oneIn(3) ? 1 + below(44'000) : popular[below(int(popular.size()))]; };
    values[ItemId::PortModbus] = port();
    do
        values[ItemId::PortTool] = port();
    while (values[ItemId::PortTool] == values[ItemId::PortModbus]);
}

quint32 RandomSettings::mask()
{
    const int hostBits = oneIn(2) ? 8 : 2 + below(30);
    return quint32(~0ULL << hostBits);
}

/// A valid host address in that mask, by trying.
quint32 RandomSettings::addressIn(quint32 mask)
{
    for (;;) {
        const quint32 noise = m_random();
        const quint32 address = oneIn(2) ? 0xc0a80100 | (noise & 0xff) : noise;
        const quint32 first = address >> 24;
        const quint32 host = address & ~mask;
        if (first != 0 && first != 127 && first < 224 && host != 0 && host != ~mask && (address & mask) != 0)
            return address;
    }
}

void RandomSettings::makeNetwork(Values& values)
{
    const quint32 bits = mask();
    const quint32 address = addressIn(bits);
    quint32 gateway = 0;
    for (int attempt = 0; attempt < 50 && !oneIn(4); ++attempt) {
        const quint32 candidate = (address & bits) | (m_random() & ~bits);
        const quint32 first = candidate >> 24;
        const quint32 host = candidate & ~bits;
        if (first != 0 && first != 127 && first < 224 && host != 0 && host != ~bits) {
            gateway = candidate;
            break;
        }
    }
    put(values, WriteGroup::IpAddress, address);
    put(values, WriteGroup::SubnetMask, bits);
    put(values, WriteGroup::DefaultGateway, gateway);
}

Values RandomSettings::state()
{
    Values values;
    for (const SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (isSetting(item))
            values[item.id] = legalValue(item);
    }
    makeWindow(values);
    makeTolerance(values);
    makePorts(values);
    makeNetwork(values);
    if (values[ItemId::HoldMode] != 0)
        values[ItemId::TriggerMode] = 0;
    return values;
}

Values RandomSettings::brokenState()
{
    Values values = state();
    if (oneIn(2)) {
        for (const ItemId item : {ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis})
            values[item] = legalValue(catalog::hlG2(item));
    }
    if (oneIn(2))
        values[ItemId::TriggerMode] = 1;
    if (oneIn(2))
        values[ItemId::PortTool] = oneIn(2) ? 44'818 : values[ItemId::PortModbus];
    if (oneIn(3))
        put(values, WriteGroup::SubnetMask, oneIn(3) ? 0xff00ff00 : quint32(~0ULL << below(33)));
    if (oneIn(3))
        put(values, WriteGroup::IpAddress, m_random() & quint32(~0ULL << below(33)));
    if (oneIn(3))
        put(values, WriteGroup::DefaultGateway, m_random());
    return values;
}

Values RandomSettings::wish(const Values& current)
{
    const Values other = state();
    const int oneOf = 1 + below(6);
    Values wanted;
    for (const SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (!isSetting(item) || !oneIn(oneOf))
            continue;
        Value value = oneIn(10) ? current.value(item.id) : other.value(item.id);
        if (oneIn(6) && value > 0)
            value += below(item.limitsFor(m_model).resolution);
        if (oneIn(100))
            value = item.limitsFor(m_model).maximum + 1 + below(1'000);
        wanted[item.id] = value;
    }
    if (oneIn(6)) {
        wanted[ItemId::PortModbus] = current.value(ItemId::PortTool);
        wanted[ItemId::PortTool] = current.value(ItemId::PortModbus);
    }
    if (oneIn(2)) { // a whole new network, as people set it
        for (const SettingItem& item : catalog::Catalog::hlG2().items()) {
            if (item.group != WriteGroup::None)
                wanted[item.id] = other.value(item.id);
        }
    }
    return wanted;
}

} // namespace lds::settings::test
