#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr Choice zeroSettings[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Zero setting OFF")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "Zero setting ON")}};

constexpr Choice banks[] = {{1, QT_TRANSLATE_NOOP("SettingItem", "Bank 1")},
                            {2, QT_TRANSLATE_NOOP("SettingItem", "Bank 2")},
                            {3, QT_TRANSLATE_NOOP("SettingItem", "Bank 3")},
                            {4, QT_TRANSLATE_NOOP("SettingItem", "Bank 4")}};

constexpr Choice bankCopies[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Bank 1 to Bank 2")},
                                 {1, QT_TRANSLATE_NOOP("SettingItem", "Bank 1 to Bank 3")},
                                 {2, QT_TRANSLATE_NOOP("SettingItem", "Bank 1 to Bank 4")},
                                 {3, QT_TRANSLATE_NOOP("SettingItem", "Bank 2 to Bank 1")},
                                 {4, QT_TRANSLATE_NOOP("SettingItem", "Bank 2 to Bank 3")},
                                 {5, QT_TRANSLATE_NOOP("SettingItem", "Bank 2 to Bank 4")},
                                 {6, QT_TRANSLATE_NOOP("SettingItem", "Bank 3 to Bank 1")},
                                 {7, QT_TRANSLATE_NOOP("SettingItem", "Bank 3 to Bank 2")},
                                 {8, QT_TRANSLATE_NOOP("SettingItem", "Bank 3 to Bank 4")},
                                 {9, QT_TRANSLATE_NOOP("SettingItem", "Bank 4 to Bank 1")},
                                 {10, QT_TRANSLATE_NOOP("SettingItem", "Bank 4 to Bank 2")},
                                 {11, QT_TRANSLATE_NOOP("SettingItem", "Bank 4 to Bank 3")}};

constexpr Choice initializations[] = {
    {1, QT_TRANSLATE_NOOP("SettingItem", "Bank 1")},    {2, QT_TRANSLATE_NOOP("SettingItem", "Bank 2")},
    {3, QT_TRANSLATE_NOOP("SettingItem", "Bank 3")},    {4, QT_TRANSLATE_NOOP("SettingItem", "Bank 4")},
    {5, QT_TRANSLATE_NOOP("SettingItem", "All Banks")}, {6, QT_TRANSLATE_NOOP("SettingItem", "All Areas")}};

constexpr Choice keyLocks[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Disable key lock")},
                               {1, QT_TRANSLATE_NOOP("SettingItem", "Enable key lock")}};

constexpr Choice laserStops[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "OFF (Laser emitted)")},
                                 {1, QT_TRANSLATE_NOOP("SettingItem", "ON (Emission stopped)")}};

/// What acts at once: switches and commands.
constexpr SettingItem rows[] = {
    withoutDefault(choice(
        {ItemId::ZeroSetting, "zeroSetting", 0, QT_TRANSLATE_NOOP("SettingItem", "Zero setting"), "4.10",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "ON makes the place where the workpiece is now read as zero, or as the offset if one is "
             "set; OFF takes that back. Put the reference workpiece inside the measurement range "
             "first: an unmeasurable one is refused. Each bank keeps its own zero; it belongs to this "
             "mounting and cannot be copied to another sensor. Set it again after inverting the "
             "measured value.")},
        bankSwitch, {1, 400052, 51, 2312}, zeroSettings)),
    trigger({ItemId::SetValueSaving, "setValueSaving", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Set value saving"), "5.1",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Stores what the sensor holds now so that it survives power-off; without it changes "
                 "made over communication are lost. The sensor may stay silent for seconds meanwhile, "
                 "and every saving wears its memory a little.")},
            command, {1, 400054, 53, 2313}),
    trigger(
        {ItemId::MeasuredValueResetting, "measuredValueResetting", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Measured value resetting"), "4.11",
         QT_TRANSLATE_NOOP("SettingItem",
                           "Forgets the values gathered for averaging and whatever is being held, and starts "
                           "afresh. All judgment outputs go OFF; an output held by the delay timer's Hold is "
                           "released.")},
        command, {1, 400056, 55, 2314}),
    choice(
        {ItemId::BankSwitching, "bankSwitching", 1, QT_TRANSLATE_NOOP("SettingItem", "Bank switching"), "4.2",
         QT_TRANSLATE_NOOP("SettingItem",
                           "Chooses which of the four sets of bank settings is in use. The new bank works at "
                           "once, and later changes go into it. A trigger given over communication is "
                           "cleared.")},
        commonSwitch, {1, 400058, 57, 2315}, banks, 1),
    choice({ItemId::BankCopy, "bankCopy", 0, QT_TRANSLATE_NOOP("SettingItem", "Bank copy"), "4.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Copies one bank over another. What is copied is the saved state of the source, so "
                "save first if it was changed. The result stays after power-off, and a trigger given "
                "over communication is cleared.")},
           command, {1, 400060, 59, 2316}, bankCopies),
    choice({ItemId::SettingsInitialization, "settingsInitialization", 96,
            QT_TRANSLATE_NOOP("SettingItem", "Settings initialization"), "4.8.6",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Puts one bank, all four, or everything back to the factory values. All Areas leaves "
                "the language, NPN/PNP and the Ethernet and RS-485 settings as they are. What was set "
                "before is gone.")},
           command, {1, 400062, 61, 2317}, initializations),
    withoutDefault(choice(
        {ItemId::KeyLock, "keyLock", 0, QT_TRANSLATE_NOOP("SettingItem", "Key lock"), "4.12",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Locks the keys on the sensor so that nobody changes a setting by accident. Communication "
             "still works. At the sensor, UP and DOWN held for two seconds unlock it again.")},
        commonSwitch, {1, 400108, 107, 2322}, keyLocks)),
    withoutDefault(
        choice({ItemId::TriggerInputCommunication, "triggerInputCommunication", 0,
                QT_TRANSLATE_NOOP("SettingItem", "Trigger input (communication)"), "4.6.2",
                QT_TRANSLATE_NOOP(
                    "SettingItem",
                    "A trigger given by communication instead of by the wire IN1; use one of the two, never "
                    "both together. Switching or copying a bank, initializing, or changing the trigger mode "
                    "sets it back to OFF.")},
               commonSwitch, {1, 400131, 130, 2341}, offOn)),
    choice({ItemId::LaserStop, "laserStop", 52, QT_TRANSLATE_NOOP("SettingItem", "Laser stop"), "4.6.1",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "ON switches the laser beam off, for example to keep two sensors from disturbing each "
                "other; nothing is measured meanwhile. OFF lets it shine again: make sure that nobody "
                "looks into the beam.")},
           commonSwitch, {1, 400150, 149, 2351}, laserStops),
    // SLMP prints two bytes for device 170, the other tables one; a word device carries either.
    trigger(
        {ItemId::ResettingCommunicationSettings, "resettingCommunicationSettings", 95,
         QT_TRANSLATE_NOOP("SettingItem", "Resetting communication settings"), "4.8.5",
         QT_TRANSLATE_NOOP("SettingItem",
                           "Makes changed Ethernet and RS-485 settings take effect. The connection breaks: "
                           "connect again with the new address, port or serial settings. Save first if they "
                           "are to outlast power-off.")},
        command, {1, 400171, 170, 0}),
};

} // namespace

std::span<const SettingItem> commandItems() { return rows; }

} // namespace lds::catalog::hlg2
