// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json.h"
#include "studio/json/operation_json_parts.h"
#include "studio/operations/operation_names.h"

#include <nlohmann/json.hpp>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

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
    if (op.shadows) {
        j["shadows"] = *op.shadows;
    }
    if (op.hidesAbove) {
        j["hideAbove"] = *op.hidesAbove;
    }
    if (op.surfaceSmoothing) {
        j["smoothSurface"] = *op.surfaceSmoothing;
    }
    if (op.tintsSegments) {
        j["tintSegments"] = *op.tintsSegments;
    }
}

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
