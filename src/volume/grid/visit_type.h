// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <utility>

namespace vs::volume {

// Calls `f` with a null pointer to values of a type, for what is not in a Volume: visitType(type,
// [&]<typename T>(const T*) { ... }).
template <typename F>
decltype(auto) visitType(ScalarType type, F&& f) {
    Volume none;
    none.type = type;
    return visit(none, std::forward<F>(f));
}

} // namespace vs::volume
