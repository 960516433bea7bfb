// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include "base/error.h"
#include "gl/context.h"
#include "parse.h"
#include "sculpt/sweep.h"
#include "volume/write.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace vs::cli {

namespace {

struct SweepOptions {
    std::string dims;
    std::string mask;
    std::string path;
    int radius = 3;
    std::string output;
};

glm::ivec3 parseDims(const std::string& text) {
    const auto n = parseNumbers(text, ',', 3, "--dims", "128,128,128");
    for (const double value : n) {
        if (value != std::floor(value) || value < 1 || value > 2048) {
            throw UsageError("--dims {}: each of the three must be a whole number from 1 to 2048", text);
        }
    }
    return glm::ivec3(glm::dvec3(n[0], n[1], n[2]));
}

// "SHAPE:SIZES", sizes in voxels.
sculpt::Outline parseMask(const std::string& text) {
    const auto split = text.find(':');
    const std::string shape = text.substr(0, split);
    const std::string sizes = split == std::string::npos ? "" : text.substr(split + 1);
    const auto positive = [&](std::size_t count, const std::string& example) {
        auto n = parseNumbers(sizes, ',', count, "--mask " + text, example);
        if (!std::all_of(n.begin(), n.end(), [](double value) { return value > 0 && value <= 4096; })) {
            throw UsageError("--mask {}: sizes are in voxels, above 0 and at most 4096", text);
        }
        return n;
    };
    if (shape == "ellipse") {
        const auto n = positive(2, "ellipse:30,20");
        return sculpt::ellipseOutline({0, 0}, {n[0], n[1]});
    }
    if (shape == "circle") {
        return sculpt::circleOutline({0, 0}, positive(1, "circle:20")[0]);
    }
    if (shape == "rectangle") {
        const auto n = positive(2, "rectangle:40,20");
        return sculpt::rectangleOutline({-n[0] / 2, -n[1] / 2}, {n[0] / 2, n[1] / 2});
    }
    throw UsageError("--mask {}: use ellipse:RX,RY, circle:R or rectangle:WIDTH,HEIGHT, in voxels", text);
}

// "line:X0,Y0,Z0:X1,Y1,Z1[:X2,Y2,Z2...]", in voxel space.
std::vector<sculpt::PathPiece> parsePath(const std::string& text) {
    const std::string example = "line:64,64,20:64,64,108";
    if (!text.starts_with("line:")) {
        throw UsageError("--path {}: use {}", text, example);
    }
    std::vector<glm::dvec3> points;
    for (std::size_t begin = 5; begin <= text.size();) {
        const std::size_t end = std::min(text.find(':', begin), text.size());
        const auto n = parseNumbers(text.substr(begin, end - begin), ',', 3, "--path " + text, example);
        points.emplace_back(n[0], n[1], n[2]);
        if (std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])}) > 1e5) {
            throw UsageError("--path {}: coordinates are voxels, at most 100000", text);
        }
        begin = end + 1;
    }
    auto pieces = sculpt::polylinePath(points);
    if (pieces.empty()) {
        throw UsageError("--path {}: needs at least two different points, as in {}", text, example);
    }
    return pieces;
}

void runSweep(const SweepOptions& options) {
    const glm::ivec3 dims = parseDims(options.dims);
    const auto path = parsePath(options.path);
    const auto outline = parseMask(options.mask);
    if (options.radius < 2 || options.radius > 4) {
        throw UsageError("--radius {}: use 2, 3 or 4", options.radius);
    }
    checkGridName(options.output);
    const gl::Context context = gl::Context::createHeadless();
    const auto mask = sculpt::rasterize(outline, sculpt::kSweepPitch);
    sculpt::Radiator radiator;
    sculpt::PointGenerator generator;
    sculpt::sweepMask(radiator, generator, mask, path, dims, sculpt::fitFootprint(options.radius));
    auto values = radiator.download({glm::ivec3(0), dims});
    context.requireNoErrors();
    std::transform(values.begin(), values.end(), values.begin(),
                   [](float e) { return std::clamp(e, 0.0F, 1.0F); });
    volume::writeGrid(options.output, volume::makeGeometry(dims), std::span<const float>(values));
    const auto inside = std::count_if(values.begin(), values.end(), [](float e) { return e >= 0.5F; });
    fmt::print("{}: {} voxels inside (0.5 and above)\n", options.output, inside);
}

} // namespace

void addSweepCommand(CLI::App& app) {
    auto* command = app.add_subcommand("sweep", "Sweep a mask along a path into a volume made from nothing");
    const auto options = std::make_shared<SweepOptions>();
    command->add_option("--dims", options->dims, "Voxels of the volume: NX,NY,NZ")->required();
    command
        ->add_option("--mask", options->mask, "ellipse:RX,RY, circle:R or rectangle:WIDTH,HEIGHT, in voxels")
        ->required();
    command
        ->add_option(
            "--path", options->path,
            "line:X0,Y0,Z0:X1,Y1,Z1 and further corners, in voxels. The mask's x is the volume's x made "
            "perpendicular to the path (its y where the path runs along x), its y completes a "
            "right-handed frame with the path's direction")
        ->required();
    command->add_option("--radius", options->radius, "Radius of the radiation in voxels: 2, 3 or 4")
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "File to write: .nrrd, .nii, .nii.gz, .mha or .mhd")
        ->required();
    command->callback([options] { runSweep(*options); });
}

} // namespace vs::cli
