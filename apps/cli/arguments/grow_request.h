// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments/mask_argument.h"

#include "segment/growth/constraints.h"

#include <CLI/CLI.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// The command line of vstudio grow as it was written.
struct GrowOptions {
    std::vector<std::string> seeds;
    std::string range;
    std::string difference;
    std::string gradient;
    std::string gradientDifference;
    std::string connectivity = "6";
    std::string steps;
    std::string inside;
    std::string labelsIn;
    std::string labels;
    std::string generations;
    std::string compare;
};

// Adds everything but the volume. `options` must outlive the parsing.
void addGrowOptions(CLI::App& command, GrowOptions& options);

// Everything on the command line, understood before anything is read.
struct GrowRequest {
    std::vector<glm::ivec3> seeds;
    segment::Constraints constraints;
    int steps = std::numeric_limits<int>::max();
    std::optional<MaskArgument> inside;
    std::optional<MaskArgument> truth;
};

// Understands what was written. Throws UsageError for what makes no sense, names of files to write included.
GrowRequest understand(const GrowOptions& options);

} // namespace vs::cli
