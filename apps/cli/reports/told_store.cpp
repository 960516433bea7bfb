// SPDX-License-Identifier: Apache-2.0
#include "reports/told_store.h"

#include "reports/long_work.h"

#include "base/error.h"

namespace vs::cli {

void writeToldStore(const std::string& path, const volume::StoreSource& source,
                    const volume::StoreLayout& layout) {
    const LongWork work("writing " + path);
    try {
        volume::writeStore(path, source, layout);
    } catch (const GivenUp&) {
        throw GivenUp("{}: stopped before it was finished; the same command goes on with it", path);
    }
}

} // namespace vs::cli
