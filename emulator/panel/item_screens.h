#pragma once

#include "panel_screen.h"

namespace lds::emulator {

/// The screen that sets what a menu entry with items stands for, by the kind of the items.
std::unique_ptr<PanelScreen> itemScreen(const catalog::MenuEntry& entry, PanelHost& host);

/// The screens of §3.6, one after the other: language, then NPN/PNP, then the measurement display.
std::unique_ptr<PanelScreen> initialLanguageScreen(PanelHost& host);

} // namespace lds::emulator
