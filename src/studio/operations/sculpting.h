// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/surface/stroke.h"
#include "studio/operations/drawing.h"

#include <variant>

namespace vs::studio {

// The operations that cut the sculpture, restore it, or place what was cut out. A canvas that is not set
// means the document's view at that moment, on a viewport of 1230 x 870.

inline constexpr double kMostSteps = 4096; // of a depth
inline constexpr double kFarthest = 1e5;   // voxels or millimetres
inline constexpr std::array<int, 2> kNeighbours{6, 26};

inline constexpr Rule kDepth{.least = 0, .most = kMostSteps, .unit = "steps"};
inline constexpr Rule kRadius{.least = 2, .most = 4, .unit = "steps"};
inline constexpr Rule kConnectivity{.least = 6, .most = 26, .among = kNeighbours};
inline constexpr Rule kPlaceInVoxels{.least = -kFarthest, .most = kFarthest, .unit = "voxels"};
inline constexpr Rule kPlaceInMm{.least = -kFarthest, .most = kFarthest, .unit = "mm"};
inline constexpr Rule kPart{.least = 0, .most = 15};
inline constexpr Rule kPartName{.leastCount = 1, .mostCount = 200};
inline constexpr const char* kTakesTrimmed = "also what `keep connected`, `clip` and `cut segment` took away";

// The fields that most cuts end with.
template <typename Cut>
constexpr auto radiusAndRestore() {
    return std::tuple{written("radius", &Cut::radius, kRadius, "of the radiation, R"),
                      sparse("restore", &Cut::restores, {}, "puts back instead of cutting")};
}
template <typename Cut>
constexpr auto canvasOf() {
    return std::tuple{sparse("canvas", &Cut::canvas, {}, "on what it was drawn")};
}

// Peels layers (steps, fractions count) off the surface under the sketch, each element along its own normal.
struct Peel {
    static constexpr About kAbout{VS_TEXT("library", "peel"), Effect::Cuts,
                                  "takes layers off the surface under the mask, along its normals", "peel"};

    Sketch mask;
    double layers = 0;
    int radius = 3; // steps: the radiation's R
    // The sign reversed: puts layers of what was cut back on, never past the uncut surface.
    bool restores = false;
    std::optional<Canvas> canvas;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(
            std::tuple{required("layers", &Peel::layers, kDepth), required("mask", &Peel::mask)},
            radiusAndRestore<Peel>(), canvasOf<Peel>());
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// What the tools that follow the pen have in common: the sketch's shape is carried along, each pen point
// stamps it, centred on the point, as deep as depthMax * pressure (steps). Without pen points, one stamp
// where the mask was drawn, at full pressure. Surfaces are those seen at pen-down, and seen again where
// pressure rises after having been zero; with keepsDigging at every change of place or pressure, so that the
// pen works its way in.
struct PenCut {
    Sketch mask;
    sculpt::Stroke stroke;
    double depthMax = 10;
    int radius = 3;
    bool restores = false; // as of a Peel
    bool keepsDigging = false;
    std::optional<Canvas> canvas;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(
            std::tuple{written("depthMax", &PenCut::depthMax, kDepth, "at full pressure"),
                       required("mask", &PenCut::mask),
                       written("stroke", &PenCut::stroke, {},
                               "`[x, y, pressure]` or `[x, y, pressure, tiltX, tiltY]`, each a place of the "
                               "mask's centre; none: once where the mask was drawn"),
                       sparse("keepDigging", &PenCut::keepsDigging, {},
                              "the surface is looked for again at every change of place or pressure")},
            radiusAndRestore<PenCut>(), canvasOf<PenCut>());
    }
};

// Drills along the view's ray through the mask's centre, or along the pen's tilt.
struct Drill : PenCut {
    static constexpr About kAbout{VS_TEXT("library", "drill"), Effect::Cuts,
                                  "drills along the view, under each place of the pen", "drill"};

    bool followsTilt = false;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(
            std::tuple{sparse("followTilt", &Drill::followsTilt, {}, "drills along the pen's tilt")},
            PenCut::fields());
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Burns down from the surface along its own normal: the mask lies on the surface, turned to its normal.
struct Laser : PenCut {
    static constexpr About kAbout{VS_TEXT("library", "laser"), Effect::Cuts,
                                  "burns down along the surface's normal, from the mask lying on the surface",
                                  "laser"};

    Laser() { depthMax = 20; }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Cuts through the whole volume along the view's rays: all that is seen inside the closed stroke, or outside
// it. With a depth (steps), only so deep below the surface seen.
struct Scissors {
    static constexpr About kAbout{VS_TEXT("library", "scissors"), Effect::Cuts,
                                  "cuts what is seen inside the outline (or outside it), through everything "
                                  "or so deep below the surface",
                                  "scissors"};

    Sketch outline;
    bool cutsOutside = false;
    std::optional<double> depth = {};
    int radius = 3;
    bool restores = false;
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(std::tuple{required("outline", &Scissors::outline),
                                         written("outside", &Scissors::cutsOutside),
                                         sparse("depth", &Scissors::depth, kDepth, "without: through all")},
                              radiusAndRestore<Scissors>(), canvasOf<Scissors>());
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Cuts what lies outside a box, or inside it, in voxel space; and what lies beyond each of a list of planes
// (on the side that the normal points to), in the patient's millimetres.
struct Clip {
    static constexpr About kAbout{VS_TEXT("library", "clip"), Effect::Cuts,
                                  "cuts what lies outside a box (two corners) or beyond one of the planes "
                                  "(`{\"point\", \"normal\"}`); with `inside` what does not",
                                  "clip"};
    static constexpr std::array<const char*, 2> kNeedsOneOf{"box", "planes"};

    struct Box {
        glm::dvec3 lo{0};
        glm::dvec3 hi{0};

        bool operator==(const Box&) const = default;
    };
    struct Plane {
        static constexpr const char* kName = "plane";

        glm::dvec3 point{0};
        glm::dvec3 normal{0, 0, 1};

        template <typename = void>
        static constexpr auto fields() {
            return std::tuple{required("point", &Plane::point, kPlaceInMm),
                              required("normal", &Plane::normal, kPlaceInMm)};
        }
        [[nodiscard]] Fault faultOf() const;

        bool operator==(const Plane&) const = default;
    };
    std::optional<Box> box;
    std::vector<Plane> planes;
    bool cutsInside = false; // what lies in the box and behind all planes, instead of the rest
    int radius = 3;
    bool restores = false;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(std::tuple{sparse("box", &Clip::box, kPlaceInVoxels),
                                         sparse("planes", &Clip::planes, {.mostCount = 24}),
                                         written("inside", &Clip::cutsInside)},
                              radiusAndRestore<Clip>());
    }
    // What lies outside goes; cutting a box out is a cut like others.
    [[nodiscard]] bool isTrim() const { return !restores && !cutsInside; }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Cuts everything visible that is not connected to what is under a pixel: the table below a patient. `voxel`
// is what was found there; when set it is used instead of casting a ray again.
struct KeepConnected {
    static constexpr About kAbout{VS_TEXT("library", "keep connected"), Effect::Cuts,
                                  "cuts everything visible that is not connected to what is under the pixel "
                                  "(the table below a patient)",
                                  "keep"};
    static constexpr std::array<const char*, 3> kNeedsOneOf{"pixel", "voxel", "finest"};

    std::optional<glm::dvec2> pixel = {};
    std::optional<glm::ivec3> voxel = {};
    std::optional<glm::ivec3> finest = {}; // of the finest level, where tools work on that one
    int connectivity = 26;
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(
            std::tuple{sparse("pixel", &KeepConnected::pixel, kPixels),
                       sparse("voxel", &KeepConnected::voxel, kVoxel, "used instead of looking again"),
                       sparse("finest", &KeepConnected::finest, kFinestVoxel),
                       written("connectivity", &KeepConnected::connectivity, kConnectivity)},
            canvasOf<KeepConnected>());
    }
    [[nodiscard]] bool isTrim() const { return true; }
};

// Pastes what tools cut since the last paste as a part of its own at a place. Until the next paste it takes
// in what is cut further. What was trimmed away around it (operations that say isTrim()) stays away, unless
// it is wanted too.
struct Paste {
    static constexpr About kAbout{
        VS_TEXT("library", "paste"), Effect::Parts,
        "what was cut since the last `paste` becomes a part of its own, drawn there; until the next one it "
        "takes in what is cut further. What `keep connected`, `clip` and `cut segment` with `keeps` took "
        "away "
        "around it does not belong to it",
        "paste"};

    render::Placement place;
    std::optional<std::string> name = {};
    bool takesTrimmed = false;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{spread(&Paste::place),
                          sparse("name", &Paste::name, kPartName, "without: `Part 1`, or another number"),
                          sparse("all", &Paste::takesTrimmed, {}, kTakesTrimmed)};
    }
};

// Moves, turns and scales a pasted part (counted from 0).
struct MovePart {
    static constexpr About kAbout{VS_TEXT("library", "move part"), Effect::Parts,
                                  "places pasted part number `part`, counted from 0", "move"};

    int part = 0;
    render::Placement place;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("part", &MovePart::part, kPart), spread(&MovePart::place)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Changes what is set of a pasted part (counted from 0): its name, whether it is seen, and what belongs to
// it.
struct ChangePart {
    static constexpr About kAbout{VS_TEXT("library", "part"), Effect::Parts,
                                  "changes what is given of pasted part number `part`, counted from 0",
                                  "paste"};

    int part = 0;
    std::optional<std::string> name = {};
    std::optional<bool> isVisible = {};
    std::optional<bool> takesTrimmed = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("part", &ChangePart::part, kPart),
                          sparse("name", &ChangePart::name, kPartName),
                          sparse("visible", &ChangePart::isVisible),
                          sparse("all", &ChangePart::takesTrimmed, {}, kTakesTrimmed)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Pasted part number `part` (counted from 0) is drawn no more, and those after it move up. What it was cut
// from stays cut; no later paste takes it.
struct DiscardPart {
    static constexpr About kAbout{
        VS_TEXT("library", "discard part"), Effect::Parts,
        "pasted part number `part`, counted from 0, is gone, and those after it move "
        "up; what was cut stays cut, and no later paste takes it",
        "uncut"};

    int part = 0;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("part", &DiscardPart::part, kPart)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

using SculptingOperations =
    std::variant<Peel, Drill, Laser, Scissors, Clip, KeepConnected, Paste, MovePart, ChangePart, DiscardPart>;

} // namespace vs::studio
