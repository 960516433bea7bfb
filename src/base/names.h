// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace vs {

// An enum whose enumerators have names in files and on the command line. Beside the enum stands a function
// namesOf(E), which gives the names as an array of texts in the enumerators' order.
template <typename E>
concept Named = std::is_enum_v<E> && requires(E e) {
    std::string_view(namesOf(e)[0]);
};

template <Named E>
constexpr const char* nameOf(E e) {
    return namesOf(e)[std::size_t(e)];
}

// The enumerator that has a name; nothing when there is none.
template <Named E>
constexpr std::optional<E> enumeratorOf(std::string_view name) {
    const auto& names = namesOf(E());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (name == names[i]) {
            return E(i);
        }
    }
    return {};
}

} // namespace vs
