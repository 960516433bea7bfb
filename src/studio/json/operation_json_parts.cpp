// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json_parts.h"

#include "render/colours/transfer_function_json.h"
#include "studio/operations/operation_names.h"

#include <fmt/ranges.h>

namespace vs::studio {

// --- reading

Range readRange(const JsonReader& reader) {
    const Range range{reader.at(0).number(), reader.at(1).number()};
    reader.expectSize(2);
    if (range.lo > range.hi) {
        reader.fail("its first number must not be above its second");
    }
    return range;
}

glm::dvec2 readPoint(const JsonReader& reader) {
    reader.expectSize(2);
    return {reader.at(0).number(), reader.at(1).number()};
}

render::Camera readCamera(const JsonReader& reader) {
    reader.allow({"azimuth", "elevation", "roll", "zoom", "pan", "projection"});
    render::Camera camera;
    reader.ifHas("azimuth", [&](const JsonReader& r) { camera.azimuthDegrees = r.number(); });
    reader.ifHas("elevation", [&](const JsonReader& r) { camera.elevationDegrees = r.number(); });
    reader.ifHas("roll", [&](const JsonReader& r) { camera.rollDegrees = r.number(); });
    reader.ifHas("zoom", [&](const JsonReader& r) { camera.zoom = r.numberBetween(1e-3, 1e3); });
    reader.ifHas("pan", [&](const JsonReader& r) { camera.panMm = readPoint(r); });
    reader.ifHas("projection", [&](const JsonReader& r) {
        camera.projection = r.choice<render::Projection>(kProjections);
    });
    return camera;
}

// One coordinate of a place on the viewport, or anywhere about it.
double readCoordinate(const JsonReader& reader) {
    constexpr double farthest = 1e6;
    return reader.numberBetween(-farthest, farthest);
}

Sketch readSketch(const JsonReader& reader) {
    reader.allow({"shape", "points"});
    Sketch sketch;
    sketch.shape = reader.member("shape").choice<Shape>(kShapes);
    const JsonReader points = reader.member("points");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const JsonReader point = points.at(i);
        point.expectSize(2);
        sketch.points.emplace_back(readCoordinate(point.at(0)), readCoordinate(point.at(1)));
    }
    const bool isBox =
        sketch.shape == Shape::Ellipse || sketch.shape == Shape::Circle || sketch.shape == Shape::Rectangle;
    if (isBox && sketch.points.size() != 2) {
        points.fail("this shape takes exactly two points");
    }
    return sketch;
}

glm::ivec2 readSize(const JsonReader& reader) {
    reader.expectSize(2);
    return {int(reader.at(0).integerBetween(1, 16384)), int(reader.at(1).integerBetween(1, 16384))};
}

glm::dvec3 readVector(const JsonReader& reader, double largest) {
    reader.expectSize(3);
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) {
        v[i] = reader.at(std::size_t(i)).numberBetween(-largest, largest);
    }
    return v;
}

glm::ivec3 readVoxel(const JsonReader& reader) {
    reader.expectSize(3);
    return {reader.at(0).integerBetween(0, 1 << 20), reader.at(1).integerBetween(0, 1 << 20),
            reader.at(2).integerBetween(0, 1 << 20)};
}

int readConnectivity(const JsonReader& reader) {
    const int connectivity = int(reader.integerBetween(6, 26));
    if (connectivity != 6 && connectivity != 26) {
        reader.fail("must be 6 or 26");
    }
    return connectivity;
}

render::Placement readPlacement(const JsonReader& reader) {
    render::Placement place;
    reader.ifHas("move", [&](const JsonReader& r) { place.moveMm = readVector(r, 1e6); });
    reader.ifHas("turn", [&](const JsonReader& r) { place.turnDegrees = readVector(r, 360); });
    reader.ifHas("scale", [&](const JsonReader& r) { place.scale = r.numberBetween(0.01, 100); });
    return place;
}

std::vector<render::Placement> readPlacements(const JsonReader& reader) {
    constexpr std::size_t most = 16;
    if (reader.size() > most) {
        reader.fail(fmt::format("at most {} parts can be drawn", most));
    }
    std::vector<render::Placement> places;
    for (std::size_t i = 0; i < reader.size(); ++i) {
        reader.at(i).allow({"move", "turn", "scale"});
        places.push_back(readPlacement(reader.at(i)));
    }
    return places;
}

std::optional<render::TransferFunction> readTransferFunction(const JsonReader& reader) {
    if (reader.isNull()) {
        return std::nullopt;
    }
    if (!reader.isText()) {
        return render::transferFunctionFromJson(reader.json(), reader.place());
    }
    const auto preset = render::findPreset(reader.text());
    if (!preset) {
        reader.fail(fmt::format("there is no preset of that name; there are {}",
                                fmt::join(render::presetNames(), ", ")));
    }
    return preset;
}

Canvas readCanvas(const JsonReader& reader) {
    reader.allow({"viewport", "camera", "mode", "range", "sculptureView", "transferFunction", "pasted",
                  "sampling", "hideAbove", "smoothSurface"});
    Canvas canvas;
    canvas.viewport = readSize(reader.member("viewport"));
    canvas.view.camera = readCamera(reader.member("camera"));
    canvas.view.mode = reader.member("mode").choice<render::Mode>(kModes);
    canvas.view.range = readRange(reader.member("range"));
    canvas.view.sculptureView = reader.member("sculptureView").choice<field::SculptureView>(kSculptureViews);
    reader.ifHas("transferFunction",
                 [&](const JsonReader& r) { canvas.view.transferFunction = readTransferFunction(r); });
    reader.ifHas("pasted", [&](const JsonReader& r) { canvas.view.pasted = readPlacements(r); });
    reader.ifHas("sampling",
                 [&](const JsonReader& r) { canvas.view.sampling = r.choice<field::Sampling>(kSamplings); });
    reader.ifHas("hideAbove", [&](const JsonReader& r) { canvas.view.hidesAbove = r.boolean(); });
    reader.ifHas("smoothSurface", [&](const JsonReader& r) {
        canvas.view.surfaceSmoothing = r.numberBetween(0, kMostSurfaceSmoothing);
    });
    return canvas;
}

// --- writing

Json pair(double a, double b) { return Json::array({a, b}); }

Json toJson(const Range& range) { return pair(range.lo, range.hi); }

Json toJson(const render::Camera& camera) {
    return {{"azimuth", camera.azimuthDegrees},
            {"elevation", camera.elevationDegrees},
            {"roll", camera.rollDegrees},
            {"zoom", camera.zoom},
            {"pan", pair(camera.panMm.x, camera.panMm.y)},
            {"projection", kProjections[std::size_t(camera.projection)]}};
}

Json toJson(const glm::ivec3& v) { return Json::array({v.x, v.y, v.z}); }

Json toJson(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json toJson(const render::Placement& place) {
    return {{"move", toJson(place.moveMm)}, {"turn", toJson(place.turnDegrees)}, {"scale", place.scale}};
}

Json toJson(const std::vector<render::Placement>& places) {
    Json json = Json::array();
    for (const auto& place : places) {
        json.push_back(toJson(place));
    }
    return json;
}

Json toJson(const Sketch& sketch) {
    Json points = Json::array();
    for (const auto& p : sketch.points) {
        points.push_back(pair(p.x, p.y));
    }
    return {{"shape", kShapes[std::size_t(sketch.shape)]}, {"points", points}};
}

// A preset by its name, another function whole, none as null.
Json toJson(const std::optional<render::TransferFunction>& function) {
    if (!function) {
        return nullptr;
    }
    for (const std::string& name : render::presetNames()) {
        if (render::findPreset(name) == function) {
            return name;
        }
    }
    return render::toJson(*function);
}

Json toJson(const Canvas& canvas) {
    Json json{{"viewport", Json::array({canvas.viewport.x, canvas.viewport.y})},
              {"camera", toJson(canvas.view.camera)},
              {"mode", kModes[std::size_t(canvas.view.mode)]},
              {"range", toJson(canvas.view.range)},
              {"sculptureView", kSculptureViews[std::size_t(canvas.view.sculptureView)]},
              {"sampling", kSamplings[std::size_t(canvas.view.sampling)]}};
    if (canvas.view.transferFunction) {
        json["transferFunction"] = toJson(canvas.view.transferFunction);
    }
    if (canvas.view.hidesAbove) {
        json["hideAbove"] = true;
    }
    if (canvas.view.surfaceSmoothing > 0) {
        json["smoothSurface"] = canvas.view.surfaceSmoothing;
    }
    if (!canvas.view.pasted.empty()) {
        json["pasted"] = toJson(canvas.view.pasted);
    }
    return json;
}

} // namespace vs::studio
