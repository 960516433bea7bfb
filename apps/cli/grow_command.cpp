// SPDX-License-Identifier: Apache-2.0
// vstudio grow: region growing from given voxels, labels and generations written as volumes.
#include "commands.h"
#include "measurements.h"
#include "parse.h"
#include "progress.h"
#include "truth_argument.h"
#include "volume_argument.h"

#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "segment/agreement.h"
#include "segment/growth.h"
#include "volume/write.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {
namespace {

struct GrowOptions {
    std::vector<std::string> seeds;
    std::string range;
    std::string connectivity = "6";
    std::string steps;
    std::string labels;
    std::string generations;
    std::string compare;
};

// Everything on the command line, understood before anything is read.
struct GrowRequest {
    std::vector<glm::ivec3> seeds;
    segment::Constraints constraints;
    int steps = std::numeric_limits<int>::max();
    std::optional<TruthArgument> truth;
};

glm::ivec3 parseSeed(const std::string& text) {
    const auto values = parseNumbers(text, ',', 3, "seed", "150,185,200");
    for (const double v : values) {
        if (v != std::floor(v) || std::abs(v) > 1e6) {
            throw UsageError(
                "seed '{}' is not a voxel; write three whole numbers counted from 0, like 150,185,200", text);
        }
    }
    return {int(values[0]), int(values[1]), int(values[2])};
}

void checkOutputs(const GrowOptions& options) {
    checkGridName(options.labels);
    if (options.generations.empty()) {
        return;
    }
    checkGridName(options.generations);
    const auto placeOf = [](const std::string& file) {
        std::error_code ignored; // writing will tell what is wrong
        return std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
    };
    const auto labels = placeOf(options.labels);
    if (!labels.empty() && labels == placeOf(options.generations)) {
        throw UsageError("--generations {}: is the file of -o too; give another name", options.generations);
    }
}

GrowRequest understand(const GrowOptions& options) {
    GrowRequest request;
    for (const std::string& text : options.seeds) {
        request.seeds.push_back(parseSeed(text));
    }
    request.constraints.range = parseRange(options.range);
    if (options.connectivity == "26") {
        request.constraints.connectivity = segment::Connectivity::TwentySix;
    } else if (options.connectivity != "6") {
        throw UsageError("connectivity '{}' is not known; 6 (faces) and 26 (faces, edges, corners) are",
                         options.connectivity);
    }
    if (!options.steps.empty()) {
        const double steps = parseNumbers(options.steps, ',', 1, "number of steps", "12").front();
        if (steps < 0 || steps != std::floor(steps) || steps > 1e9) {
            throw UsageError("number of steps '{}' makes no sense; a whole number from 0 on does",
                             options.steps);
        }
        request.steps = int(steps);
    }
    if (!options.compare.empty()) {
        request.truth = parseTruth(options.compare);
    }
    checkOutputs(options);
    return request;
}

void checkSeeds(const GrowRequest& request, const volume::Volume& volume) {
    const glm::ivec3 dims = volume.geometry.dims;
    for (const glm::ivec3 s : request.seeds) {
        if (glm::any(glm::lessThan(s, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(s, dims))) {
            throw Error("{}: the seed {},{},{} lies outside; indices run from 0,0,0 to {},{},{}",
                        volume.path.string(), s.x, s.y, s.z, dims.x - 1, dims.y - 1, dims.z - 1);
        }
    }
}

// Seeds and expansions; what growth alone takes, in milliseconds.
double grow(segment::Growth& growth, const GrowRequest& request, const volume::Volume& volume) {
    growth.setConstraints(request.constraints);
    const auto counts = growth.addSeeds(request.seeds);
    if (counts.added == 0) {
        const glm::ivec3 s = request.seeds.front();
        const Range range = request.constraints.range;
        throw Error("{}: no seed lies in the range {:g}:{:g}: {},{},{} has the value {:g}; widen the range "
                    "or seed elsewhere",
                    volume.path.string(), range.lo, range.hi, s.x, s.y, s.z, volume.at(s));
    }
    if (counts.refused > 0) {
        fmt::print(stderr, "note: {} of {} seeds lie outside the range and are left out\n", counts.refused,
                   request.seeds.size());
    }
    // A first expansion compiles what drivers compile when first used, so that it is not taken for growing.
    growth.advance(std::min(request.steps, 1));
    growth.reset();
    gl::Context::finish();
    const Timer timer;
    growth.addSeeds(request.seeds);
    Progress progress("growing", 0);
    if (progress.isTerminal()) {
        constexpr double sliceMs = 300;
        for (int left = request.steps; left > 0 && !growth.isFinished();) {
            left -= growth.advanceFor(sliceMs, left);
            progress.show(fmt::format("{} voxels, generation {}", growth.voxelCount(), growth.playhead()));
        }
    } else {
        growth.advance(request.steps);
    }
    gl::Context::finish();
    return timer.milliseconds();
}

void run(const GrowOptions& options, const VolumeArgument& argument) {
    const GrowRequest request = understand(options);
    const auto loaded = loadVolume(argument);
    const volume::Volume& volume = loaded.volume;
    checkSeeds(request, volume);
    const auto truth = request.truth ? readTruth(*request.truth, volume) : std::vector<std::uint8_t>();
    const auto context = gl::Context::createHeadless();
    const field::Field field = field::uploadVolume(volume);
    segment::Growth growth(field);
    const double milliseconds = grow(growth, request, volume);
    const auto labels = growth.labels();
    const auto generations =
        options.generations.empty() ? std::vector<std::uint32_t>() : growth.generations(true);
    context.requireNoErrors();
    volume::writeGrid(options.labels, volume.geometry, labels);
    if (!options.generations.empty()) {
        volume::writeGrid(options.generations, volume.geometry, generations);
    }
    const auto voxels = growth.voxelCount();
    fmt::print("voxels       {}\n", voxels);
    fmt::print("generations  {}\n", growth.playhead());
    fmt::print("volume       {:.6g} ml\n", double(voxels) * volume.geometry.voxelMm3() / 1000.0);
    fmt::print("milliseconds {:.1f}\n", milliseconds);
    fmt::print("voxels/s     {:.0f}\n", double(voxels) / std::max(milliseconds, 1e-3) * 1000.0);
    if (request.truth) {
        printAgreement(segment::compare(volume.geometry, labels, truth));
    }
}

} // namespace

void addGrowCommand(CLI::App& app) {
    auto* command = app.add_subcommand("grow", "Grows a region from seeds within a range of values");
    const auto argument = addVolumeArgument(*command);
    const auto options = std::make_shared<GrowOptions>();
    command
        ->add_option("--seed", options->seeds, "Voxel to start from, I,J,K counted from 0; may be repeated")
        ->required()
        ->allow_extra_args(false);
    command->add_option("--range", options->range, "Values that may be grown into, LO:HI, both included")
        ->required();
    command->add_option("--connectivity", options->connectivity, "Neighbours of a voxel: 6 (default) or 26");
    command->add_option("--steps", options->steps,
                        "Number of expansions; 0 gives the seeds. Default: until nothing grows");
    command->add_option("-o,--output", options->labels, "Label volume to write (1 in the region, else 0)")
        ->required();
    command->add_option("--generations", options->generations,
                        "Volume to write with each voxel's generation (seeds 1, outside 0)");
    command->add_option(
        "--compare", options->compare,
        "Label map to compare with, FILE[:LABEL[,LABEL...]]; without labels all but 0 counts");
    command->callback([argument, options] { run(*options, *argument); });
}

} // namespace vs::cli
