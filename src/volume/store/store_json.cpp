// SPDX-License-Identifier: Apache-2.0
#include "volume/store/store_json.h"

#include "base/atomic_file.h"

#include <fstream>

namespace vs::volume {

void writeStoreFile(const std::filesystem::path& file, const nlohmann::ordered_json& json) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        throw WriteError("{}: this folder cannot be made ({}); make room, or name another place",
                         file.parent_path().string(), error.message());
    }
    writeAtomically(file, [&](const std::filesystem::path& temporary) {
        std::ofstream stream(temporary);
        stream << json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
        if (!stream.flush()) {
            throw WriteError("{}: it cannot be written; make room, or name another place", file.string());
        }
    });
}

} // namespace vs::volume
