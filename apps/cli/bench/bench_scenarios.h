// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/bench_measure.h"

#include "studio/document/document.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// The cameras from which frames are rendered, one after the other.
struct Orbit {
    std::vector<double> azimuths{0, 45, 90, 135, 180, 225, 270, 315}; // degrees
    double elevation = 15;

    [[nodiscard]] render::Camera camera(int frame) const;
};

struct BenchSettings {
    glm::ivec2 size{1230, 870};
    int frames = 16;
    Orbit orbit;
};

// A circle as masks are drawn with, in pixels.
studio::Sketch circle(glm::dvec2 centre, double radius);

// The place nearest to the picture's middle, on a coarse grid, where a surface is met; pixels.
std::optional<glm::dvec2> findSurface(studio::Document& document, glm::ivec2 size);

// The scenarios: each function appends what it measured, in the order in which a session would need it.

// Times reading the file, which `read` does.
void benchReading(const BenchSettings& settings, const std::function<void()>& read,
                  std::vector<Measurement>& results);
// Times what is computed once per volume, and the macrocells, which follow the displayed range.
void benchData(const BenchSettings& settings, const volume::Volume& volume, const Range& displayed,
               std::vector<Measurement>& results);
// Times whole pictures, one from each camera of the orbit: every pixel, one ray each, nothing kept from the
// picture before. Modes that show a region get one grown first.
void benchMode(const BenchSettings& settings, studio::Document& document, render::Mode mode,
               std::vector<Measurement>& results);
// Times stamps of drill and peel where the surface is met near the picture's middle, and growth from there.
// Returns false if no surface is met.
bool benchEdits(const BenchSettings& settings, studio::Document& document, std::vector<Measurement>& results);

} // namespace vs::cli
