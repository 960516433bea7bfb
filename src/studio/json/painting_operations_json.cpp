// SPDX-License-Identifier: Apache-2.0
// Operations that find voxels under strokes and brushes, in session files.
#include "studio/json/operation_json.h"
#include "studio/json/operation_json_parts.h"
#include "studio/operations/operation_names.h"

namespace vs::studio {

namespace {

constexpr int kMostExpansions = 1 << 30;
constexpr double kMostMm = 1e4;

// The members of operations that are drawn and find voxels.
template <typename Op>
void readStrokes(const JsonReader& reader, Op& op) {
    reader.ifHas("width", [&](const JsonReader& r) { op.widthPixels = r.numberBetween(0.1, 1000); });
    reader.ifHas("strokes", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            op.strokes.push_back(readSketch(r.at(i)));
        }
    });
    reader.ifHas("voxels", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            op.voxels.push_back(readVoxel(r.at(i)));
        }
    });
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
}

constexpr std::array<const char*, 3> kVoxelAxes{"x", "y", "z"};

Trail readTrail(const JsonReader& reader) {
    reader.allow({"points", "radius", "axis"});
    constexpr double kFarthest = 1e6; // voxels
    Trail trail;
    const JsonReader points = reader.member("points");
    for (std::size_t i = 0; i < points.size(); ++i) {
        trail.points.push_back(readVector(points.at(i), kFarthest));
    }
    if (trail.points.empty()) {
        points.fail("needs at least one point");
    }
    reader.ifHas("radius", [&](const JsonReader& r) { trail.radiusMm = r.numberBetween(0, kMostMm); });
    reader.ifHas("axis", [&](const JsonReader& r) {
        enum class Axis {};
        trail.axis = int(r.choice<Axis>(kVoxelAxes));
    });
    return trail;
}

Json jsonOf(const Trail& trail) {
    Json points = Json::array();
    for (const glm::dvec3 point : trail.points) {
        points.push_back(studio::toJson(point));
    }
    Json json{{"points", points}, {"radius", trail.radiusMm}};
    if (trail.axis) {
        json["axis"] = kVoxelAxes[std::size_t(*trail.axis)];
    }
    return json;
}

template <typename Op>
void writeStrokes(Json& j, const Op& op) {
    Json strokes = Json::array();
    for (const auto& stroke : op.strokes) {
        strokes.push_back(studio::toJson(stroke));
    }
    j["strokes"] = strokes;
    Json voxels = Json::array();
    for (const auto& voxel : op.voxels) {
        voxels.push_back(studio::toJson(voxel));
    }
    j["voxels"] = voxels;
    addIfSet(j, "canvas", op.canvas);
}

} // namespace

Operation readSeed(const JsonReader& reader) {
    reader.allow({"op", "strokes", "width", "range", "connectivity", "voxels", "canvas", "trails"});
    Seed op;
    reader.ifHas("connectivity", [&](const JsonReader& r) { op.connectivity = readConnectivity(r); });
    reader.ifHas("range", [&](const JsonReader& r) { op.range = readRange(r); });
    readStrokes(reader, op);
    reader.ifHas("trails", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            op.trails.push_back(readTrail(r.at(i)));
        }
    });
    if (op.strokes.empty() && op.voxels.empty() && op.trails.empty()) {
        reader.fail("needs 'strokes', 'trails' or 'voxels'");
    }
    return op;
}

void write(Json& j, const Seed& op) {
    j["width"] = op.widthPixels;
    j["connectivity"] = op.connectivity;
    addIfSet(j, "range", op.range);
    writeStrokes(j, op);
    if (!op.trails.empty()) {
        Json trails = Json::array();
        for (const Trail& trail : op.trails) {
            trails.push_back(jsonOf(trail));
        }
        j["trails"] = trails;
    }
}

Operation readAbsorb(const JsonReader& reader) {
    reader.allow({"op", "strokes", "width", "expansions", "voxels", "canvas"});
    Absorb op;
    reader.ifHas("expansions",
                 [&](const JsonReader& r) { op.expansions = int(r.integerBetween(0, kMostExpansions)); });
    readStrokes(reader, op);
    if (op.strokes.empty() && op.voxels.empty()) {
        reader.fail("needs 'strokes' or 'voxels'");
    }
    return op;
}

void write(Json& j, const Absorb& op) {
    j["width"] = op.widthPixels;
    if (op.expansions) {
        j["expansions"] = *op.expansions;
    }
    writeStrokes(j, op);
}

Operation readPaintSegment(const JsonReader& reader) {
    reader.allow({"op", "adds", "trail", "range"});
    PaintSegment op;
    op.isToAdd = reader.member("adds").boolean();
    op.trail = readTrail(reader.member("trail"));
    reader.ifHas("range", [&](const JsonReader& r) { op.range = readRange(r); });
    return op;
}

void write(Json& j, const PaintSegment& op) {
    j["adds"] = op.isToAdd;
    j["trail"] = jsonOf(op.trail);
    addIfSet(j, "range", op.range);
}

} // namespace vs::studio
