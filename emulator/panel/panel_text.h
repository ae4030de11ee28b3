#pragma once

#include "display_content.h"

namespace lds::emulator {

/// The display's words in its three languages (§4.8.4). They belong to the sensor, not to the program, so
/// they have nothing to do with the program's own translation. Names of items and choices come from the
/// catalog in English and are looked up here by that text; what has no translation stays English.
QString panelText(const char* english, PanelLanguage language);

/// Whether the table has the text.
bool hasPanelText(const char* english);

/// Words of the display that are no names of the catalog, as the manual prints them.
namespace words {
inline constexpr auto receivedLight = "Received light";
inline constexpr auto setTarget = "Set Target - Push ENTER SW";
inline constexpr auto setFirstTarget = "Set 1st Target - Push ENTER SW";
inline constexpr auto setSecondTarget = "Set 2nd Target and Push ENTER SW";
inline constexpr auto setThirdTarget = "Set 3rd Target and Push ENTER SW";
inline constexpr auto adjusting = "Adjusting";
inline constexpr auto success = "Success";
inline constexpr auto failed = "Failed";
inline constexpr auto error = "Error";
inline constexpr auto keyLockOn = "KEY LOCK ON";
inline constexpr auto keyLockOff = "KEY LOCK OFF";
inline constexpr auto cancel = "Cancel";
inline constexpr auto reset = "Reset";
inline constexpr auto initializing = "Initializing";
inline constexpr auto polarity = "NPN/PNP";
inline constexpr auto over = "+OVER";
inline constexpr auto under = "-OVER";
inline constexpr auto indeterminate = "----";
inline constexpr auto alarm = "ALARM";
} // namespace words

} // namespace lds::emulator
