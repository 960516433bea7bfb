// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/phrase.h"
#include "field/scene.h"
#include "render/camera/placement.h"
#include "render/colours/transfer_function.h"
#include "render/rays/ray_caster.h"
#include "studio/operations/description.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vs::studio {

// A segment that is pulled out, while it is moved: it is seen there, and not where the list of segments says.
struct HeldSegment {
    std::uint8_t label = 0;
    render::Placement place;

    bool operator==(const HeldSegment&) const = default;
};

// How the document is looked at. Not an edit, but edits are drawn on a view, so sessions keep it.
struct View {
    render::Camera camera;
    render::Mode mode = render::Mode::Surface;
    Range range; // displayed range, in the volume's unit
    field::SculptureView sculptureView = field::SculptureView::Cut;
    // Colours every mode; nothing: ivory surfaces and white rays, and in volume mode one made from the
    // displayed range.
    std::optional<render::TransferFunction> transferFunction = {};
    // Where copies of what was cut out are drawn too. They can be looked at; pens go through them.
    std::vector<render::Placement> pasted = {};
    field::Sampling sampling = field::Sampling::Trilinear;
    bool shadows = false; // ambient occlusion and soft shadows
    // In MIP, X-ray and overlay: values above the displayed range are hidden instead of counting as its end.
    bool hidesAbove = false;
    // The Gaussian that the values are smoothed by before surfaces are looked for: sigma in steps, 0 for
    // none. In surface and segment mode, for pictures and picking; what cut faces show stays as it is.
    double surfaceSmoothing = 0;
    bool tintsSegments = false; // in MIP and X-ray: what is in a visible segment has its colour
    // The values that slices show from black to white; nothing: those that suit the scan.
    std::optional<Range> sliceWindow = {};
    bool tintsSlices = false;    // slices show in colour what the 3D picture shows
    bool isInverted = false;     // MIP and X-ray are dark on light; colours stay what they are
    bool smoothsSegments = true; // false: segments are drawn voxel by voxel, as they grow
    // An exploded view: pasted parts and segments that are pulled out lie 1 + spread times as far from the
    // scan's middle as they were put.
    double spread = 0;
    std::optional<HeldSegment> held = {}; // in the hand at the moment; not in files

    // Values above the displayed range are visible too: in MIP, X-ray and overlay, unless they are hidden.
    [[nodiscard]] bool showsAbove() const;
    // What of a volume's values, which go from data.lo to data.hi, is visible: the displayed range, up to the
    // greatest value where those above it are visible too. Seeds, tools and growth go by it.
    [[nodiscard]] Range visibleRange(const Range& data) const;

    // Whether two views differ in how slices are shown and in nothing else: the 3D picture is the same.
    [[nodiscard]] bool differsInSlicesOnly(const View& other) const;

    bool operator==(const View&) const = default;
};

inline constexpr double kMostSurfaceSmoothing = 2; // steps
inline constexpr Rule kSurfaceSmoothing{.least = 0, .most = kMostSurfaceSmoothing, .unit = "steps"};
inline constexpr double kMostSpread = 3;
inline constexpr Rule kSpread{.least = 0, .most = kMostSpread};
inline constexpr Rule kPlacements{.mostCount = 16};

// Looks from elsewhere, at another range, in another mode. What is not set stays.
struct SetView {
    static constexpr About kAbout{VS_TEXT("library", "view"), Effect::ChangesView,
                                  "looks from elsewhere; what is not given stays"};

    std::optional<render::Camera> camera;
    std::optional<render::Mode> mode;
    std::optional<Range> range;
    std::optional<field::SculptureView> sculptureView;
    // Set to nothing: without one.
    std::optional<std::optional<render::TransferFunction>> transferFunction = {};
    std::optional<std::vector<render::Placement>> pasted = {};
    std::optional<field::Sampling> sampling = {};
    std::optional<bool> shadows = {};
    std::optional<bool> hidesAbove = {};
    std::optional<double> surfaceSmoothing = {};
    std::optional<bool> tintsSegments = {};
    // Set to nothing: the window that suits the scan.
    std::optional<std::optional<Range>> sliceWindow = {};
    std::optional<bool> tintsSlices = {};
    std::optional<bool> isInverted = {};
    std::optional<bool> smoothsSegments = {};
    std::optional<double> spread = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            sparse("camera", &SetView::camera),
            sparse("mode", &SetView::mode),
            sparse("range", &SetView::range),
            sparse("sculptureView", &SetView::sculptureView),
            sparse("transferFunction", &SetView::transferFunction, {.mayBeNull = true}),
            sparse("pasted", &SetView::pasted, kPlacements),
            sparse("sampling", &SetView::sampling),
            sparse("shadows", &SetView::shadows),
            sparse("hideAbove", &SetView::hidesAbove),
            sparse("smoothSurface", &SetView::surfaceSmoothing, kSurfaceSmoothing),
            sparse("tintSegments", &SetView::tintsSegments),
            sparse("sliceWindow", &SetView::sliceWindow, {.mayBeNull = true}),
            sparse("tintSlices", &SetView::tintsSlices),
            sparse("invert", &SetView::isInverted),
            sparse("smoothSegments", &SetView::smoothsSegments, {},
                   "false: segments are drawn voxel by voxel"),
            sparse("spread", &SetView::spread, kSpread,
                   "pasted parts and segments that are pulled out lie 1 + `spread` times as far "
                   "from the scan's middle as they were put")};
    }
};
// The whole of a view.
SetView setViewTo(const View& view);
// A view as that operation makes it of another.
View changed(View view, const SetView& by);

} // namespace vs::studio
