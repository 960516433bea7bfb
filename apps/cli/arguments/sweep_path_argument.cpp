// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"
#include "arguments/sweep_arguments.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/lines.h"
#include "sculpt/radiation/sweep.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace vs::cli {

namespace {

constexpr double kFarthest = 1e5; // voxels

glm::dvec3 parsePlace(const std::string& text, const std::string& path, const std::string& example) {
    const auto n = parseNumbers(text, ',', 3, "--path " + path, example);
    if (std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])}) > kFarthest) {
        throw UsageError("--path {}: coordinates are voxels, at most {:g}", path, kFarthest);
    }
    return {n[0], n[1], n[2]};
}

std::vector<glm::dvec3> parsePlaces(const std::string& text, const std::string& path,
                                    const std::string& example) {
    std::vector<glm::dvec3> places;
    for (const std::string& part : split(text, ':')) {
        places.push_back(parsePlace(part, path, example));
    }
    return places;
}

// A text file of one place a line, "X Y Z" or "X,Y,Z"; what follows # is a comment.
std::vector<glm::dvec3> readPlaces(const std::string& file) {
    const std::string noFile = whyNoFile(file);
    std::ifstream stream(noFile.empty() ? file : std::string());
    if (!stream) {
        throw ReadError("{}: {}; a recorded path is a text file of lines X Y Z, in voxels", file,
                        noFile.empty() ? "cannot be opened" : noFile);
    }
    std::vector<glm::dvec3> places;
    int number = 0;
    for (std::string line; nextLine(stream, line, file);) {
        ++number;
        line = line.substr(0, line.find('#'));
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        glm::dvec3 p(0);
        std::string rest;
        if (words >> std::ws; words.eof()) {
            continue;
        }
        const bool isPlace = bool(words >> p.x >> p.y >> p.z) && !(words >> rest);
        if (!isPlace || !(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest)) {
            throw ReadError("{}: line {} is not three numbers X Y Z, in voxels, of at most {:g}", file,
                            number, kFarthest);
        }
        places.push_back(p);
    }
    return places;
}

sculpt::Helix parseHelix(const std::string& rest, const std::string& text, const glm::dvec3& steps) {
    const std::string example = "helix:32,32,8:32,32,56:16,2.5";
    const auto parts = split(rest, ':');
    if (parts.size() != 3) {
        throw UsageError("--path {}: needs both ends of its axis and RADIUS,TURNS, as in {}", text, example);
    }
    const auto n = parseNumbers(parts[2], ',', 2, "--path " + text, example);
    const sculpt::Helix helix{steps * parsePlace(parts[0], text, example),
                              steps * parsePlace(parts[1], text, example), n[0], n[1]};
    if (!(n[0] >= 0) || n[0] > 4096 || std::abs(n[1]) > 1000) {
        throw UsageError("--path {}: the radius is 0 to 4096 steps and the turns are at most 1000", text);
    }
    return helix;
}

// Curves are cut into chords everywhere, so theirs must be a length that one could see.
void checkLength(const std::string& text, const std::vector<glm::dvec3>& places) {
    constexpr double kLongest = 1e5; // steps
    double length = 0;
    for (std::size_t n = 1; n < places.size(); ++n) {
        length += glm::length(places[n] - places[n - 1]);
    }
    if (length > kLongest) {
        throw UsageError("--path {}: {:.0f} steps from place to place; a curve is at most {:.0f} long", text,
                         length, kLongest);
    }
}

} // namespace

SweepPath parseSweepPath(const std::string& text, sculpt::FrameKind kind, const glm::dvec3& spacing,
                         const sculpt::PathRegion& region) {
    const auto [form, rest] = partAtColon(text);
    const glm::dvec3 steps = 1.0 / sculpt::voxelFromSteps(spacing); // steps per voxel
    SweepPath path;
    if (form == "at") {
        const std::string example = "at:32,32,32:0,0,1";
        const auto places = parsePlaces(rest, text, example);
        if (places.size() != 2 || glm::length(places[1]) < 1e-9) {
            throw UsageError("--path {}: needs a place and the direction that the mask faces, as in {}", text,
                             example);
        }
        path.standing = sculpt::frameFacing(steps * places[0], places[1]);
        return path;
    }
    if (form == "helix") {
        path.pieces = sculpt::helixPath(parseHelix(rest, text, steps), kind, region);
        if (path.pieces.empty()) {
            throw UsageError("--path {}: a helix of no length; move its ends apart or give it a radius",
                             text);
        }
        return path;
    }
    const bool isRecorded = form == "recorded";
    if (!isRecorded && form != "line" && form != "polyline" && form != "spline") {
        throw UsageError("--path {}: use {}", text, kPathForms);
    }
    const std::string example = form + ":64,64,20:64,64,108";
    auto places = isRecorded ? readPlaces(rest) : parsePlaces(rest, text, example);
    for (glm::dvec3& place : places) {
        place *= steps;
    }
    if (form != "line" && form != "polyline") {
        checkLength(text, places);
    }
    path.pieces = isRecorded         ? sculpt::recordedPath(places, kind, region)
                  : form == "spline" ? sculpt::splinePath(places, kind, region)
                                     : sculpt::polylinePath(places, kind);
    if (path.pieces.empty()) {
        throw UsageError("--path {}: needs at least two different points{}", text,
                         isRecorded ? "" : ", as in " + example);
    }
    return path;
}

} // namespace vs::cli
