// SPDX-License-Identifier: Apache-2.0
#include "render/transfer_function_json.h"
#include "studio/operation_json.h"
#include "studio/operation_names.h"

#include <nlohmann/json.hpp>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

Json pair(double a, double b) { return Json::array({a, b}); }

Json toJson(const Range& range) { return pair(range.lo, range.hi); }

Json toJson(const render::Camera& camera) {
    return {{"azimuth", camera.azimuthDegrees},
            {"elevation", camera.elevationDegrees},
            {"zoom", camera.zoom},
            {"pan", pair(camera.panMm.x, camera.panMm.y)},
            {"projection", kProjections[std::size_t(camera.projection)]}};
}

Json toJson(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json toJson(const std::vector<render::Placement>& places) {
    Json json = Json::array();
    for (const auto& place : places) {
        json.push_back(
            {{"move", toJson(place.moveMm)}, {"turn", toJson(place.turnDegrees)}, {"scale", place.scale}});
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
    if (!canvas.view.pasted.empty()) {
        json["pasted"] = toJson(canvas.view.pasted);
    }
    return json;
}

template <typename T>
void addIfSet(Json& json, const char* key, const std::optional<T>& value) {
    if (value) {
        json[key] = toJson(*value);
    }
}

// --- one writer per operation, into an object that already has "op"

void write(Json& j, const SetView& op) {
    addIfSet(j, "camera", op.camera);
    if (op.mode) {
        j["mode"] = kModes[std::size_t(*op.mode)];
    }
    addIfSet(j, "range", op.range);
    if (op.sculptureView) {
        j["sculptureView"] = kSculptureViews[std::size_t(*op.sculptureView)];
    }
    addIfSet(j, "transferFunction", op.transferFunction);
    addIfSet(j, "pasted", op.pasted);
    if (op.sampling) {
        j["sampling"] = kSamplings[std::size_t(*op.sampling)];
    }
}

void write(Json& j, const Peel& op) {
    j["layers"] = op.layers;
    j["radius"] = op.radius;
    j["mask"] = toJson(op.mask);
    addIfSet(j, "canvas", op.canvas);
}

void write(Json& j, const Drill& op) {
    j["depthMax"] = op.depthMax;
    j["radius"] = op.radius;
    j["mask"] = toJson(op.mask);
    Json stroke = Json::array();
    for (const auto& pen : op.stroke) {
        stroke.push_back(Json::array({pen.pixel.x, pen.pixel.y, pen.pressure}));
    }
    j["stroke"] = stroke;
    addIfSet(j, "canvas", op.canvas);
}

void write(Json& j, const Seed& op) {
    j["width"] = op.widthPixels;
    j["connectivity"] = op.connectivity;
    addIfSet(j, "range", op.range);
    Json strokes = Json::array();
    for (const auto& stroke : op.strokes) {
        strokes.push_back(toJson(stroke));
    }
    j["strokes"] = strokes;
    Json voxels = Json::array();
    for (const auto& v : op.voxels) {
        voxels.push_back(Json::array({v.x, v.y, v.z}));
    }
    j["voxels"] = voxels;
    addIfSet(j, "canvas", op.canvas);
}

void write(Json& j, const Grow& op) {
    if (op.generations) {
        j["generations"] = *op.generations;
    }
    if (op.sculptureView) {
        j["sculptureView"] = kSculptureViews[std::size_t(*op.sculptureView)];
    }
}

void write(Json& j, const Rewind& op) { j["generations"] = op.generations; }
void write(Json& j, const SetGrowthRange& op) { j["range"] = toJson(op.range); }
void write(Json&, const Undo&) {}
void write(Json&, const Redo&) {}
void write(Json&, const UnCut&) {}
void write(Json&, const ReSeed&) {}

void write(Json& j, const SavePicture& op) {
    j["file"] = op.file;
    j["size"] = Json::array({op.size.x, op.size.y});
    j["samples"] = op.samples;
    j["background"] = render::name(op.background);
    j["annotations"] = op.annotations;
}

void write(Json& j, const SaveLabels& op) { j["file"] = op.file; }
void write(Json& j, const SaveSculpture& op) { j["file"] = op.file; }

} // namespace

Json toJson(const Operation& operation) {
    Json json{{"op", name(operation)}};
    std::visit([&json](const auto& op) { write(json, op); }, operation);
    return json;
}

} // namespace vs::studio
