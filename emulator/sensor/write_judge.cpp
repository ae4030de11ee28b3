#include "write_judge.h"

#include "network_conditions.h"

#include <algorithm>
#include <array>

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

constexpr Value reservedPort = 44818;                                       ///< §5.2.1 note 1
constexpr std::array<Value, 3> reservedSlmpPorts{2222, 9090, reservedPort}; ///< §5.4.1 note 4
constexpr Value ownNetwork = 0;                                             ///< §5.4.1 notes 6 and 7
constexpr Value ownNode = 255;
constexpr Value lastNode = 120;
constexpr std::array<Value, 2> furtherNodes{125, 126};

using Judged = tl::expected<void, Objection>;

tl::unexpected<Objection> objection(ItemId item, const QString& reason)
{
    return tl::unexpected(Objection{item, reason});
}

/// §4.4.1: HIGH above LOW, by more than twice the hysteresis.
Judged judgeWindow(const SettingsMemory& memory, int bank)
{
    const qint64 high = memory.value(ItemId::HighSetValue, bank);
    const qint64 low = memory.value(ItemId::LowSetValue, bank);
    const qint64 hysteresis = memory.value(ItemId::Hysteresis, bank);
    if (high <= low)
        return objection(ItemId::HighSetValue, u"HIGH set value is not above LOW set value (§4.4.1)"_s);
    if (high - low <= 2 * hysteresis)
        return objection(ItemId::Hysteresis,
                         u"HIGH and LOW are not more than twice the hysteresis apart (§4.4.1)"_s);
    return {};
}

/// §4.6.2: One Shot only with hold mode None.
Judged judgeTrigger(const SettingsMemory& memory, int bank)
{
    if (memory.value(ItemId::HoldMode, bank) != 0 && memory.value(ItemId::TriggerMode, bank) != 0)
        return objection(ItemId::TriggerMode, u"One Shot needs hold mode None (§4.6.2)"_s);
    return {};
}

/// §5.2.1 notes 1 and 2.
Judged judgePorts(const SettingsMemory& memory)
{
    for (const ItemId id : {ItemId::PortModbus, ItemId::PortTool}) {
        if (memory.value(id) == reservedPort)
            return objection(id, u"port 44818 is used for other purposes (§5.2.1)"_s);
    }
    if (memory.value(ItemId::PortModbus) == memory.value(ItemId::PortTool))
        return objection(ItemId::PortModbus, u"both ports have the same number (§5.2.1)"_s);
    return {};
}

/// §5.4.1 notes 4, 6 and 7: what only the keys reach.
Judged judgeSlmp(const SettingsMemory& memory)
{
    const auto isOneOf = [](const auto& values, Value value) {
        return std::find(values.begin(), values.end(), value) != values.end();
    };
    if (isOneOf(reservedSlmpPorts, memory.value(ItemId::PortSlmp)))
        return objection(ItemId::PortSlmp, u"the port is used for other purposes (§5.4.1)"_s);
    const Value node = memory.value(ItemId::NodeNumber);
    const bool isFurther = (node >= 1 && node <= lastNode) || isOneOf(furtherNodes, node);
    if (memory.value(ItemId::NetworkNumber) == ownNetwork ? node != ownNode : !isFurther)
        return objection(ItemId::NodeNumber, u"the network has no such node (§5.4.1)"_s);
    return {};
}

/// §5.2.1 "IP setting conditions"; §5.1.1: every change judges the whole combination.
Judged judgeNetwork(const SettingsMemory& memory)
{
    const auto address = [&memory](ItemId first, ItemId second, ItemId third, ItemId fourth) {
        return quint32(memory.value(first)) << 24 | quint32(memory.value(second)) << 16 |
               quint32(memory.value(third)) << 8 | quint32(memory.value(fourth));
    };
    const quint32 ip = address(ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet,
                               ItemId::IpAddress3rdOctet, ItemId::IpAddress4thOctet);
    const quint32 mask = address(ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet,
                                 ItemId::SubnetMask3rdOctet, ItemId::SubnetMask4thOctet);
    const quint32 gateway = address(ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                                    ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet);
    if (const QString reason = networkObjection(ip, mask, gateway); !reason.isEmpty())
        return objection(ItemId::IpAddress1stOctet, reason);
    return {};
}

bool writesOneOf(const QList<ItemWrite>& writes, std::initializer_list<ItemId> items)
{
    return std::any_of(writes.begin(), writes.end(), [&items](const ItemWrite& write) {
        return std::find(items.begin(), items.end(), write.item) != items.end();
    });
}

bool writesNetwork(const QList<ItemWrite>& writes)
{
    return std::any_of(writes.begin(), writes.end(),
                       [](const ItemWrite& write) { return hlG2(write.item).group != WriteGroup::None; });
}

/// The conditions between items that these writes touch, judged of the state they lead to.
Judged judgeTogether(const SettingsMemory& after, const QList<ItemWrite>& writes)
{
    const int bank = after.bank();
    Judged judged;
    if (writesOneOf(writes, {ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis}))
        judged = judgeWindow(after, bank);
    // Hysteresis itself may be set regardless of the tolerance (§4.4.5).
    if (judged && writesOneOf(writes, {ItemId::Tolerance}) &&
        after.value(ItemId::Tolerance) <= after.value(ItemId::Hysteresis))
        judged = objection(ItemId::Tolerance, u"tolerance is not above the hysteresis (§4.4.5)"_s);
    if (judged && writesOneOf(writes, {ItemId::HoldMode, ItemId::TriggerMode}))
        judged = judgeTrigger(after, bank);
    if (judged && writesOneOf(writes, {ItemId::PortModbus, ItemId::PortTool}))
        judged = judgePorts(after);
    if (judged && writesOneOf(writes, {ItemId::PortSlmp, ItemId::NetworkNumber, ItemId::NodeNumber}))
        judged = judgeSlmp(after);
    if (judged && writesNetwork(writes))
        judged = judgeNetwork(after);
    return judged;
}

} // namespace

tl::expected<Value, Objection> judgeValue(SensorModel model, ItemWrite write)
{
    const SettingItem& item = hlG2(write.item);
    const Limits& limits = item.limitsFor(model);
    if (item.kind == Kind::Trigger && write.value != 0)
        return objection(item.id, u"%1 is reserved; 0 executes"_s.arg(write.value));
    if (!item.choices.empty()) {
        const bool known = std::any_of(item.choices.begin(), item.choices.end(), [&](const Choice& choice) {
            return choice.code == write.value && (choice.models & maskOf(model));
        });
        if (!known)
            return objection(item.id, u"%1 is none of its choices"_s.arg(write.value));
        return write.value;
    }
    if (item.kind != Kind::Trigger && (write.value < limits.minimum || write.value > limits.maximum)) {
        return objection(
            item.id, u"%1 is outside %2 to %3"_s.arg(write.value).arg(limits.minimum).arg(limits.maximum));
    }
    return write.value - write.value % std::max<Value>(1, limits.resolution);
}

tl::expected<QList<ItemWrite>, Objection> judgeWrites(const SettingsMemory& memory,
                                                      const QList<ItemWrite>& writes)
{
    QList<ItemWrite> rounded;
    SettingsMemory after = memory;
    for (const ItemWrite& write : writes) {
        const auto value = judgeValue(memory.model(), write);
        if (!value)
            return tl::unexpected(value.error());
        rounded.append({write.item, *value});
        if (SettingsMemory::holds(hlG2(write.item)))
            after.setValue(write.item, *value);
    }
    // §4.3.4: a hold mode other than None turns One Shot into Hold by itself.
    if (writesOneOf(writes, {ItemId::HoldMode}) && !writesOneOf(writes, {ItemId::TriggerMode}) &&
        after.value(ItemId::HoldMode) != 0)
        after.setValue(ItemId::TriggerMode, 0);
    if (const Judged judged = judgeTogether(after, writes); !judged)
        return tl::unexpected(judged.error());
    return rounded;
}

tl::expected<void, Objection> judgeStored(const SettingsMemory& memory, int bank)
{
    Judged judged = judgeWindow(memory, bank);
    if (judged)
        judged = judgeTrigger(memory, bank);
    if (judged)
        judged = judgePorts(memory);
    if (judged)
        judged = judgeSlmp(memory);
    if (judged)
        judged = judgeNetwork(memory);
    return judged;
}

} // namespace lds::emulator
