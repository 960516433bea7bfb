// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_scenarios.h"

#include "field/histogram.h"
#include "render/rays/ray_caster.h"
#include "render/space/macrocells.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"
#include "studio/document/live_mark.h"
#include "studio/document/live_stroke.h"
#include "studio/document/surface_queries.h"

#include <algorithm>
#include <limits>

namespace vs::cli {

namespace {

constexpr int kSlowRuns = 3;     // of what takes seconds
constexpr int kGenerations = 50; // of growth
constexpr double kMaskRadius = 24;
constexpr double kStampWay = 6;     // pixels between drill stamps
constexpr double kLayersEach = 0.5; // of peel

void aim(studio::Document& document, render::Mode mode, const render::Camera& camera) {
    studio::View view = document.view();
    view.mode = mode;
    view.camera = camera;
    document.showView(view);
}

// A new region at the place, grown by some generations at most.
void seed(studio::Document& document, glm::ivec2 size, glm::dvec2 place) {
    document.apply(studio::ReSeed{});
    studio::Seed operation;
    operation.strokes = {circle(place, 4)};
    operation.canvas = studio::Canvas{document.view(), size};
    document.apply(operation);
}

void grow(studio::Document& document) {
    if (!document.facts()->growth.hasSeeds) {
        return;
    }
    document.growing().begin();
    document.growing().growFor(std::numeric_limits<double>::infinity(), kGenerations);
    document.growing().end();
}

void benchDrill(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                std::vector<Measurement>& results) {
    const studio::Canvas canvas{document.view(), settings.size};
    const Work stamps{
        .run =
            [&](int run) {
                document.stroke().drawAt({place + glm::dvec2(kStampWay * run, 0), 1.0});
            },
        .prepare =
            [&](int run) {
                if (run == 0) { // every series of stamps begins on what is untouched
                    if (document.facts()->isStrokeOpen()) {
                        document.stroke().discard();
                    }
                    studio::Drill drill;
                    drill.mask = circle(place, kMaskRadius);
                    drill.canvas = canvas;
                    document.stroke().begin(drill);
                }
            },
    };
    results.push_back(measure("edit", "drill stamp", settings.frames, stamps));
    document.stroke().discard();
}

void benchPeel(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
               std::vector<Measurement>& results) {
    const studio::Canvas canvas{document.view(), settings.size};
    const Work stamps{
        .run = [&](int run) { document.stroke().peelTo(kLayersEach * (run + 1)); },
        .prepare =
            [&](int run) {
                if (run == 0) {
                    if (document.facts()->isStrokeOpen()) {
                        document.stroke().discard();
                    }
                    document.stroke().begin(
                        studio::Peel{circle(place, 2 * kMaskRadius), 0, 3, false, canvas});
                }
            },
    };
    results.push_back(measure("edit", "peel step", settings.frames, stamps));
    document.stroke().discard();
}

void benchMark(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
               std::vector<Measurement>& results) {
    const Work stamps{
        .run =
            [&](int run) {
                document.mark().drawAt({place + glm::dvec2(kStampWay * run, 0), 1.0});
            },
        .prepare =
            [&](int run) {
                if (run == 0) {
                    if (document.facts()->isMarkOpen()) {
                        document.mark().discard();
                    }
                    studio::Mark line;
                    line.widthMm = 4;
                    line.canvas = studio::Canvas{document.view(), settings.size};
                    document.mark().begin(line);
                }
            },
    };
    results.push_back(measure("edit", "mark stamp", settings.frames, stamps));
    document.mark().discard();
}

// The same frame without and with marks: lines across all of the picture, and an area in its middle.
void benchMarkedFrame(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                      std::vector<Measurement>& results) {
    render::RayCaster caster;
    const Work frame{.run = [&](int) {
        caster.render(document.frame(settings.size));
        caster.picture();
    }};
    results.push_back(measure("edit", "frame", settings.frames, frame));
    const glm::dvec2 size(settings.size);
    studio::Mark mark;
    mark.widthMm = 4;
    constexpr int lines = 6;
    int marks = 0; // that have changed something
    for (int i = 0; i < lines; ++i) {
        const double y = size.y * (i + 0.5) / lines;
        mark.sketch = {studio::Shape::Polyline, {{0, y}, {size.x, y}}};
        mark.canvas = studio::Canvas{document.view(), settings.size};
        marks += document.apply(mark).voxelsTouched > 0 ? 1 : 0;
    }
    mark.kind = studio::Mark::Kind::Area;
    mark.sketch = circle(place, size.y / 6);
    marks += document.apply(mark).voxelsTouched > 0 ? 1 : 0;
    results.push_back(measure("edit", "frame with marks", settings.frames, frame));
    for (; marks > 0; --marks) {
        document.apply(studio::Undo{});
    }
}

void addMaterial(studio::Document& document) {
    studio::SetMaterial material;
    material.number = int(document.facts()->materials->size()) + 1;
    document.apply(material);
}

// As benchDrill(), outward.
void benchFill(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
               std::vector<Measurement>& results) {
    addMaterial(document);
    const Work stamps{
        .run =
            [&](int run) {
                document.stroke().drawAt({place + glm::dvec2(kStampWay * run, 0), 1.0, {}});
            },
        .prepare =
            [&](int run) {
                if (run == 0) {
                    if (document.facts()->isStrokeOpen()) {
                        document.stroke().discard();
                    }
                    studio::Drill drill;
                    drill.mask = circle(place, kMaskRadius);
                    drill.canvas = studio::Canvas{document.view(), settings.size};
                    document.stroke().begin(studio::Fill{1, drill});
                }
            },
    };
    results.push_back(measure("edit", "fill stamp", settings.frames, stamps));
    document.stroke().discard();
    document.apply(studio::Undo{});
}

// The frame with material in it: an area in the middle, which lies on what is seen.
void benchFilledFrame(const BenchSettings& settings, studio::Document& document, glm::dvec2 place,
                      std::vector<Measurement>& results) {
    render::RayCaster caster;
    const Work frame{.run = [&](int) {
        caster.render(document.frame(settings.size));
        caster.picture();
    }};
    addMaterial(document);
    studio::Drill drill;
    drill.mask = circle(place, double(settings.size.y) / 8);
    drill.depthMax = 6;
    drill.canvas = studio::Canvas{document.view(), settings.size};
    document.apply(studio::Fill{1, drill});
    results.push_back(measure("edit", "frame with fill", settings.frames, frame));
    document.apply(studio::Undo{});
    document.apply(studio::Undo{});
}

} // namespace

studio::Sketch circle(glm::dvec2 centre, double radius) {
    return {studio::Shape::Circle, {centre, centre + glm::dvec2(radius, 0)}};
}

std::optional<glm::dvec2> findSurface(studio::Document& document, glm::ivec2 size) {
    constexpr int cells = 9;
    std::vector<glm::dvec2> places;
    for (int i = 0; i < cells * cells; ++i) {
        places.push_back((glm::dvec2(i % cells, i / cells) + 0.5) / double(cells) * glm::dvec2(size));
    }
    const auto fromMiddle = [&](glm::dvec2 p) { return glm::distance(p, 0.5 * glm::dvec2(size)); };
    std::stable_sort(places.begin(), places.end(),
                     [&](glm::dvec2 a, glm::dvec2 b) { return fromMiddle(a) < fromMiddle(b); });
    const auto found = std::find_if(places.begin(), places.end(), [&](glm::dvec2 p) {
        return document.surface().probe(p, size).has_value();
    });
    return found == places.end() ? std::nullopt : std::optional(*found);
}

render::Camera Orbit::camera(int frame) const {
    render::Camera camera;
    camera.azimuthDegrees = azimuths[std::size_t(frame) % azimuths.size()];
    camera.elevationDegrees = elevation;
    return camera;
}

void benchReading(const BenchSettings& settings, const std::function<void()>& read,
                  std::vector<Measurement>& results) {
    const Work work{.run = [&](int) { read(); }, .usesDevice = false};
    results.push_back(measure("data", "read file", std::min(settings.frames, kSlowRuns), work));
}

void benchData(const BenchSettings& settings, const volume::Volume& volume, const Range& displayed,
               std::vector<Measurement>& results) {
    const int runs = std::min(settings.frames, kSlowRuns);
    const auto add = [&](const std::string& name, int times, const std::function<void()>& work) {
        results.push_back(measure("data", name, times, {.run = [&](int) { work(); }}));
    };
    field::Field field;
    add("upload", runs, [&] {
        field = {}; // or two copies would be on the device
        field = field::uploadVolume(volume);
    });
    add("histogram", runs, [&] { field::intensityHistogram(field); });
    field::CellRanges cells;
    add("cell ranges", runs, [&] { cells = field::computeCellRanges(field); });
    render::Macrocells macrocells;
    render::Macrocells::Input input;
    input.dataCells = &cells.cells;
    input.visibleRange = field::withTolerance(displayed, field);
    add("macrocells", settings.frames, [&] { macrocells.rebuild(input); });
}

void benchMode(const BenchSettings& settings, studio::Document& document, render::Mode mode,
               std::vector<Measurement>& results) {
    const bool showsRegion = mode == render::Mode::Overlay || mode == render::Mode::Segment;
    if (showsRegion && !document.facts()->growth.hasSeeds) {
        aim(document, render::Mode::Surface, settings.orbit.camera(0));
        if (const auto place = findSurface(document, settings.size)) {
            seed(document, settings.size, *place);
            grow(document);
        }
    }
    render::RayCaster caster;
    const Work frames{.run = [&](int run) {
        aim(document, mode, settings.orbit.camera(run));
        caster.render(document.frame(settings.size));
        caster.picture();
    }};
    results.push_back(measure("mode", render::name(mode), settings.frames, frames));
}

bool benchEdits(const BenchSettings& settings, studio::Document& document,
                std::vector<Measurement>& results) {
    aim(document, render::Mode::Surface, settings.orbit.camera(0));
    const auto place = findSurface(document, settings.size);
    if (!place) {
        return false;
    }
    benchDrill(settings, document, *place, results);
    benchPeel(settings, document, *place, results);
    benchMark(settings, document, *place, results);
    benchMarkedFrame(settings, document, *place, results);
    benchFill(settings, document, *place, results);
    benchFilledFrame(settings, document, *place, results);
    const Work growth{
        .run = [&](int) { grow(document); },
        .prepare = [&](int) { seed(document, settings.size, *place); },
    };
    results.push_back(measure("edit", fmt::format("grow {} generations", kGenerations),
                              std::min(settings.frames, kSlowRuns), growth));
    return true;
}

} // namespace vs::cli
