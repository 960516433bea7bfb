// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

// VS_CHECK(condition), VS_CHECK_EQ(a, b): for our own bugs, in every build. Prints place and values, then
// aborts. What a person can cause is an Error instead.
namespace vs::detail {
[[noreturn]] void checkFailed(const char* file, int line, const std::string& what);
}

#define VS_CHECK(condition)                                                                                  \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            ::vs::detail::checkFailed(__FILE__, __LINE__, #condition);                                       \
        }                                                                                                    \
    } while (false)

#define VS_CHECK_EQ(a, b)                                                                                    \
    do {                                                                                                     \
        const auto& vsCheckA = (a);                                                                          \
        const auto& vsCheckB = (b);                                                                          \
        if (!(vsCheckA == vsCheckB)) {                                                                       \
            ::vs::detail::checkFailed(__FILE__, __LINE__,                                                    \
                                      fmt::format(#a " == " #b " ({} != {})", vsCheckA, vsCheckB));          \
        }                                                                                                    \
    } while (false)
