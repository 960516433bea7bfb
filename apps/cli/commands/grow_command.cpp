// SPDX-License-Identifier: Apache-2.0
// vstudio grow: region growing from given voxels, labels and generations written as volumes.
#include "arguments/grow_request.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/label_map.h"
#include "reports/measurements.h"
#include "reports/progress.h"

#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "segment/edits/label_sets.h"
#include "segment/growth/growth.h"
#include "segment/measures/agreement.h"
#include "volume/io/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {
namespace {

// What growing goes by, read and checked before there is a device. All masks lie on the volume's grid.
struct GrowInput {
    volume::Volume volume;
    std::vector<std::uint8_t> inside; // empty: everywhere
    std::optional<LabelMap> others;   // segments that are there already
    std::vector<std::uint8_t> truth;  // empty: none
};

LabelMap readOthers(const std::string& path, const volume::Volume& volume) {
    LabelMap map = readLabelMap(path);
    requireSameGrid(map, volume.geometry, volume.path);
    if (map.values.size() > 255) {
        throw Error("{}: holds {} labels; with 254 or fewer there is room for one more", path,
                    map.values.size() - 1);
    }
    return map;
}

GrowInput read(const GrowRequest& request, const GrowOptions& options, const VolumeArgument& argument) {
    GrowInput input{loadVolume(argument).volume, {}, {}, {}};
    const volume::Volume& volume = input.volume;
    const glm::ivec3 dims = volume.geometry.dims;
    for (const glm::ivec3 s : request.seeds) {
        if (glm::any(glm::lessThan(s, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(s, dims))) {
            throw Error("{}: the seed {},{},{} lies outside; indices run from 0,0,0 to {},{},{}",
                        volume.path.string(), s.x, s.y, s.z, dims.x - 1, dims.y - 1, dims.z - 1);
        }
    }
    if (request.inside) {
        input.inside = readMask(*request.inside, volume);
    }
    if (!options.labelsIn.empty()) {
        input.others = readOthers(options.labelsIn, volume);
    }
    if (request.truth) {
        input.truth = readMask(*request.truth, volume);
    }
    return input;
}

// The segments that are there already, each with its label; afterwards the next one is at work.
void placeOthers(segment::Growth& growth, const LabelMap& map) {
    const std::size_t count = map.values.size();
    const glm::ivec3 dims = map.geometry.dims;
    const auto boxes = segment::labelBoxes(map.labels, dims);
    for (std::size_t label = 1; label < count; ++label) {
        const auto set = segment::setOf(map.labels, dims, std::uint8_t(label), boxes[label]);
        growth.activate(std::uint8_t(label));
        growth.replace(set.box, set.inside);
    }
    growth.activate(std::uint8_t(count));
}

// The seeds that growth may begin from; a line on standard error says that others are left out. Throws Error
// if there are none. The growth is empty before and after.
std::vector<glm::ivec3> admittedSeeds(segment::Growth& growth, const GrowRequest& request,
                                      const GrowInput& input) {
    const volume::Volume& volume = input.volume;
    const segment::Constraints& rules = request.constraints;
    const auto complaint = [&](glm::ivec3 s) -> std::string {
        const glm::ivec3 dims = volume.geometry.dims;
        const std::size_t place =
            std::size_t(s.x) +
            std::size_t(dims.x) * (std::size_t(s.y) + std::size_t(dims.y) * std::size_t(s.z));
        if (!input.inside.empty() && input.inside[place] == 0) {
            return fmt::format("lies outside the mask {}", request.inside->path.string());
        }
        if (input.others && input.others->labels[place] != 0) {
            return fmt::format("lies in the segment {} of {}",
                               input.others->values[input.others->labels[place]],
                               input.others->path.string());
        }
        if (growth.addSeeds(std::span(&s, 1)).refused == 0) {
            return {};
        }
        if (!segment::isInRange(growth.field(), rules.range, volume.at(s))) {
            return fmt::format("has the value {:g}, not in the range {:g}:{:g}", volume.at(s), rules.range.lo,
                               rules.range.hi);
        }
        return fmt::format("has a gradient that is not in {:g}:{:g}", rules.gradient->lo, rules.gradient->hi);
    };
    std::vector<glm::ivec3> admitted;
    std::string first;
    for (const glm::ivec3 s : request.seeds) {
        if (const std::string reason = complaint(s); reason.empty()) {
            admitted.push_back(s);
        } else if (first.empty()) {
            first = fmt::format("{},{},{} {}", s.x, s.y, s.z, reason);
        }
    }
    growth.reset();
    if (admitted.empty()) {
        throw Error("{}: no seed may grow: {}; seed elsewhere or allow more", volume.path.string(), first);
    }
    if (admitted.size() < request.seeds.size()) {
        fmt::print(stderr, "note: {} of {} seeds left out: {}\n", request.seeds.size() - admitted.size(),
                   request.seeds.size(), first);
    }
    return admitted;
}

// Seeds and expansions; what growth alone takes, in milliseconds.
double grow(segment::Growth& growth, const GrowRequest& request, const GrowInput& input) {
    if (input.others) {
        placeOthers(growth, *input.others);
    }
    growth.setConstraints(request.constraints);
    const auto seeds = admittedSeeds(growth, request, input);
    const auto clear = [&] {
        growth.reset();
        if (!input.inside.empty()) {
            growth.confine(input.inside); // anew: reset forgets it
        }
    };
    // A first expansion compiles what drivers compile when first used, so that it is not taken for growing.
    clear();
    growth.addSeeds(seeds);
    growth.advance(std::min(request.steps, 1));
    clear();
    gl::Context::finish();
    const Timer timer;
    growth.addSeeds(seeds);
    Progress progress("growing", 0);
    if (progress.isTerminal()) {
        constexpr double portionMs = 300;
        for (int left = request.steps; left > 0 && !growth.isFinished();) {
            left -= growth.advanceFor(portionMs, left);
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
    const GrowInput input = read(request, options, argument);
    const volume::GridGeometry& geometry = input.volume.geometry;
    std::vector<std::int64_t> values = input.others ? input.others->values : std::vector<std::int64_t>{0};
    values.push_back(input.others ? nextFreeValue(*input.others) : 1);
    const auto context = gl::Context::createHeadless();
    field::Field field = field::uploadVolume(input.volume);
    field.onHost = &input.volume;
    segment::Growth growth(field);
    const double milliseconds = grow(growth, request, input);
    const auto labels = growth.labelMap();
    const auto generations =
        options.generations.empty() ? std::vector<std::uint32_t>() : growth.generations(true);
    context.requireNoErrors();
    writeLabelMap(options.labels, geometry, labels, values);
    if (!options.generations.empty()) {
        volume::writeGrid(options.generations, geometry, generations);
    }
    const auto voxels = growth.voxelCount();
    if (input.others) {
        fmt::print("label        {}\n", values.back());
    }
    fmt::print("voxels       {}\n", voxels);
    fmt::print("generations  {}\n", growth.playhead());
    fmt::print("volume       {:.6g} ml\n", double(voxels) * geometry.voxelMm3() / 1000.0);
    fmt::print("milliseconds {:.1f}\n", milliseconds);
    fmt::print("voxels/s     {:.0f}\n", double(voxels) / std::max(milliseconds, 1e-3) * 1000.0);
    if (request.truth) {
        printAgreement(segment::compare(geometry, growth.labels(), input.truth));
    }
}

} // namespace

void addGrowCommand(CLI::App& app) {
    auto* command = app.add_subcommand("grow", "Grows a region from seeds within a range of values");
    const auto argument = addVolumeArgument(*command);
    const auto options = std::make_shared<GrowOptions>();
    addGrowOptions(*command, *options);
    command->callback([argument, options] { run(*options, *argument); });
}

} // namespace vs::cli
