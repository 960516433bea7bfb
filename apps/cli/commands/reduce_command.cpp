// SPDX-License-Identifier: Apache-2.0
// vstudio reduce: a smaller copy of a volume, for devices that have no room for all of it.
#include "arguments/parse.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"

#include "base/error.h"
#include "volume/grid/reduced.h"
#include "volume/io/write.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace vs::cli {

namespace {

constexpr int kMost = 64; // voxels along a side that become one

struct ReduceOptions {
    std::shared_ptr<VolumeArgument> volume;
    std::string output;
    std::string by = "2";
    bool isLabels = false;
};

// "2", or "2x2x1".
glm::ivec3 parseFactor(const std::string& text) {
    const bool isOne = text.find('x') == std::string::npos;
    const auto numbers = parseNumbers(text, 'x', isOne ? 1 : 3, "--by", "2 or 2x2x1");
    for (const double n : numbers) {
        if (n < 1 || n > kMost || n != std::floor(n)) {
            throw UsageError("--by {}: 1 to {} voxels along each axis become one, as with 2 or 2x2x1", text,
                             kMost);
        }
    }
    return isOne ? glm::ivec3(int(numbers[0]))
                 : glm::ivec3(int(numbers[0]), int(numbers[1]), int(numbers[2]));
}

void run(const ReduceOptions& options) {
    checkGridName(options.output);
    const glm::ivec3 by = parseFactor(options.by);
    const auto volume = loadVolume(*options.volume).volume;
    const auto small =
        volume::reduced(volume, by, options.isLabels ? volume::Reducing::Commonest : volume::Reducing::Mean);
    volume::writeVolume(options.output, small);
    const glm::ivec3 dims = small.geometry.dims;
    const glm::dvec3 spacing = small.geometry.spacing();
    fmt::print("{}: {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, {}\n", options.output, dims.x, dims.y,
               dims.z, spacing.x, spacing.y, spacing.z, volume::name(small.type));
}

} // namespace

void addReduceCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "reduce", "Write a smaller copy of a volume, for devices that have no room for all of it");
    auto options = std::make_shared<ReduceOptions>();
    options->volume = addVolumeArgument(*command);
    command->add_option("-o,--output", options->output, "File to write: .nrrd, .nii, .nii.gz, .mha or .mhd")
        ->required();
    command->add_option("--by", options->by,
                        "So many voxels along each axis, N or NxMxK, become one, their mean; 2 without");
    command->add_flag("--labels", options->isLabels,
                      "It is a label map: a voxel gets the label that most of its block have");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
