// SPDX-License-Identifier: Apache-2.0
#include "studio/operation.h"

#include <array>

namespace vs::studio {

const char* name(const Operation& operation) {
    // In the order of the variant's alternatives.
    constexpr std::array<const char*, std::variant_size_v<Operation>> names{
        "view", "peel", "drill",  "seed",    "grow",    "rewind", "growth range",
        "undo", "redo", "un-cut", "re-seed", "picture", "labels", "sculpture"};
    return names[operation.index()];
}

} // namespace vs::studio
