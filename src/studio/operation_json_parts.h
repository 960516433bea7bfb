// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/json_reader.h"
#include "studio/operation.h"

#include <nlohmann/json.hpp>

namespace vs::studio {

// What operations in session files are made of. Private to the files that read and write them.

using Json = nlohmann::ordered_json;

Range readRange(const JsonReader& reader);
glm::dvec2 readPoint(const JsonReader& reader);
// Three numbers from -largest to largest.
glm::dvec3 readVector(const JsonReader& reader, double largest);
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

} // namespace vs::studio
