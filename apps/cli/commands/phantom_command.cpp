// SPDX-License-Identifier: Apache-2.0
// vstudio phantom: volumes made from nothing, with labels that are known to be true.
#include "arguments/parse.h"
#include "commands/commands.h"
#include "reports/told_store.h"

#include "base/error.h"
#include "base/names.h"
#include "phantom/recipe.h"
#include "phantom/scanner.h"
#include "volume/io/write.h"
#include "volume/store/write_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vs::cli {

namespace {

struct PhantomOptions {
    std::string kind;
    std::string output;
    std::string labels;
    std::string size;
    phantom::Recipe recipe; // the rest
};

// "N": voxels along the longest side of `whole`, the others in proportion; "NxMxK": along each.
glm::ivec3 dimsFrom(const std::string& text, glm::ivec3 whole, int most) {
    const bool isOne = text.find('x') == std::string::npos;
    const auto sizes = parseNumbers(text, 'x', isOne ? 1 : 3, "size", "256 or 181x217x181");
    for (const double n : sizes) {
        if (n < phantom::kLeastVoxels || n > most || n != std::floor(n)) {
            throw UsageError("size '{}' is out of bounds; {} to {} voxels each way are allowed, like 256",
                             text, phantom::kLeastVoxels, most);
        }
    }
    if (!isOne) {
        return glm::ivec3(int(sizes[0]), int(sizes[1]), int(sizes[2]));
    }
    const glm::dvec3 share = glm::dvec3(whole) / double(std::max({whole.x, whole.y, whole.z}));
    return glm::max(glm::ivec3(glm::round(sizes[0] * share)), glm::ivec3(1));
}

phantom::Recipe recipeFrom(const PhantomOptions& options) {
    phantom::Recipe recipe = options.recipe;
    recipe.kind = *enumeratorOf<phantom::Kind>(options.kind); // the parser has checked it
    if (recipe.biasPercent > 0 && !phantom::about(recipe.kind).hasBias) {
        throw UsageError("--bias {}: a {} has none", recipe.biasPercent, phantom::about(recipe.kind).meaning);
    }
    if (!options.size.empty()) {
        recipe.dims =
            dimsFrom(options.size, phantom::about(recipe.kind).dims,
                     volume::isStoreName(options.output) ? phantom::kMostStoredVoxels : phantom::kMostVoxels);
    }
    return recipe;
}

void writeVolume(const std::string& path, const volume::Volume& volume) {
    volume::visit(volume, [&]<typename T>(const T* values) {
        if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::int16_t>) {
            volume::writeGrid(path, volume.geometry,
                              std::span<const T>(values, volume.geometry.voxelCount()));
        }
    });
}

// Box by box, so that memory has room for it whatever its size; the values, or the labels.
void writeStore(const std::string& path, const phantom::Scanner& scanner, const phantom::Recipe& recipe,
                bool isOfLabels) {
    volume::StoreSource source;
    source.facts = {scanner.grid, "", scanner.name};
    source.type = isOfLabels ? volume::ScalarType::UInt8 : scanner.type;
    source.identity = fmt::format("{} {} {} x {} x {}, {} {} {}", scanner.name,
                                  isOfLabels ? "labels" : "values", scanner.grid.dims.x, scanner.grid.dims.y,
                                  scanner.grid.dims.z, recipe.noisePercent, recipe.biasPercent, recipe.seed);
    source.read = [&scanner, isOfLabels](const Box3& box) {
        std::vector<std::byte> values(box.volume() * volume::sizeOf(scanner.type));
        std::vector<std::uint8_t> labels(isOfLabels ? box.volume() : 0);
        phantom::scanBox(scanner, box, values, labels);
        if (isOfLabels) {
            values.resize(labels.size());
            std::transform(labels.begin(), labels.end(), values.begin(), [](auto l) { return std::byte(l); });
        }
        return values;
    };
    volume::StoreLayout layout;
    layout.reducing = isOfLabels ? volume::Reducing::Commonest : volume::Reducing::Mean;
    writeToldStore(path, source, layout);
}

void runToStore(const PhantomOptions& options) {
    const phantom::Recipe recipe = recipeFrom(options);
    const auto scanner = phantom::scannerOf(recipe);
    writeStore(options.output, scanner, recipe, false);
    if (!options.labels.empty()) {
        writeStore(options.labels, scanner, recipe, true);
    }
    const auto& grid = scanner.grid;
    const auto spacing = grid.spacing();
    fmt::print("{}: {}, {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm\n", options.output, scanner.name,
               grid.dims.x, grid.dims.y, grid.dims.z, spacing.x, spacing.y, spacing.z);
}

void run(const PhantomOptions& options) {
    if (volume::isStoreName(options.output) != volume::isStoreName(options.labels) &&
        !options.labels.empty()) {
        throw UsageError(
            "--labels {}: write them as the volume is written, both as stores (.zarr) or neither",
            options.labels);
    }
    if (volume::isStoreName(options.output)) {
        runToStore(options);
        return;
    }
    checkGridName(options.output);
    if (!options.labels.empty()) {
        checkGridName(options.labels);
    }
    const phantom::Recipe recipe = recipeFrom(options);
    const auto phantom = phantom::make(recipe);
    const auto& grid = phantom.volume.geometry;
    writeVolume(options.output, phantom.volume);
    if (!options.labels.empty()) {
        volume::writeGrid(options.labels, grid, std::span<const std::uint8_t>(phantom.labels));
    }
    const auto spacing = grid.spacing();
    fmt::print("{}: {}, {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, values {} to {}\n",
               options.output, phantom.volume.name, grid.dims.x, grid.dims.y, grid.dims.z, spacing.x,
               spacing.y, spacing.z, phantom.volume.range.lo, phantom.volume.range.hi);
    const auto tissues = phantom::about(recipe.kind).tissues;
    for (std::size_t label = 0; label < tissues.size(); ++label) {
        const auto voxels = std::count(phantom.labels.begin(), phantom.labels.end(), std::uint8_t(label));
        fmt::print("{} {:<12} {:10.1f} ml\n", label, tissues[label], double(voxels) * grid.voxelMm3() / 1000);
    }
}

// What each kind is, and its share of a sentence about all.
std::string ofEachKind(const std::function<std::string(const phantom::About&)>& text) {
    std::string all;
    for (std::size_t kind = 0; kind < phantom::kKinds.size(); ++kind) {
        all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", phantom::kKinds[kind],
                           text(phantom::about(phantom::Kind(kind))));
    }
    return all;
}

std::string tissuesOf(const phantom::About& kind) {
    std::string all;
    for (std::size_t label = 0; label < kind.tissues.size(); ++label) {
        all += fmt::format("{}{} {}", label == 0 ? "" : ", ", label, kind.tissues[label]);
    }
    return all;
}

} // namespace

void addPhantomCommand(CLI::App& app) {
    auto* command = app.add_subcommand("phantom", "Make a volume whose tissues are known");
    const auto options = std::make_shared<PhantomOptions>();
    command
        ->add_option("KIND", options->kind,
                     ofEachKind([](const phantom::About& kind) { return std::string(kind.meaning); }))
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>(phantom::kKinds.begin(), phantom::kKinds.end())));
    command
        ->add_option(
            "-o,--output", options->output,
            "File to write: .nrrd, .nii, .nii.gz, .mha or .mhd; or a store of OME-Zarr, .zarr, which may be "
            "larger than memory")
        ->required();
    command->add_option("--labels", options->labels, "File for the true labels. " + ofEachKind(tissuesOf));
    command->add_option("--size", options->size,
                        "Voxels along the longest side, N, or along each, NxMxK. Else " +
                            ofEachKind([](const phantom::About& kind) {
                                return fmt::format("{}x{}x{}", kind.dims.x, kind.dims.y, kind.dims.z);
                            }));
    command
        ->add_option("--noise", options->recipe.noisePercent,
                     "Standard deviation in percent. " + ofEachKind([](const phantom::About& kind) {
                         return fmt::format("of {}", kind.noiseOf);
                     }))
        ->check(between(0, 100))
        ->capture_default_str();
    command
        ->add_option("--bias", options->recipe.biasPercent,
                     "Head: how much the sensitivity varies over the brain, 20 for 0.9 to 1.1")
        ->check(between(0, 100))
        ->capture_default_str();
    command->add_option("--seed", options->recipe.seed, "Of the noise")
        ->check(between(0, 1 << 30))
        ->capture_default_str();
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
