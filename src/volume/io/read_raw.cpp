// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <fstream>

namespace vs::volume {

ReadResult readRaw(const std::filesystem::path& path, const RawLayout& layout,
                   const std::optional<Slices>& slices) {
    const Slices part = slices.value_or(Slices{0, layout.dims.z});
    if (part.first < 0 || part.count < 1 || part.count > layout.dims.z - part.first) {
        refuse(path, fmt::format("it has no slice {}", part.first), fmt::format("it has {}", layout.dims.z));
    }
    const std::vector<std::int64_t> sizes{layout.dims.x, layout.dims.y, part.count};
    const std::uint64_t bytes = checkedBytes(path, sizes, sizeOf(layout.type));
    const std::uint64_t expected = bytes / std::uint64_t(part.count) * std::uint64_t(layout.dims.z);
    const std::uint64_t found = std::filesystem::file_size(path);
    if (found != expected + layout.offsetBytes) {
        refuse(path, fmt::format("it has {} bytes", found),
               fmt::format("{} {} values behind {} bytes make {}",
                           fmt::join(std::vector{layout.dims.x, layout.dims.y, layout.dims.z}, "x"),
                           name(layout.type), layout.offsetBytes, expected + layout.offsetBytes));
    }
    ReadResult result;
    result.volume.geometry = makeGeometry({layout.dims.x, layout.dims.y, part.count}, layout.spacing);
    result.volume.geometry.worldFromVoxel[3].z = part.first * layout.spacing.z;
    result.volume.details.slices = layout.dims.z;
    result.volume.type = layout.type;
    result.volume.bytes.resize(bytes);
    std::ifstream input(path, std::ios::binary);
    const std::uint64_t before = bytes / std::uint64_t(part.count) * std::uint64_t(part.first);
    input.seekg(static_cast<std::streamoff>(layout.offsetBytes + before));
    if (!input.read(reinterpret_cast<char*>(result.volume.bytes.data()),
                    static_cast<std::streamsize>(bytes))) {
        refuse(path, "it cannot be read to its end", "check the disk and the permissions");
    }
    return result;
}

} // namespace vs::volume
