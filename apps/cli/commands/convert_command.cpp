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
#include <optional>
#include <string>

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

glm::dvec3 parseSpacing(const std::string& text) {
    const auto mm = parseNumbers(text, ',', 3, "spacing", "0.5,0.5,1.25, in mm along x, y and z");
    for (const double length : mm) {
        if (!(length >= 1e-6 && length <= 1e6)) {
            throw UsageError("spacing {}: {} mm is not the size of a voxel; give three of 1e-6 to 1e6", text,
                             length);
        }
    }
    return {mm[0], mm[1], mm[2]};
}

// Voxels of another size, in the directions that the file says; the first one stays where it is.
void resize(volume::StoreSource& source, const glm::dvec3& spacingMm) {
    auto& grid = source.facts.geometry;
    const glm::dvec3 before = grid.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        grid.worldFromVoxel[axis] *= spacingMm[axis] / before[axis];
    }
    const std::string text =
        fmt::format("{:.9g} x {:.9g} x {:.9g} mm", spacingMm.x, spacingMm.y, spacingMm.z);
    source.identity += ", voxels of " + text;
    logNotice(fmt::format("{}: its voxels are taken to be {}, as --spacing says", source.facts.name, text));
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
    std::optional<glm::dvec3> spacingMm;
    if (!options.spacing.empty()) {
        spacingMm = parseSpacing(options.spacing);
    }
    ToConvert input = toConvert(options);
    if (!input.source.read) {
        input.source = volume::sourceOf(input.volume);
    }
    if (spacingMm) {
        resize(input.source, *spacingMm);
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
