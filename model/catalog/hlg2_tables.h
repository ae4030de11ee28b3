#pragma once

// The tables that make up the HL-G2 catalog. Private to this folder: everybody else sees catalog.h.

#include "catalog.h"

namespace lds::catalog::hlg2 {

std::span<const SettingItem> items();            ///< In the order of ItemId, that is of §5.2.4.
std::span<const MenuEntry> menu();               ///< §2.2
std::span<const Coil> coils();                   ///< §5.2.5
std::span<const ModelDescription> models();      ///< §1.8, §4.13
std::span<const int> usageProhibitedRegisters(); ///< §5.2.4, as the manual prints them

} // namespace lds::catalog::hlg2
