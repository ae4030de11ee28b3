#include "item_text.h"
#include "sentence_parts.h"
#include "sentences.h"

namespace lds::ui {

using catalog::ItemId;
using catalog::SettingItem;
using settings::Rule;
using settings::Values;

namespace {

const SettingItem& describe(ItemId id) { return catalog::Catalog::hlG2().item(id); }

/// The value with its unit, "?" while it is not known.
QString held(const Values& state, ItemId id, catalog::SensorModel model)
{
    const auto found = state.constFind(id);
    return found == state.constEnd() ? QStringLiteral("?")
                                     : displayValueWithUnit(describe(id), model, found.value());
}

/// A difference of lengths, written as the item of the same unit would be.
QString lengthOf(catalog::Value value, catalog::SensorModel model)
{
    return displayValueWithUnit(describe(ItemId::Hysteresis), model, value);
}

QString itemNames(const QList<ItemId>& items)
{
    QStringList names;
    for (const ItemId id : items)
        names += itemName(describe(id));
    return names.join(QStringLiteral(", "));
}

QString address(const Values& state, const QList<ItemId>& octets)
{
    QList<catalog::Value> values;
    for (const ItemId id : octets) {
        if (!state.contains(id))
            return QStringLiteral("?");
        values += state.value(id);
    }
    return octetsText(values);
}

QString ipAddress(const Values& state)
{
    return address(state, {ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet, ItemId::IpAddress3rdOctet,
                           ItemId::IpAddress4thOctet});
}
QString subnetMask(const Values& state)
{
    return address(state, {ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet, ItemId::SubnetMask3rdOctet,
                           ItemId::SubnetMask4thOctet});
}
QString gateway(const Values& state)
{
    return address(state, {ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                           ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet});
}

QString windowSentence(const Values& state, catalog::SensorModel model)
{
    if (!state.contains(ItemId::HighSetValue) || !state.contains(ItemId::LowSetValue) ||
        !state.contains(ItemId::Hysteresis))
        return Sentences::tr("HIGH − LOW must be more than twice the hysteresis. Move HIGH and LOW apart or "
                             "lower the hysteresis.");
    const qint64 window =
        qint64(state.value(ItemId::HighSetValue)) - qint64(state.value(ItemId::LowSetValue));
    const qint64 needed = 2 * qint64(state.value(ItemId::Hysteresis));
    return Sentences::tr("HIGH − LOW is %1 and must be more than %2, twice the hysteresis. Move HIGH and LOW "
                         "apart or lower the hysteresis.")
        .arg(lengthOf(catalog::Value(window), model), lengthOf(catalog::Value(needed), model));
}

QString addressSentence(Rule rule, const Values& state)
{
    switch (rule) {
    case Rule::AddressFirstOctet:
        return Sentences::tr(
                   "IP address %1: the first number must not be 0, 127 or 224 to 255. Enter another "
                   "address.")
            .arg(ipAddress(state));
    case Rule::MaskNotContiguous:
        return Sentences::tr("Subnet mask %1: in binary it must be ones followed by zeros, such as "
                             "255.255.255.0.")
            .arg(subnetMask(state));
    case Rule::AddressHostBits:
        return Sentences::tr("IP address %1 with mask %2: the host part is all zeros or all ones. Change the "
                             "last numbers of the address.")
            .arg(ipAddress(state), subnetMask(state));
    case Rule::AddressNetworkBits:
        return Sentences::tr(
                   "IP address %1 with mask %2: the network part is all zeros. Change the address or "
                   "the mask.")
            .arg(ipAddress(state), subnetMask(state));
    case Rule::GatewayFirstOctet:
        return Sentences::tr("Default gateway %1: the first number must not be 0, 127 or 224 to 255. Enter "
                             "another, or 0.0.0.0 for none.")
            .arg(gateway(state));
    case Rule::GatewayHostBits:
        return Sentences::tr("Default gateway %1 with mask %2: the host part is all zeros or all ones. Enter "
                             "the gateway's own address, or 0.0.0.0 for none.")
            .arg(gateway(state), subnetMask(state));
    case Rule::GatewayOtherNetwork:
        return Sentences::tr(
                   "Default gateway %1 is not in the network of %2 (mask %3). Change one of them, or "
                   "enter 0.0.0.0 for no gateway.")
            .arg(gateway(state), ipAddress(state), subnetMask(state));
    default:
        return {};
    }
}

QString itemSentence(const settings::Refusal& refusal, catalog::SensorModel model, const Values& state)
{
    if (refusal.items.isEmpty())
        return {};
    const SettingItem& item = describe(refusal.items.first());
    const QString name = itemName(item);
    switch (refusal.rule) {
    case Rule::NotWritable:
        return Sentences::tr("%1 cannot be written. Undo this edit.").arg(name);
    case Rule::OutOfRange:
        return Sentences::tr("%1: %2 is out of range for this type. Enter a value: %3.")
            .arg(name, held(state, item.id, model), limitsText(item, model));
    case Rule::NotAChoice:
        return Sentences::tr("%1: this type does not have the choice %2. Choose one of: %3.")
            .arg(name, held(state, item.id, model), rangeText(item, model));
    default:
        return {};
    }
}

} // namespace

QString limitsText(const SettingItem& item, catalog::SensorModel model)
{
    const auto& limits = item.limitsFor(model);
    return Sentences::tr("from %1 to %2")
        .arg(displayValue(item, model, limits.minimum), displayValueWithUnit(item, model, limits.maximum));
}

QString refusalSentence(const settings::Refusal& refusal, catalog::SensorModel model, const Values& state)
{
    switch (refusal.rule) {
    case Rule::NotWritable:
    case Rule::OutOfRange:
    case Rule::NotAChoice:
        return itemSentence(refusal, model, state);
    case Rule::HighNotAboveLow:
        return Sentences::tr("HIGH set value %1 must be greater than LOW set value %2. Raise HIGH or lower "
                             "LOW.")
            .arg(held(state, ItemId::HighSetValue, model), held(state, ItemId::LowSetValue, model));
    case Rule::WindowNotOverHysteresis:
        return windowSentence(state, model);
    case Rule::ToleranceNotOverHysteresis:
        return Sentences::tr("Tolerance %1 must be greater than the hysteresis %2. Raise the tolerance or "
                             "lower the hysteresis.")
            .arg(held(state, ItemId::Tolerance, model), held(state, ItemId::Hysteresis, model));
    case Rule::OneShotNeedsNormalHold:
        return Sentences::tr(
                   "Trigger mode One Shot works only with hold mode None; it is %1 here. Change one "
                   "of them.")
            .arg(held(state, ItemId::HoldMode, model));
    case Rule::PortReserved:
        return Sentences::tr("%1: port 44818 belongs to EtherNet/IP. Choose another port.")
            .arg(itemNames(refusal.items.mid(0, 1)));
    case Rule::PortsEqual:
        return Sentences::tr("The Modbus port and the tool port are both %1 and must differ. Change one of "
                             "them.")
            .arg(held(state, ItemId::PortModbus, model));
    case Rule::GroupIncomplete:
        return Sentences::tr("%1: the four numbers of an address are written together. Enter all four.")
            .arg(itemNames(refusal.items));
    default:
        return addressSentence(refusal.rule, state);
    }
}

} // namespace lds::ui
