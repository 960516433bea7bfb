// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace vs::detail {

void checkFailed(const char* file, int line, const std::string& what) {
    fmt::print(stderr, "volume studio: internal error at {}:{}: {}\n", file, line, what);
    std::abort();
}

} // namespace vs::detail
