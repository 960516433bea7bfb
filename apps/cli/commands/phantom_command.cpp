// SPDX-License-Identifier: Apache-2.0
// vstudio phantom: volumes made from nothing, with labels that are known to be true.
#include "arguments/parse.h"
#include "commands/commands.h"

#include "base/error.h"
#include "phantom/body_phantom.h"
#include "phantom/head_phantom.h"
#include "volume/io/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace vs::cli {

namespace {

struct PhantomOptions {
    std::string kind;
    std::string output;
    std::string labels;
    std::string size;
    double noisePercent = 0;
    double biasPercent = 0;
    std::uint64_t seed = 1;
};

constexpr const char* kHead = "head";
constexpr glm::ivec3 kHeadDims(181, 217, 181); // 1 mm
constexpr int kBodySize = 512;

// "N": voxels along the longest side of `whole`, the others in proportion; "NxMxK": along each.
glm::ivec3 dimsFrom(const std::string& text, glm::ivec3 whole) {
    const bool isOne = text.find('x') == std::string::npos;
    const auto sizes = parseNumbers(text, 'x', isOne ? 1 : 3, "size", "256 or 181x217x181");
    for (const double n : sizes) {
        if (n < 8 || n > 2048 || n != std::floor(n)) {
            throw UsageError("size '{}' is out of bounds; 8 to 2048 voxels each way are allowed, like 256",
                             text);
        }
    }
    if (!isOne) {
        return glm::ivec3(int(sizes[0]), int(sizes[1]), int(sizes[2]));
    }
    const glm::dvec3 share = glm::dvec3(whole) / double(std::max({whole.x, whole.y, whole.z}));
    return glm::max(glm::ivec3(glm::round(sizes[0] * share)), glm::ivec3(1));
}

phantom::LabelledVolume make(const PhantomOptions& options) {
    if (options.kind == kHead) {
        const glm::ivec3 dims = options.size.empty() ? kHeadDims : dimsFrom(options.size, kHeadDims);
        return phantom::makeHeadPhantom({dims, options.noisePercent, options.biasPercent, options.seed});
    }
    if (options.biasPercent > 0) {
        throw UsageError("--bias {}: is for the head; CT has none", options.biasPercent);
    }
    const glm::ivec3 whole(kBodySize);
    const glm::ivec3 dims = options.size.empty() ? whole : dimsFrom(options.size, whole);
    return phantom::makeBodyPhantom({dims, options.noisePercent, options.seed});
}

void writeVolume(const std::string& path, const volume::Volume& volume) {
    volume::visit(volume, [&]<typename T>(const T* values) {
        if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::int16_t>) {
            volume::writeGrid(path, volume.geometry,
                              std::span<const T>(values, volume.geometry.voxelCount()));
        }
    });
}

void run(const PhantomOptions& options) {
    checkGridName(options.output);
    if (!options.labels.empty()) {
        checkGridName(options.labels);
    }
    const auto phantom = make(options);
    const auto& grid = phantom.volume.geometry;
    writeVolume(options.output, phantom.volume);
    if (!options.labels.empty()) {
        volume::writeGrid(options.labels, grid, std::span<const std::uint8_t>(phantom.labels));
    }
    const auto spacing = grid.spacing();
    fmt::print("{}: {}, {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, values {} to {}\n",
               options.output, phantom.volume.name, grid.dims.x, grid.dims.y, grid.dims.z, spacing.x,
               spacing.y, spacing.z, phantom.volume.range.lo, phantom.volume.range.hi);
    const bool isHead = options.kind == kHead;
    constexpr std::array<const char*, 7> head{"air", "scalp", "skull", "CSF", "grey", "white", "ventricles"};
    constexpr std::array<const char*, 4> body{"air", "soft tissue", "bone", "lung"};
    for (std::size_t label = 0; label < (isHead ? head.size() : body.size()); ++label) {
        const auto voxels = std::count(phantom.labels.begin(), phantom.labels.end(), std::uint8_t(label));
        fmt::print("{} {:<12} {:10.1f} ml\n", label, isHead ? head[label] : body[label],
                   double(voxels) * grid.voxelMm3() / 1000);
    }
}

} // namespace

void addPhantomCommand(CLI::App& app) {
    auto* command = app.add_subcommand("phantom", "Make a volume whose tissues are known: a head or a body");
    const auto options = std::make_shared<PhantomOptions>();
    command->add_option("KIND", options->kind, "head (T1-weighted MR, uint8) or body (CT of a chest, int16)")
        ->required()
        ->check(CLI::IsMember({"head", "body"}));
    command->add_option("-o,--output", options->output, "File to write: .nrrd, .nii, .nii.gz, .mha or .mhd")
        ->required();
    command->add_option("--labels", options->labels,
                        "File for the true labels: 0 air; head: 1 scalp, 2 skull, 3 CSF, 4 grey, 5 white, 6 "
                        "ventricles; body: 1 soft tissue, 2 bone, 3 lung");
    command->add_option("--size", options->size,
                        "Voxels along the longest side, N, or along each, NxMxK (head 217: 1 mm; body 512)");
    command
        ->add_option("--noise", options->noisePercent,
                     "Standard deviation in percent of white matter (head), of 1000 HU (body)")
        ->check(between(0, 100))
        ->capture_default_str();
    command
        ->add_option("--bias", options->biasPercent,
                     "Head: how much the sensitivity varies over the brain, 20 for 0.9 to 1.1")
        ->check(between(0, 100))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "Of the noise")->capture_default_str();
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
