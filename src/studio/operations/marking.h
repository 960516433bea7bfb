// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/drawing.h"
#include "studio/operations/housekeeping.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

inline constexpr double kMostMarkMm = 1000;
inline constexpr double kMostMarkDepthMm = 50;

// Lays a colour on the surface seen under a sketch, into the material: it stays on that whatever is done with
// the view, the displayed range or the scan. A canvas that is not set means the document's view at that
// moment, on a viewport of 1230 x 870.
struct Mark {
    static constexpr About kAbout{VS_TEXT("library", "mark"), Effect::Marks,
                                  "lays a colour on the surface under the sketch, on the material itself: a "
                                  "line, an area, an arrow or letters; or takes colours away",
                                  "mark"};
    enum class Kind { Line, Area, Arrow, Text };
    static constexpr std::array<const char*, 4> kKinds{"line", "area", "arrow", "text"};
    enum class Pressure { Width, Opacity, Nothing };
    static constexpr std::array<const char*, 3> kPressures{"width", "opacity", "nothing"};

    Kind kind = Kind::Line;
    Sketch sketch;
    std::vector<double> pressures = {}; // one for each point of a line, or none: full pressure
    Pressure pressureSets = Pressure::Width;
    glm::dvec3 colour{0.24, 0.11, 0.56}; // sRGB: gentian violet
    double opacity = 1;
    double widthMm = 2;
    double softMm = 0;
    double dashMm = 0;
    std::optional<double> depthMm = {};
    std::string text = {};
    double sizeMm = 12;
    bool erases = false;
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        constexpr auto isLine = [](const Mark& mark) { return mark.kind == Kind::Line; };
        constexpr auto isDrawn = [](const Mark& mark) { return mark.kind != Kind::Area; };
        constexpr auto isDashed = [](const Mark& mark) {
            return mark.kind == Kind::Line || mark.kind == Kind::Arrow;
        };
        constexpr auto isText = [](const Mark& mark) { return mark.kind == Kind::Text; };
        constexpr Rule mm{.least = 0, .most = kMostMarkMm, .unit = "mm"};
        return std::tuple{
            required("kind", &Mark::kind).deciding(),
            required("sketch", &Mark::sketch, {},
                     "of a line and an arrow what the pen drew, of an area its outline; letters stand about "
                     "the middle of its box, upright in the picture"),
            sparse("pressures", &Mark::pressures, {.least = 0, .most = 1},
                   "one for each point of the sketch; without: full pressure")
                .onlyWhen(isLine),
            sparse("pressureSets", &Mark::pressureSets, {}, "what less pressure makes less of")
                .onlyWhen(isLine),
            written("colour", &Mark::colour, {.least = 0, .most = 1}, "sRGB"),
            written("opacity", &Mark::opacity, {.least = 0, .most = 1}),
            written("width", &Mark::widthMm, {.least = 0.01, .most = kMostMarkMm, .unit = "mm"},
                    "of lines, on the surface")
                .onlyWhen(isDrawn),
            sparse("soft", &Mark::softMm, mm, "over which the rim grows from nothing to the mark's opacity"),
            sparse("dash", &Mark::dashMm, mm,
                   "length of dashes and of the gaps between them; 0, or less than half a step: none")
                .onlyWhen(isDashed),
            sparse("depth", &Mark::depthMm, {.least = 0, .most = kMostMarkDepthMm, .unit = "mm"},
                   "how far from the surface into the material, and out of it; without: two steps"),
            required("text", &Mark::text, {.leastCount = 1, .mostCount = 400},
                     "letters are written as capitals")
                .when(isText),
            written("size", &Mark::sizeMm, {.least = 0.1, .most = kMostMarkMm, .unit = "mm"},
                    "height of a capital")
                .onlyWhen(isText),
            sparse("erase", &Mark::erases, {}, "takes marks away instead"),
            sparse("canvas", &Mark::canvas, {}, "on what it was drawn")};
    }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;
};
constexpr const auto& namesOf(Mark::Kind) { return Mark::kKinds; }
constexpr const auto& namesOf(Mark::Pressure) { return Mark::kPressures; }

// Takes all marks away.
struct RemoveMarks {
    static constexpr About kAbout{VS_TEXT("library", "remove marks"), Effect::Marks,
                                  "takes all colours away that `mark` has laid", "mark"};
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple<>{};
    }
};

// Writes the marks as a volume of colours.
struct SaveMarks {
    static constexpr About kAbout{
        VS_TEXT("library", "marks"), Effect::Writes,
        "writes the marks as NRRD, a colour with opacity for each voxel of the scan", "save"};

    std::string file;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SaveMarks::file, kOutputFile)};
    }
};

using MarkingOperations = std::variant<Mark, RemoveMarks, SaveMarks>;

} // namespace vs::studio
