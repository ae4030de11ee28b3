#pragma once

#include "session_types.h"

namespace lds::sensor {

/// What a command, switch or procedure step does besides itself, as far as the manual says.
namespace command_effects {

/// Items to read back after writing `value` to `item`, readable ones only.
///
/// - Bank switching: everything each bank has its own of, and the trigger input by communication, which
///   it clears (§4.2, §4.6.2).
/// - Bank copy: clears the trigger input (§4.6.2); the running bank's values when that is the destination.
/// - Initialisation: everything.
/// - Laser stop: its bit in the sensor state. Zero setting: likewise.
/// - Teaching and tuning steps: their execution state; what they set, HIGH and LOW (§4.9).
QList<ItemId> readBack(ItemId item, Value value, const settings::Values& held);

/// What becomes of "saved or not" after the write has been carried out.
///
/// - Saving: Saved.
/// - Bank switching: the number of the running bank is a stored value as well: NotSaved (§5.1).
/// - Bank copy works on the saved memory and is retained (§4.2): no change.
/// - Initialisation: the manual does not say whether the memory follows: Unknown (§4.8.6).
/// - Zero setting is held in the bank (§4.2); laser stop can be saved (§8.1, "No laser is emitted");
///   key lock is taken to be like it: NotSaved. So are tuning and teaching points, which change settings.
/// - Resets and trigger inputs: no change.
Saved savedAfter(Saved before, ItemId item);

/// A switch that a save stores; when somebody else changes it, nobody can tell whether it is saved.
bool isStored(ItemId item);

/// Saving, copying and initialising write the memory, during which the sensor is silent for up to
/// seconds (§5.3.3).
bool writesMemory(ItemId item);

/// The destination of a bank copy (§4.2: 0 is from bank 1 to bank 2, 11 from bank 4 to bank 3).
Value copyDestination(Value code);

/// Everything each bank has its own of and that can be read.
QList<ItemId> bankScoped();

} // namespace command_effects
} // namespace lds::sensor
