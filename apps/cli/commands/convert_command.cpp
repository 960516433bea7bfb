// SPDX-License-Identifier: Apache-2.0
// vstudio convert: a volume as a store of OME-Zarr, with levels that become coarser.
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/progress.h"

#include "base/error.h"
#include "volume/store/write_store.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace vs::cli {

namespace {

struct ConvertOptions {
    std::shared_ptr<VolumeArgument> volume;
    std::string output;
    int chunk = volume::StoreLayout().chunk;
    bool isLabels = false;
};

void run(const ConvertOptions& options) {
    if (std::filesystem::path(options.output).extension() != ".zarr") {
        throw WriteError("{}: a store of OME-Zarr is written; give a name that ends in .zarr",
                         options.output);
    }
    const auto volume = loadVolume(*options.volume).volume;
    volume::StoreLayout layout;
    layout.chunk = options.chunk;
    layout.reducing = options.isLabels ? volume::Reducing::Commonest : volume::Reducing::Mean;
    {
        const Activity activity("writing " + options.output);
        volume::writeStore(options.output, volume::sourceOf(volume), layout);
    }
    const auto levels = volume::levelsOf(volume.geometry, layout.chunk);
    const glm::ivec3 dims = volume.geometry.dims;
    fmt::print("{}: {} x {} x {} voxels, {}, in chunks of {}, {} {}\n", options.output, dims.x, dims.y,
               dims.z, volume::name(volume.type), layout.chunk, levels.size(),
               levels.size() == 1 ? "level" : "levels");
}

} // namespace

void addConvertCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "convert", "Write a volume as a store of OME-Zarr, in chunks and in levels that become coarser");
    auto options = std::make_shared<ConvertOptions>();
    options->volume = addVolumeArgument(*command);
    command
        ->add_option("OUTPUT", options->output,
                     "Folder to write, NAME.zarr; one that was interrupted is gone on with")
        ->required();
    command->add_option("--chunk", options->chunk, "Voxels along each side of a chunk")
        ->check(CLI::Range(8, 512))
        ->capture_default_str();
    command->add_flag("--labels", options->isLabels,
                      "It is a label map: coarser voxels get the label that most of theirs have");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
