// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/json_reader.h"
#include "studio/operations/operation.h"

#include <nlohmann/json.hpp>

namespace vs::studio {

// What operations in session files are made of. Private to the files that read and write them.

using Json = nlohmann::ordered_json;

Range readRange(const JsonReader& reader);
glm::dvec2 readPoint(const JsonReader& reader);
// Three numbers from -largest to largest.
glm::dvec3 readVector(const JsonReader& reader, double largest);
// A voxel of some grid.
glm::ivec3 readVoxel(const JsonReader& reader);
// 6 or 26.
int readConnectivity(const JsonReader& reader);
// One coordinate of a place on the viewport, or anywhere about it.
double readCoordinate(const JsonReader& reader);
glm::ivec2 readSize(const JsonReader& reader);
render::Camera readCamera(const JsonReader& reader);
Sketch readSketch(const JsonReader& reader);
// The members move, turn and scale of an object that may have others.
render::Placement readPlacement(const JsonReader& reader);
std::vector<render::Placement> readPlacements(const JsonReader& reader);
std::optional<render::TransferFunction> readTransferFunction(const JsonReader& reader);
Canvas readCanvas(const JsonReader& reader);

Json pair(double a, double b);
Json toJson(const Range& range);
Json toJson(const render::Camera& camera);
Json toJson(const glm::dvec3& v);
Json toJson(const glm::ivec3& v);
Json toJson(const render::Placement& place);
Json toJson(const std::vector<render::Placement>& places);
Json toJson(const Sketch& sketch);
// A preset by its name, another function whole, none as null.
Json toJson(const std::optional<render::TransferFunction>& function);
Json toJson(const Canvas& canvas);

template <typename T>
void addIfSet(Json& json, const char* key, const std::optional<T>& value) {
    if (value) {
        json[key] = toJson(*value);
    }
}

// The operations that cut (cut_operations_json.cpp).
Operation readPeel(const JsonReader& reader);
Operation readDrill(const JsonReader& reader);
Operation readLaser(const JsonReader& reader);
Operation readSweep(const JsonReader& reader);
Operation readScissors(const JsonReader& reader);
Operation readClip(const JsonReader& reader);
Operation readKeepConnected(const JsonReader& reader);
Operation readPaste(const JsonReader& reader);
Operation readMovePart(const JsonReader& reader);

// The operations that find voxels under strokes and brushes (painting_operations_json.cpp).
Operation readSeed(const JsonReader& reader);
Operation readAbsorb(const JsonReader& reader);
Operation readPaintSegment(const JsonReader& reader);

// The operations on segments (segment_operations_json.cpp).
Operation readGrow(const JsonReader& reader);
Operation readRewind(const JsonReader& reader);
Operation readShowGeneration(const JsonReader& reader);
Operation readGrowthRules(const JsonReader& reader);
Operation readUseSegment(const JsonReader& reader);
Operation readLoadLabels(const JsonReader& reader);
Operation readRemoveSegment(const JsonReader& reader);
Operation readEditSegment(const JsonReader& reader);
Operation readBrushSegment(const JsonReader& reader);
Operation readCutSegment(const JsonReader& reader);

// Into an object that already has "op".
void write(Json& j, const Peel& op);
void write(Json& j, const Drill& op);
void write(Json& j, const Laser& op);
void write(Json& j, const Sweep& op);
void write(Json& j, const Scissors& op);
void write(Json& j, const Clip& op);
void write(Json& j, const KeepConnected& op);
void write(Json& j, const Paste& op);
void write(Json& j, const MovePart& op);
void write(Json& j, const Seed& op);
void write(Json& j, const Grow& op);
void write(Json& j, const Rewind& op);
void write(Json& j, const ShowGeneration& op);
void write(Json& j, const SetGrowthRules& op);
void write(Json& j, const Absorb& op);
void write(Json& j, const UseSegment& op);
void write(Json& j, const LoadLabels& op);
void write(Json& j, const RemoveSegment& op);
void write(Json& j, const EditSegment& op);
void write(Json& j, const BrushSegment& op);
void write(Json& j, const PaintSegment& op);
void write(Json& j, const CutSegment& op);

} // namespace vs::studio
