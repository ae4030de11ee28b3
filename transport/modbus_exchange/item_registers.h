#pragma once

#include "catalog.h"
#include "measurement.h"
#include "modbus_pdu.h"
#include "sensor_link.h"
#include "values.h"

#include <optional>
#include <QList>
#include <tl/expected.hpp>

/// Between the catalog's items and Modbus registers (§5.2, §5.2.4). Pure functions.
namespace lds::modbus {

/// Registers that lie together; addresses as on the wire (number − 400001).
struct RegisterRange {
    quint16 first = 0;
    quint16 count = 0;
    int end() const { return first + count; }
    friend bool operator==(const RegisterRange&, const RegisterRange&) = default;
};

/// The number the manual prints for an address on the wire: 100 is 400101.
constexpr int printedRegister(int address) { return 400001 + address; }

/// The fewest reads that cover the items, in ascending order, none longer than FC 03 allows and none
/// cutting a 4-byte item in two. Registers in between are covered, too: they read as 0 when they are not
/// mapped (§5.2.3). Items that cannot be read are left out, so nothing may remain.
QList<RegisterRange> packReads(const QList<catalog::ItemId>& items);

Request readRequest(const RegisterRange& range); ///< FC 03

/// The value of an item whose first register is registers[index]; reserved bits are masked (§5.2.5).
catalog::Value decodeItem(const catalog::SettingItem& item, const QList<quint16>& registers, qsizetype index,
                          bool lowWordFirst);

/// The values of those items that lie wholly in the range and can be read. Reserved bits are masked.
/// `registers` holds range.count words.
settings::Values decodeItems(const QList<catalog::ItemId>& items, const RegisterRange& range,
                             const QList<quint16>& registers, bool lowWordFirst);

/// One message: FC 06 for one register, FC 10h for a 4-byte item or for the items of one WriteGroup whose
/// registers lie together. What can not go out in one message, has no address, is read only or does not
/// fit its registers is refused here, without asking the sensor. Ranges and rules are the sensor's to judge.
tl::expected<Request, ports::Failure> encodeWrite(const settings::Write& write, bool lowWordFirst);

/// State, details, error code, value and intensity: one read (400011–400022).
const RegisterRange& measurementRange();

/// `registers` holds measurementRange().count words. The stamps are left at 0.
measurement::Measurement decodeMeasurement(const QList<quint16>& registers, bool lowWordFirst);

/// The two registers of Span decide the order of the words: its legal values (§5.2.4) make exactly one
/// order possible, or both when the words are equal; then low word first is as good as the other.
/// Nothing when neither order gives a legal Span, so that what answered is no HL-G2.
std::optional<bool> lowWordFirstBySpan(quint16 first, quint16 second);

} // namespace lds::modbus
