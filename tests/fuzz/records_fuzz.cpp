// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as lists of points and as tables of records.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/calibration/point_list.h"
#include "core/calibration/record_table.h"
#include "core/calibration/sample_statistics.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto list = kambara::point_list_from_text(text)) {
        if (list->left.size() != list->lines.size() ||
            (!list->right.empty() && list->right.size() != list->left.size())) {
            std::abort();
        }
    }
    if (const auto table = kambara::record_table_from_text(text)) {
        for (const auto& group : table->groups) {
            if (kambara::without_duplicates(group).rows.size() > group.rows.size()) {
                std::abort();
            }
            (void)kambara::baselines_of(*table, group).size();
        }
        (void)kambara::water_comparisons(*table, 1.333).size();
    }
    return 0;
}
