// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/store/write_store.h"

#include <string>

namespace vs::cli {

// volume::writeStore(), with its progress shown (LongWork). When the person gives up, GivenUp says how to go
// on.
void writeToldStore(const std::string& path, const volume::StoreSource& source,
                    const volume::StoreLayout& layout);

} // namespace vs::cli
