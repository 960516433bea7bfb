// SPDX-License-Identifier: Apache-2.0
#include "base/phrase.h"

namespace vs {

std::string Phrase::english() const {
    std::string said;
    for (const char* c = text; *c != '\0'; ++c) {
        const bool isPlace = *c == '%' && c[1] >= '1' && c[1] <= '9';
        const std::size_t index = isPlace ? std::size_t(c[1] - '1') : values.size();
        if (index < values.size()) {
            said += values[index];
            ++c;
        } else {
            said += *c;
        }
    }
    return said;
}

} // namespace vs
