// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <fstream>

namespace vs::volume {

ReadResult readRaw(const std::filesystem::path& path, const RawLayout& layout) {
    const std::vector<std::int64_t> sizes{layout.dims.x, layout.dims.y, layout.dims.z};
    const std::uint64_t expected = checkedBytes(path, sizes, sizeOf(layout.type));
    const std::uint64_t found = std::filesystem::file_size(path);
    if (found != expected + layout.offsetBytes) {
        refuse(path, fmt::format("it has {} bytes", found),
               fmt::format("{} {} values behind {} bytes make {}", fmt::join(sizes, "x"), name(layout.type),
                           layout.offsetBytes, expected + layout.offsetBytes));
    }
    ReadResult result;
    result.volume.geometry = makeGeometry(layout.dims, layout.spacing);
    result.volume.type = layout.type;
    result.volume.bytes.resize(expected);
    std::ifstream input(path, std::ios::binary);
    input.seekg(static_cast<std::streamoff>(layout.offsetBytes));
    if (!input.read(reinterpret_cast<char*>(result.volume.bytes.data()),
                    static_cast<std::streamsize>(expected))) {
        refuse(path, "it cannot be read to its end", "check the disk and the permissions");
    }
    return result;
}

} // namespace vs::volume
