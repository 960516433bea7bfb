// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/volume.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vs::cli {

// A mask to compare with, as written on the command line: FILE[:LABEL[,LABEL...]].
struct TruthArgument {
    std::filesystem::path path;
    std::vector<std::int64_t> labels; // that are inside; none: everything but 0 is
};

// Throws UsageError if what follows the last colon is no list of labels. A file whose name has a colon and is
// there is taken as it is.
TruthArgument parseTruth(const std::string& text);

// 1 inside, else 0, on the volume's grid. Throws ReadError as readLabelMap does, Error for another grid and
// for labels that the file does not hold.
std::vector<std::uint8_t> readTruth(const TruthArgument& argument, const volume::Volume& volume);

} // namespace vs::cli
