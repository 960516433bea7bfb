// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vs::cli {

// A mask on the volume's grid, as written on the command line: FILE[:LABEL[,LABEL...]].
struct MaskArgument {
    std::filesystem::path path;
    std::vector<std::int64_t> labels; // that are inside; none: everything but 0 is
};

// Takes the text of a mask apart. Throws UsageError, which begins with the option, if what follows the last
// colon is no list of labels. A file whose name has a colon and is there is taken as it is.
MaskArgument parseMask(const std::string& text, const std::string& option);

// 1 inside, else 0, on the volume's grid. Throws ReadError as readLabelMap does, Error for another grid and
// for labels that the file does not hold.
std::vector<std::uint8_t> readMask(const MaskArgument& argument, const volume::Volume& volume);

} // namespace vs::cli
