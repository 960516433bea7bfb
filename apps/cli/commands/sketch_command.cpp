// SPDX-License-Identifier: Apache-2.0
// vstudio sketch: a picture as a sketch for session files.
#include "commands/commands.h"

#include "arguments/parse.h"
#include "base/error.h"
#include "sculpt/mask/outline_image.h"
#include "volume/reading/read_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace vs::cli {

namespace {

struct SketchOptions {
    std::string picture;
    std::string centre;
    double width = 200;
};

void runSketch(const SketchOptions& options) {
    const auto centre = parseNumbers(options.centre, ',', 2, "--centre", "615,435");
    const auto outline = sculpt::outlineFromImage(volume::readPicture(options.picture), options.width);
    std::string points;
    for (const glm::dvec2 point : outline) { // pictures run down, outlines up
        points += fmt::format("{}[{:.2f}, {:.2f}]", points.empty() ? "" : ", ", centre[0] + point.x,
                              centre[1] - point.y);
    }
    fmt::print("{{\"shape\": \"stencil\", \"points\": [{}]}}\n", points);
}

} // namespace

void addSketchCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "sketch", "Print the outline of what a picture shows as a mask for session files (doc/session.md)");
    auto options = std::make_shared<SketchOptions>();
    command
        ->add_option("picture", options->picture,
                     "PNG: inside is what is bright, or opaque where it has transparency")
        ->required();
    command->add_option("--centre", options->centre, "Where its middle lies on the viewport, X,Y in pixels")
        ->required();
    command->add_option("--width", options->width, "Its width there, in pixels")
        ->capture_default_str()
        ->check(between(1, 1e5));
    command->callback([options] { runSketch(*options); });
}

} // namespace vs::cli
