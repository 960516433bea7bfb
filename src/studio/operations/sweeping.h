// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/radiation/sweep.h"
#include "studio/operations/sculpting.h"

namespace vs::studio {

// Where a sweep goes. Drawn paths are in viewport pixels, on the surface seen or in the plane across the view
// through the surface at its beginning; all others are in voxel space.
struct SweepPath {
    enum class Kind { Surface, ViewPlane, Polyline, Spline, Helix, Standing };
    static constexpr const char* kName = "path";
    static constexpr std::array<const char*, 6> kKinds{"surface", "view plane", "polyline",
                                                       "spline",  "helix",      "standing"};

    Kind kind = Kind::Polyline;
    std::vector<glm::dvec2> stroke; // Surface, ViewPlane
    // Polyline, Spline: the corners. Helix: the ends of its axis. Standing: where the mask stands, and a
    // point that it faces.
    std::vector<glm::dvec3> points;
    double helixRadius = 0; // steps
    double turns = 1;

    [[nodiscard]] constexpr bool isDrawn() const { return kind == Kind::Surface || kind == Kind::ViewPlane; }
    [[nodiscard]] constexpr bool isOpen() const { return kind == Kind::Polyline || kind == Kind::Spline; }

    template <typename = void>
    static constexpr auto fields() {
        constexpr auto isDrawn = [](const SweepPath& path) { return path.isDrawn(); };
        constexpr auto isOpen = [](const SweepPath& path) { return path.isOpen(); };
        constexpr auto isOfTwo = [](const SweepPath& path) { return !path.isDrawn() && !path.isOpen(); };
        constexpr auto isHelix = [](const SweepPath& path) { return path.kind == Kind::Helix; };
        return std::tuple{
            required("kind", &SweepPath::kind).deciding(),
            required("stroke", &SweepPath::stroke, kPixels).when(isDrawn),
            required("points", &SweepPath::points,
                     {.least = -kFarthest, .most = kFarthest, .unit = "voxels", .leastCount = 2})
                .when(isOpen),
            required("points", &SweepPath::points,
                     {.least = -kFarthest,
                      .most = kFarthest,
                      .unit = "voxels",
                      .leastCount = 2,
                      .mostCount = 2,
                      .wrongCount = "exactly two places are wanted"},
                     "the ends of the axis; where the mask stands and what it faces")
                .when(isOfTwo),
            required("radius", &SweepPath::helixRadius, kDepth).when(isHelix),
            required("turns", &SweepPath::turns, {.least = -1000, .most = 1000}).when(isHelix)};
    }
    [[nodiscard]] Fault faultOf() const;
};
constexpr const auto& namesOf(SweepPath::Kind) { return SweepPath::kKinds; }

// Sweeps a mask along a path and cuts what it covers. For drawn paths the mask is a sketch in viewport
// pixels, carried along by its centre; for others it is in steps, the path running through (0, 0).
struct Sweep {
    static constexpr About kAbout{VS_TEXT("library", "sweep"), Effect::Cuts,
                                  "cuts what the mask covers on its way along the path", "sweep"};
    enum class Method { Radiation, Projection };
    static constexpr std::array<const char*, 2> kMethods{"radiation", "projection"};
    static constexpr std::array<const char*, 2> kEnergies{"calibrated", "raw"};

    Sketch mask;
    SweepPath path;
    sculpt::FrameKind frame = sculpt::FrameKind::ParallelTransport;
    sculpt::MaskFilter filter = {};
    sculpt::Subdivision subdivision = sculpt::Subdivision::CubicBSpline; // of the outline, so many times
    int subdivisionLevels = 0;
    double pitch = sculpt::kSweepPitch; // steps between the mask's elements
    int radius = 3;
    bool isRaw = false; // uncalibrated energy, as in the thesis, section B.5.3
    Method method = Method::Radiation;
    bool restores = false;
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        using sculpt::MaskFilter;
        constexpr auto of = [](auto member) { return through(&Sweep::filter, member); };
        constexpr auto isSubdivided = [](const Sweep& sweep) { return sweep.subdivisionLevels > 0; };
        const auto filter = std::tuple{
            written("sampling", of(&MaskFilter::sampling)),
            written("reconstruction", of(&MaskFilter::reconstruction)),
            written("width", of(&MaskFilter::width),
                    {.least = 4, .most = 400, .unit = "sub-samples, ten an element"}),
            written("seed", of(&MaskFilter::seed), {.least = 0, .most = 0xFFFFFFFF}),
            written("subdivision", &Sweep::subdivision, {}, "of the outline").when(isSubdivided),
            sparse("levels", &Sweep::subdivisionLevels, {.least = 0, .most = 8}, "of subdivision")};
        return std::tuple_cat(
            std::tuple{required("mask", &Sweep::mask), required("path", &Sweep::path),
                       written("frame", &Sweep::frame), group("filter", filter, "of the mask"),
                       written("pitch", &Sweep::pitch, {.least = 0.05, .most = 64, .unit = "steps"},
                               "from one mask element to the next"),
                       written("energy", &Sweep::isRaw, {.choices = kEnergies}),
                       written("method", &Sweep::method)},
            radiusAndRestore<Sweep>(), canvasOf<Sweep>());
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};
constexpr const auto& namesOf(Sweep::Method) { return Sweep::kMethods; }

using SweepingOperations = std::variant<Sweep>;

} // namespace vs::studio
