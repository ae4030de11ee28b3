#pragma once

#include "item_id.h"

#include <array>
#include <optional>
#include <QtGlobal>
#include <span>

namespace lds::catalog {

/// A value as the sensor holds it, in wire units (0.1 µm, 1/10000, ms, a choice's code, ...).
/// Floating point never stands between a person's keystroke and the wire.
using Value = qint32;

/// What writing or reading an item means (docs/architecture.md, "Roles").
enum class Role : quint8 {
    Setting,   ///< A stored value: only these enter pending edits, files, copies and the apply plan.
    Switch,    ///< Acts at once: laser stop, key lock, zero setting, trigger, bank.
    Procedure, ///< Starts or steps something: brightness tuning, teaching.
    Command,   ///< Save, reset, bank copy, initialisation, communication reset.
    Status,    ///< What the sensor reports about itself.
};

enum class Kind : quint8 {
    Choice,     ///< One of `choices`; the value is the code.
    Length,     ///< 0.1 µm on the wire, shown in mm.
    Factor,     ///< 1/10000 on the wire.
    Count,      ///< A plain number.
    Duration,   ///< Milliseconds.
    Port,       ///< A port number.
    Octet,      ///< One part of an IPv4 address, a subnet mask or a gateway.
    Bits,       ///< 16 bits, see coils().
    ErrorCode,  ///< Four digits read as hexadecimal, E and the two internal digits left out (§8.2).
    Trigger,    ///< Writing 0 executes; there is no value to read.
    MacAddress, ///< Six octets; never read through a Value.
};

enum class Access : quint8 { None, Read, Write, ReadWrite };
enum class Scope : quint8 { Bank, Common };                     ///< Bank: one value for each bank (§4.2).
enum class Effect : quint8 { AtOnce, AfterCommunicationReset }; ///< When a written value takes effect.

/// Items that make one thing together and are judged together, so they are written in one message.
enum class WriteGroup : quint8 { None, IpAddress, SubnetMask, DefaultGateway };

/// The five HL-G2 types with communication, by measurement centre distance (§1.8, §2.2).
enum class SensorModel : quint8 { HlG203, HlG205, HlG208, HlG212, HlG225 };
inline constexpr int modelCount = 5;

/// A set of models as bits, bit n being SensorModel n.
using ModelMask = quint8;
inline constexpr ModelMask everyModel = 0x1f;
constexpr ModelMask maskOf(SensorModel model) { return ModelMask(1U << quint8(model)); }

struct Choice {
    Value code;
    const char* name;              ///< Context "SettingItem"; resolved with tr in ui/ and app/ only.
    ModelMask models = everyModel; ///< The types that have this choice (display digit differs).
};

/// The legal values for one sensor type, in wire units. For choices: the smallest and largest code.
struct Limits {
    Value minimum = 0;
    Value maximum = 0;
    Value defaultValue = 0;
    Value resolution = 1; ///< Digits below it are rounded down by the sensor (§1.4 "Setting resolution").
};

struct ModbusBinding {
    int number = 0; ///< As the manual prints it, e.g. 400101; the address on the wire is number − 400001.
    constexpr quint16 address() const { return quint16(number - 400001); }
};
struct SlmpBinding {
    int device = 0; ///< Data register number; a word device.
};
struct EipBinding {
    int attribute = 0; ///< Attribute of object 0x64, instance 1.
};

/// The immutable description of one item. Values live elsewhere (see settings::Values).
/// Texts are English source texts in the context "SettingItem", marked with QT_TRANSLATE_NOOP.
struct SettingItem {
    ItemId id;
    const char* key;     ///< Stable name in files, JSON and the command line, lowerCamel.
    int menu = 0;        ///< Menu number (§2.2), 0 when the sensor's menu does not have it.
    const char* name;    ///< The manual's term.
    const char* help;    ///< What it is and what to mind, in a person's words.
    const char* section; ///< Where the manual describes it, "4.4.1".
    Role role;
    Kind kind;
    Access access;
    Scope scope;
    Effect effect;
    int size = 0; ///< Bytes as the manual's register tables print it: 1, 2 or 4; 0 without an address.
    std::array<Limits, modelCount> limits; ///< Indexed by SensorModel.
    bool hasDefault = true;                ///< False when the manual names no default (commands, status).
    std::span<const Choice> choices = {};
    WriteGroup group = WriteGroup::None;
    std::optional<ModbusBinding> modbus = {};
    std::optional<SlmpBinding> slmp = {};
    std::optional<EipBinding> eip = {};

    constexpr const Limits& limitsFor(SensorModel model) const { return limits[std::size_t(model)]; }
    constexpr bool isReadable() const { return access == Access::Read || access == Access::ReadWrite; }
    constexpr bool isWritable() const { return access == Access::Write || access == Access::ReadWrite; }
    constexpr int registerCount() const { return size == 4 ? 2 : 1; }
};

} // namespace lds::catalog
