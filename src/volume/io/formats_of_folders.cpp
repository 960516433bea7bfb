// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"
#include "volume/io/inspect.h"

namespace vs::volume {

bool isTiffName(const std::filesystem::path& path) {
    const auto extension = lowerCase(path.extension().string());
    return extension == ".tif" || extension == ".tiff";
}

bool isTiffFolder(const std::filesystem::path& path) {
    std::error_code error;
    std::size_t pictures = 0;
    std::size_t others = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
        const bool isHidden = entry.path().filename().string().starts_with('.');
        (isTiffName(entry.path()) ? pictures : others) += !isHidden && entry.is_regular_file(error) ? 1 : 0;
    }
    return pictures > 0 && pictures >= others;
}

} // namespace vs::volume
