// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_strokes.h"

#include "phantom/phantom.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"

#include <fmt/format.h>

#include <algorithm>

namespace vs::cli {

namespace {

constexpr double kElementSteps = 0.5; // from one mask element to the next (studio::CutStroke)

void beginDrill(studio::Document& document, const studio::Sketch& mask, const studio::Canvas& canvas) {
    studio::Drill drill;
    drill.mask = mask;
    drill.canvas = canvas;
    document.stroke().begin(drill);
}

// The radius in pixels of a circle whose mask is so many elements wide.
double radiusOf(double elements, const studio::Document& document, glm::ivec2 size) {
    const auto& geometry = document.volume().geometry;
    const auto rays = render::viewRays(document.view().camera, geometry, size);
    return 0.5 * elements * kElementSteps * geometry.stepMm() / rays.pixelMm(geometry.centreWorld());
}

// Whatever was drawn is gone, and what a picture needs is up to date again.
void clearStroke(studio::Document& document, glm::ivec2 size) {
    if (document.facts()->isStrokeOpen()) {
        document.stroke().discard();
        document.frame(size);
    }
}

// Beside a stroke made before: what pen-down with the first stamp costs, each stamp after it, and pen-up.
void benchDrillStrokes(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                       std::vector<Measurement>& results) {
    const studio::Canvas canvas{document.view(), settings.size};
    const double radius = radiusOf(100, document, settings.size);
    const auto begin = [&] { beginDrill(document, circle(place, radius), canvas); };
    const auto stamp = [&](int n) {
        document.stroke().drawAt({place + glm::dvec2(0.25 * radius * (4 + n % 4), 0), 1.0});
    };
    begin();
    document.stroke().drawAt({place, 1.0});
    document.stroke().commit();
    document.frame(settings.size);

    const Work penDown{.run =
                           [&](int) {
                               begin();
                               stamp(0);
                           },
                       .prepare = [&](int) { clearStroke(document, settings.size); }};
    results.push_back(measure("stroke", "drill pen-down", settings.frames, penDown));
    const Work stamps{.run = [&](int run) { stamp(1 + run); },
                      .prepare =
                          [&](int run) {
                              if (run % 3 == 0) {
                                  clearStroke(document, settings.size);
                                  begin();
                                  stamp(0);
                              }
                          }};
    results.push_back(measure("stroke", "drill stamp", settings.frames, stamps));
    clearStroke(document, settings.size);
    const Work penUp{.run = [&](int) { document.stroke().commit(); },
                     .prepare =
                         [&](int run) {
                             if (document.facts()->canUndo()) { // the stroke beside, or the last one
                                 document.apply(studio::Undo{});
                             }
                             begin();
                             stamp(run);
                         }};
    results.push_back(measure("stroke", "drill pen-up", settings.frames, penUp));
    document.apply(studio::Undo{});
}

void benchPeelLayer(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                    std::vector<Measurement>& results) {
    const studio::Canvas canvas{document.view(), settings.size};
    const double radius = radiusOf(300, document, settings.size);
    const Work layer{
        .run =
            [&](int) {
                document.stroke().begin(studio::Peel{circle(place, radius), 0, 3, false, canvas});
                document.stroke().peelTo(1);
            },
        .prepare = [&](int) { clearStroke(document, settings.size); }};
    results.push_back(measure("stroke", "peel, first layer", settings.frames, layer));
    document.stroke().discard();
}

void benchPeelDrag(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                   std::vector<Measurement>& results) {
    const studio::Canvas canvas{document.view(), settings.size};
    constexpr int updates = 40;
    document.stroke().begin(studio::Peel{circle(place, 150), 0, 3, false, canvas});
    const Work down{.run = [&](int run) { document.stroke().peelTo(0.1 + 0.5 * run); }};
    results.push_back(measure("stroke", "peel, drawn down", updates, down));
    const Work up{.run = [&](int run) { document.stroke().peelTo(0.1 + 0.5 * (updates - 1 - run)); }};
    results.push_back(measure("stroke", "peel, drawn up", updates, up));
    document.stroke().discard();
}

} // namespace

volume::Volume ballIn(int side) {
    auto volume = phantom::makePhantom(glm::ivec3(side), volume::ScalarType::UInt8, [&](glm::dvec3 p) {
        const double inBall = 54 - glm::distance(p, glm::dvec3(0.5 * (side - 1)));
        return 200 * std::clamp(inBall / 4 + 0.5, 0.0, 1.0);
    });
    volume.name = fmt::format("ball in {}", side);
    return volume;
}

bool benchStrokes(const BenchSettings& settings, studio::Document& document,
                  std::vector<Measurement>& results) {
    studio::View view = document.view();
    view.mode = render::Mode::Surface;
    view.camera = settings.orbit.camera(0);
    document.showView(view);
    const auto place = findSurface(document, settings.size);
    if (!place) {
        return false;
    }
    benchDrillStrokes(settings, document, *place, results);
    benchPeelLayer(settings, document, *place, results);
    benchPeelDrag(settings, document, *place, results);
    return true;
}

} // namespace vs::cli
