// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/marks/background.h"
#include "studio/operations/drawing.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

// A moment of a shot through key frames: what is given holds then. Cameras, displayed ranges, places of
// parts, how far they are spread, and generations go evenly from key to key; what cannot, changes at the key.
struct FilmKey {
    static constexpr const char* kName = "film key";

    double seconds = 0;
    int wholeTurns = 0;                 // of azimuth, beside the shorter way from the key before
    std::optional<int> generation = {}; // of the segment at work
    SetView view = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("at", &FilmKey::seconds, {.least = 0, .most = 3600, .unit = "s"},
                     "from the shot's beginning"),
            sparse("turns", &FilmKey::wholeTurns, {.least = -100, .most = 100},
                   "whole turns about the patient's axis, beside the shorter way from the key before"),
            sparse("generation", &FilmKey::generation, {.least = 0, .most = 1 << 30},
                   "of the segment at work"),
            spread(&FilmKey::view)};
    }
};

// A stretch of a film. Each begins with the document as it is.
struct Shot {
    static constexpr const char* kName = "shot";
    enum class Kind { Still, Growth, Session, Keys };
    static constexpr std::array<const char*, 4> kKinds{"still", "growth", "session", "keys"};
    enum class Orbit { None, Turntable, Rock, Tilt, Spiral, Approach };
    static constexpr std::array<const char*, 6> kOrbits{"none", "turntable", "rock",
                                                        "tilt", "spiral",    "approach"};

    Kind kind = Kind::Still;
    double seconds = 8;
    Orbit orbit = Orbit::None;
    double amount = 360; // degrees; of Approach a factor
    bool isBackward = false;
    std::vector<FilmKey> keys = {};

    template <typename = void>
    static constexpr auto fields() {
        constexpr auto isOf = [](Kind wanted) {
            return [wanted](const Shot& shot) { return shot.kind == wanted; };
        };
        return std::tuple{
            required("shot", &Shot::kind, {},
                     "the view as it is, the segment at work as it grew, everything that was done with its "
                     "strokes, or a way through key frames")
                .deciding(),
            written("seconds", &Shot::seconds, {.least = 0.04, .most = 3600, .unit = "s"}),
            sparse("orbit", &Shot::orbit, {},
                   "mixed in: around the patient's axis, to and fro, over the head, around and up, nearer"),
            sparse("amount", &Shot::amount, {.least = -36000, .most = 36000},
                   "degrees of the orbit; of `approach` the factor by which it comes nearer"),
            sparse("backward", &Shot::isBackward, {}, "growth goes back to its seeds")
                .when(isOf(Kind::Growth)),
            required("keys", &Shot::keys, {.leastCount = 1, .mostCount = 1000}).when(isOf(Kind::Keys))};
    }
    [[nodiscard]] Fault faultOf() const;
};
constexpr const auto& namesOf(Shot::Kind) { return Shot::kKinds; }
constexpr const auto& namesOf(Shot::Orbit) { return Shot::kOrbits; }

inline constexpr int kMostFrames = 100000;

// Writes a film into the output folder: WebM (VP9), MP4 (H.264), or a folder of numbered PNGs, as the file's
// name ends. Does not change the document.
struct SaveMovie {
    static constexpr About kAbout{VS_TEXT("library", "movie"), Effect::Writes,
                                  "writes a film of shots that follow one another: WebM if the name ends in "
                                  "`.webm`, MP4 in `.mp4`, else "
                                  "a folder of numbered PNGs"};

    std::string file;
    glm::ivec2 size{1280, 720};
    double framesPerSecond = 25;
    int samples = 4;
    render::Background background = {};
    bool annotations = false;
    std::vector<Shot> shots = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("file", &SaveMovie::file, Rule{.isOutputFile = true}),
            written("size", &SaveMovie::size, {.least = 16, .most = 8192, .unit = "pixels"}),
            written("rate", &SaveMovie::framesPerSecond, {.least = 1, .most = 240}, "frames a second"),
            written("samples", &SaveMovie::samples, {.least = 1, .most = 256}, "a pixel"),
            written("background", &SaveMovie::background),
            written("annotations", &SaveMovie::annotations),
            required("shots", &SaveMovie::shots, {.leastCount = 1, .mostCount = 100})};
    }
    [[nodiscard]] Fault faultOf() const;
};

using FilmingOperations = std::variant<SaveMovie>;

} // namespace vs::studio
