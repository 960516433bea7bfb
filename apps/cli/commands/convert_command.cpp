// SPDX-License-Identifier: Apache-2.0
// vstudio convert: a volume as a store of OME-Zarr, with levels that become coarser.
#include "arguments/parse.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/told_store.h"

#include "base/error.h"
#include "base/log.h"
#include "studio/document/finer_levels.h"
#include "volume/reading/stack_source.h"
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
    std::string memory = "2GiB";
    std::string spacing; // in mm, where the file does not say it, or says it wrong
    bool isLabels = false;
};

// What a store is made of, and what keeps it.
struct ToConvert {
    volume::Volume volume; // of what is read as a whole
    volume::StoreSource source;
};

// Voxels of the size that the person gives, in the directions that the file says.
void resize(volume::StoreSource& source, const std::string& spacing) {
    const auto mm = parseNumbers(spacing, ',', 3, "spacing", "0.5,0.5,1.25, in mm along x, y and z");
    auto& grid = source.facts.geometry;
    const glm::dvec3 before = grid.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        const double length = mm[std::size_t(axis)];
        if (!(length >= 1e-6 && length <= 1e6)) {
            throw UsageError("spacing {}: {} mm is not the size of a voxel; give three of 1e-6 to 1e6",
                             spacing, length);
        }
        grid.worldFromVoxel[axis] *= length / before[axis];
    }
    source.identity += ", spacing " + spacing;
}

ToConvert toConvert(const ConvertOptions& options) {
    ToConvert input;
    std::vector<std::string> notices;
    const std::uint64_t bytes = studio::memoryOf(options.memory, "--memory");
    const auto stack = volume::stackSource(options.volume->path, readOptions(*options.volume), options.chunk,
                                           bytes, notices);
    for (const auto& notice : notices) {
        logNotice(notice);
    }
    if (stack) {
        input.source = *stack;
        return input;
    }
    input.volume = loadVolume(*options.volume).volume;
    return input;
}

void run(const ConvertOptions& options) {
    auto output = std::filesystem::path(options.output).lexically_normal();
    output = output.has_filename() ? output : output.parent_path(); // "NAME.zarr/", as shells complete it
    if (output.extension() != ".zarr") {
        throw WriteError("{}: a store of OME-Zarr is written; give a name that ends in .zarr",
                         options.output);
    }
    ToConvert input = toConvert(options);
    if (!input.source.read) {
        input.source = volume::sourceOf(input.volume);
    }
    if (!options.spacing.empty()) {
        resize(input.source, options.spacing);
    }
    volume::StoreLayout layout;
    layout.chunk = options.chunk;
    layout.reducing = options.isLabels ? volume::Reducing::Commonest : volume::Reducing::Mean;
    writeToldStore(output.string(), input.source, layout);
    const auto& geometry = input.source.facts.geometry;
    const auto levels = volume::levelsOf(geometry, layout.chunk);
    fmt::print("{}: {} x {} x {} voxels, {}, in chunks of {}, {} {}\n", options.output, geometry.dims.x,
               geometry.dims.y, geometry.dims.z, volume::name(input.source.type), layout.chunk, levels.size(),
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
    command
        ->add_option("--memory", options->memory,
                     "What slices may take while they wait, where a volume is read slice by slice (TIFF, "
                     "--raw), for example 512MiB or 4GiB")
        ->capture_default_str();
    command->add_option("--spacing", options->spacing,
                        "X,Y,Z: how large voxels are, in mm, where the file does not say it or says it "
                        "wrong");
    command->add_flag("--labels", options->isLabels,
                      "It is a label map: coarser voxels get the label that most of theirs have");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
