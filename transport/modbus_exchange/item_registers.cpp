#include "item_registers.h"

#include <algorithm>

namespace lds::modbus {

namespace {

using catalog::ItemId;
using catalog::SettingItem;
using catalog::Value;

struct ItemPlace {
    int first = 0;
    int end = 0; ///< One past the last register.
};

ItemPlace placeOf(const SettingItem& item)
{
    const int first = item.modbus->address();
    return {first, first + item.registerCount()};
}

bool canRead(const SettingItem& item) { return item.modbus && item.isReadable(); }

/// The bits of a state register that mean something (§5.2.5): the others read as anything.
quint16 meaningfulBits(quint16 address)
{
    quint16 bits = 0;
    for (const catalog::Coil& coil : catalog::Catalog::hlG2().coils()) {
        const int index = coil.number - 1;
        if (catalog::hlG2(ItemId::SensorState).modbus->address() + index / 16 == address && !coil.reserved())
            bits |= quint16(1U << (index % 16));
    }
    return bits;
}

tl::unexpected<ports::Failure> refused(ports::FailureCode code, const QString& detail)
{
    return tl::unexpected(ports::Failure{code, 0, detail});
}

QString keyOf(const SettingItem& item) { return QString::fromLatin1(item.key); }

/// Why an item cannot be written, whatever else is in the message.
std::optional<ports::Failure> objection(const settings::ItemValue& wanted)
{
    const SettingItem& item = catalog::hlG2(wanted.item);
    if (!item.modbus)
        return ports::Failure{ports::FailureCode::NotReachable, 0,
                              keyOf(item) + QLatin1String(" has no register")};
    if (!item.isWritable())
        return ports::Failure{ports::FailureCode::AddressRefused, 0,
                              keyOf(item) + QLatin1String(" is read only")};
    const Value largest = item.size == 1 ? 0xff : 0xffff;
    if (item.size != 4 && (wanted.value < 0 || wanted.value > largest))
        return ports::Failure{
            ports::FailureCode::ValueRefused, 0,
            QStringLiteral("%1: %2 does not fit its register").arg(keyOf(item)).arg(wanted.value)};
    return std::nullopt;
}

bool makeOneGroup(const settings::Write& write)
{
    const catalog::WriteGroup group = catalog::hlG2(write.first().item).group;
    return group != catalog::WriteGroup::None &&
           std::ranges::all_of(write, [group](const settings::ItemValue& wanted) {
               return catalog::hlG2(wanted.item).group == group;
           });
}

QList<quint16> registersOf(const settings::ItemValue& wanted, bool lowWordFirst)
{
    if (catalog::hlG2(wanted.item).size == 4)
        return fromInt32(wanted.value, lowWordFirst);
    return {quint16(wanted.value)};
}

} // namespace

QList<RegisterRange> packReads(const QList<ItemId>& items)
{
    QList<ItemPlace> places;
    for (const ItemId id : items) {
        if (const SettingItem& item = catalog::hlG2(id); canRead(item))
            places.append(placeOf(item));
    }
    std::ranges::sort(places, {}, &ItemPlace::first);

    // Always beginning at the first item left and reaching as far as one read may is the fewest.
    QList<RegisterRange> ranges;
    for (const ItemPlace& place : std::as_const(places)) {
        if (ranges.isEmpty() || place.end - ranges.constLast().first > maximumReadRegisters)
            ranges.append(RegisterRange{quint16(place.first), 0});
        RegisterRange& range = ranges.last();
        range.count = quint16(std::max<int>(range.count, place.end - range.first));
    }
    return ranges;
}

Request readRequest(const RegisterRange& range)
{
    return Request{Function::ReadHoldingRegisters, range.first, range.count, {}};
}

Value decodeItem(const SettingItem& item, const QList<quint16>& registers, qsizetype index, bool lowWordFirst)
{
    if (item.size == 4)
        return toInt32(registers.at(index), registers.at(index + 1), lowWordFirst);
    if (item.kind == catalog::Kind::Bits)
        return registers.at(index) & meaningfulBits(item.modbus->address());
    return registers.at(index);
}

settings::Values decodeItems(const QList<ItemId>& items, const RegisterRange& range,
                             const QList<quint16>& registers, bool lowWordFirst)
{
    settings::Values values;
    if (registers.size() != range.count)
        return values;
    for (const ItemId id : items) {
        const SettingItem& item = catalog::hlG2(id);
        if (!canRead(item))
            continue;
        const ItemPlace place = placeOf(item);
        if (place.first >= range.first && place.end <= range.end())
            values.insert(id, decodeItem(item, registers, place.first - range.first, lowWordFirst));
    }
    return values;
}

tl::expected<Request, ports::Failure> encodeWrite(const settings::Write& write, bool lowWordFirst)
{
    if (write.isEmpty())
        return refused(ports::FailureCode::OtherRefusal, QStringLiteral("nothing to write"));
    for (const settings::ItemValue& wanted : write) {
        if (const auto why = objection(wanted))
            return tl::unexpected(*why);
    }
    if (write.size() > 1 && !makeOneGroup(write))
        return refused(ports::FailureCode::OtherRefusal,
                       QStringLiteral("items that do not go together in one message"));

    settings::Write ascending = write;
    std::ranges::sort(ascending, {}, [](const settings::ItemValue& wanted) {
        return placeOf(catalog::hlG2(wanted.item)).first;
    });
    const int first = placeOf(catalog::hlG2(ascending.first().item)).first;
    Request request{Function::WriteMultipleRegisters, quint16(first), 0, {}};
    for (const settings::ItemValue& wanted : std::as_const(ascending)) {
        if (placeOf(catalog::hlG2(wanted.item)).first != first + request.registers.size())
            return refused(ports::FailureCode::OtherRefusal,
                           QStringLiteral("registers that do not lie together"));
        request.registers += registersOf(wanted, lowWordFirst);
    }
    request.count = quint16(request.registers.size());
    if (request.count == 1)
        request.function = Function::WriteSingleRegister;
    return request;
}

const RegisterRange& measurementRange()
{
    static const RegisterRange range =
        packReads({ItemId::SensorState, ItemId::SelfMonitoringNotification, ItemId::SelfMonitoringCaution,
                   ItemId::SelfMonitoringError, ItemId::ErrorCode, ItemId::MeasuredValue,
                   ItemId::PeakIntensity})
            .constFirst();
    return range;
}

measurement::Measurement decodeMeasurement(const QList<quint16>& registers, bool lowWordFirst)
{
    constexpr quint16 largestIntensity = 1023; // §5.2.4, 400022
    Q_ASSERT(registers.size() == measurementRange().count);
    // Two constants of each item, looked up once: this runs a hundred times a second and more.
    struct Field {
        explicit Field(ItemId id)
            : index(catalog::hlG2(id).modbus->address() - measurementRange().first)
            , mask(catalog::hlG2(id).kind == catalog::Kind::Bits
                       ? meaningfulBits(catalog::hlG2(id).modbus->address())
                       : quint16(0xffff))
        {}
        quint16 in(const QList<quint16>& words) const { return words.at(index) & mask; }
        qsizetype index;
        quint16 mask;
    };
    static const Field state(ItemId::SensorState);
    static const Field notification(ItemId::SelfMonitoringNotification);
    static const Field caution(ItemId::SelfMonitoringCaution);
    static const Field error(ItemId::SelfMonitoringError);
    static const Field errorCode(ItemId::ErrorCode);
    static const Field value(ItemId::MeasuredValue);
    static const Field intensity(ItemId::PeakIntensity);

    measurement::Measurement sample;
    sample.state = state.in(registers);
    sample.notification = notification.in(registers);
    sample.caution = caution.in(registers);
    sample.error = error.in(registers);
    sample.errorCode = errorCode.in(registers);
    sample.value = toInt32(registers.at(value.index), registers.at(value.index + 1), lowWordFirst);
    sample.kind = measurement::kindOf(sample.value);
    sample.intensity = intensity.in(registers);
    if (sample.intensity > largestIntensity)
        sample.intensity = catalog::sentinel::noIntensity;
    return sample;
}

std::optional<bool> lowWordFirstBySpan(quint16 first, quint16 second)
{
    const catalog::Limits& legal = catalog::hlG2(ItemId::Span).limits.front(); // The same for all types.
    for (const bool lowWordFirst : {true, false}) {
        const Value span = toInt32(first, second, lowWordFirst);
        if (span >= legal.minimum && span <= legal.maximum)
            return lowWordFirst;
    }
    return std::nullopt;
}

} // namespace lds::modbus
