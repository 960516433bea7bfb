// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/write.h"

#include "test_files.h"

#include <sys/wait.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

// Writes a shell script that can be run, and returns where.
inline std::filesystem::path script(const TemporaryFolder& folder, const std::string& name,
                                    const std::string& commands) {
    writeFile(folder / name, "#!/bin/sh\n" + commands + "\n");
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
    return folder / name;
}

// While it lives, a shell script is taken for the decoder.
class PretendedDecoder {
public:
    PretendedDecoder(const TemporaryFolder& folder, const std::string& commands) {
        setenv("VOLUME_STUDIO_DECODER", script(folder, "decoder", commands).c_str(), 1);
    }
    ~PretendedDecoder() { unsetenv("VOLUME_STUDIO_DECODER"); }
    PretendedDecoder(const PretendedDecoder&) = delete;
    PretendedDecoder& operator=(const PretendedDecoder&) = delete;
};

// A scan that is a cube of so many voxels along each side.
inline std::filesystem::path cube(const TemporaryFolder& folder, int edge,
                                  const std::string& name = "cube.nrrd") {
    const auto grid = makeGeometry(glm::ivec3(edge));
    std::vector<std::int16_t> values(grid.voxelCount());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::int16_t(i * 7919 % 2003);
    }
    writeGrid(folder / name, grid, std::span<const std::int16_t>(values));
    return folder / name;
}

inline bool hasChildren() { return waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

} // namespace vs::volume
