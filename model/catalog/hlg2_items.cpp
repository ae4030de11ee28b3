#include "hlg2_rows.h"
#include "hlg2_tables.h"

#include <algorithm>
#include <vector>

namespace lds::catalog::hlg2 {

std::span<const SettingItem> items()
{
    // The rows stand by subject; Catalog::item() finds an item by its place in the order of ItemId.
    static const std::vector<SettingItem> all = [] {
        std::vector<SettingItem> rows;
        for (const auto part : {stateItems(), commandItems(), sensingItems(), judgmentItems(),
                                teachingItems(), systemItems(), ethernetItems(), serialItems()})
            rows.insert(rows.end(), part.begin(), part.end());
        std::ranges::sort(rows, {}, &SettingItem::id);
        return rows;
    }();
    return all;
}

std::span<const int> usageProhibitedRegisters()
{
    static constexpr int registers[] = {400051, 400053, 400055, 400057, 400059, 400061, 400063,
                                        400127, 400132, 400135, 400137, 400139, 400141, 400143,
                                        400145, 400147, 400149, 400151, 400172};
    return registers;
}

} // namespace lds::catalog::hlg2
