// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"
#include "volume/io/inspect.h"

#include <algorithm>
#include <vector>

namespace vs::volume {

bool isTiffName(const std::filesystem::path& path) {
    const auto extension = lowerCase(path.extension().string());
    return extension == ".tif" || extension == ".tiff";
}

bool isTiffFolder(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::size_t pictures = 0;
    std::vector<fs::path> others; // what scanners write beside them
    std::size_t folders = 0;
    for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
        std::error_code unknown;
        if (it->path().filename().string().starts_with('.')) {
            continue;
        }
        if (!it->is_regular_file(unknown)) {
            ++folders;
        } else if (isTiffName(it->path())) {
            ++pictures;
        } else {
            others.push_back(it->path());
        }
    }
    const bool isAlone = others.empty() && folders == 0;
    return (isAlone ? pictures > 0 : pictures > 1 && pictures > others.size()) &&
           std::none_of(others.begin(), others.end(),
                        [](const fs::path& other) { return recognise(other) == Format::Dicom; });
}

bool isStore(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    return fs::exists(path / ".zattrs", error) || fs::exists(path / ".zgroup", error) ||
           fs::exists(path / ".zarray", error) || fs::exists(path / "zarr.json", error);
}

} // namespace vs::volume
