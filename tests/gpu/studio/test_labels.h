// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/studio/test_head.h"
#include "volume/io/write.h"

#include <unistd.h>

#include <string>

namespace vs::test {

// A label map on the test head's grid, in a temporary file: a box of 7 and, touching it, a box of 250.
class LabelFile {
public:
    LabelFile()
        : path_(std::filesystem::temp_directory_path() /
                ("vs_labels_" + std::to_string(getpid()) + ".nrrd")) {
        const volume::GridGeometry geometry = testHead().geometry;
        std::vector<std::uint8_t> labels(geometry.voxelCount());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            labels[i] = valueAt(int(i), geometry.dims);
        }
        volume::writeGrid(path_, geometry, std::span<const std::uint8_t>(labels));
    }
    ~LabelFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    LabelFile(const LabelFile&) = delete;
    LabelFile& operator=(const LabelFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    static std::uint8_t valueAt(int i, glm::ivec3 dims) {
        const int x = i % dims.x;
        const int y = i / dims.x % dims.y;
        const int z = i / dims.x / dims.y;
        const bool isIn = x >= 20 && x < 50 && y >= 18 && y < 34 && z >= 25 && z < 33;
        return isIn ? (x < 35 ? 7 : 250) : 0;
    }

private:
    std::filesystem::path path_;
};

} // namespace vs::test
