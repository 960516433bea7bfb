// SPDX-License-Identifier: Apache-2.0
#include "arguments/grow_request.h"

#include "arguments/parse.h"

#include "base/error.h"

#include <cmath>
#include <filesystem>

namespace vs::cli {
namespace {

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

std::optional<Range> parseRule(const std::string& text, const std::string& option) {
    return text.empty() ? std::nullopt : std::optional(parseRange(text, option));
}

std::optional<MaskArgument> parseOptionalMask(const std::string& text, const std::string& option) {
    return text.empty() ? std::nullopt : std::optional(parseMask(text, option));
}

segment::Constraints parseConstraints(const GrowOptions& options) {
    segment::Constraints constraints;
    constraints.range = parseRange(options.range);
    constraints.difference = parseRule(options.difference, "--difference");
    constraints.gradient = parseRule(options.gradient, "--gradient");
    constraints.gradientDifference = parseRule(options.gradientDifference, "--gradient-difference");
    if (constraints.gradient && constraints.gradient->hi < 0) {
        throw UsageError("--gradient '{}' lets nothing in: magnitudes are not below 0", options.gradient);
    }
    if (options.connectivity == "26") {
        constraints.connectivity = segment::Connectivity::TwentySix;
    } else if (options.connectivity != "6") {
        throw UsageError("connectivity '{}' is not known; 6 (faces) and 26 (faces, edges, corners) are",
                         options.connectivity);
    }
    return constraints;
}

int parseSteps(const std::string& text) {
    const double steps = parseNumbers(text, ',', 1, "number of steps", "12").front();
    if (steps < 0 || steps != std::floor(steps) || steps > 1e9) {
        throw UsageError("number of steps '{}' makes no sense; a whole number from 0 on does", text);
    }
    return int(steps);
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

} // namespace

void addGrowOptions(CLI::App& command, GrowOptions& options) {
    command.add_option("--seed", options.seeds, "Voxel to start from, I,J,K counted from 0; may be repeated")
        ->required()
        ->allow_extra_args(false);
    command
        .add_option("--range", options.range,
                    "Values that may be grown into, LO:HI, both included as in all ranges here")
        ->required();
    command.add_option("--difference", options.difference,
                       "How far a voxel's value may lie from that of the voxel it is entered from, LO:HI, "
                       "signed: --difference -5:5");
    command.add_option(
        "--gradient", options.gradient,
        "Gradient magnitude of voxels that may be grown into, LO:HI, the volume's unit per mm");
    command.add_option("--gradient-difference", options.gradientDifference,
                       "As --difference, of the gradient magnitude");
    command.add_option("--connectivity", options.connectivity, "Neighbours of a voxel: 6 (default) or 26");
    command.add_option("--steps", options.steps,
                       "Number of expansions; 0 gives the seeds. Default: until nothing grows");
    command.add_option(
        "--inside", options.inside,
        "Grow only within these labels of a label map, FILE[:LABEL[,LABEL...]]; without labels "
        "where it is not 0");
    command.add_option("--labels-in", options.labelsIn,
                       "Label map of segments that are there already: they are kept and never entered, and "
                       "the region gets the next free label");
    command
        .add_option("-o,--output", options.labels,
                    "Label volume to write (1 in the region, else 0; with --labels-in its labels too)")
        ->required();
    command.add_option("--generations", options.generations,
                       "Volume to write with each voxel's generation (seeds 1, outside 0)");
    command.add_option("--compare", options.compare,
                       "Label map to compare with, FILE[:LABEL[,LABEL...]]; without labels all but 0 counts");
}

GrowRequest understand(const GrowOptions& options) {
    GrowRequest request;
    for (const std::string& text : options.seeds) {
        request.seeds.push_back(parseSeed(text));
    }
    request.constraints = parseConstraints(options);
    if (!options.steps.empty()) {
        request.steps = parseSteps(options.steps);
    }
    request.inside = parseOptionalMask(options.inside, "--inside");
    request.truth = parseOptionalMask(options.compare, "--compare");
    checkOutputs(options);
    return request;
}

} // namespace vs::cli
