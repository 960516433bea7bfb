// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "render/colours/transfer_function.h"
#include "render/marks/background.h"
#include "render/rays/ray_caster.h"
#include "sculpt/radiation/sweep.h"
#include "sculpt/surface/stroke.h"
#include "volume/io/label_map.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

inline constexpr double kMostSurfaceSmoothing = 2; // steps

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

    // Values above the displayed range are visible too: in MIP, X-ray and overlay, unless they are hidden.
    [[nodiscard]] bool showsAbove() const;
    // What of a volume's values, which go from data.lo to data.hi, is visible: the displayed range, up to the
    // greatest value where those above it are visible too. Seeds, tools and growth go by it.
    [[nodiscard]] Range visibleRange(const Range& data) const;

    bool operator==(const View&) const = default;
};

enum class Shape { FreeForm, Ellipse, Circle, Rectangle, Polyline, Stencil };

// What the pen drew, in viewport pixels (y down): for FreeForm and Polyline the points themselves, for
// Ellipse, Circle and Rectangle two opposite corners of the box around it (for Circle the first point is the
// centre, the second on the rim), for Stencil the outline of what a picture shows, always closed.
struct Sketch {
    Shape shape = Shape::FreeForm;
    std::vector<glm::dvec2> points;

    bool operator==(const Sketch&) const = default;
};

// On what an edit was drawn.
struct Canvas {
    View view;
    glm::ivec2 viewport{1230, 870}; // pixels

    bool operator==(const Canvas&) const = default;
};

// The operations: one document change each, as values. The window, the command line and a replayed session
// all make these, and nothing else changes a document. A canvas that is not set means the document's view at
// that moment, on a viewport of 1230 x 870.

// Looks from elsewhere, at another range, in another mode. What is not set stays.
struct SetView {
    std::optional<render::Camera> camera;
    std::optional<render::Mode> mode;
    std::optional<Range> range;
    std::optional<field::SculptureView> sculptureView;
    std::optional<std::optional<render::TransferFunction>> transferFunction =
        {}; // set to nothing: without one
    std::optional<std::vector<render::Placement>> pasted = {};
    std::optional<field::Sampling> sampling = {};
    std::optional<bool> shadows = {};
    std::optional<bool> hidesAbove = {};
    std::optional<double> surfaceSmoothing = {};
    std::optional<bool> tintsSegments = {};
};
// The whole of a view.
SetView lookAs(const View& view);

// Peels layers (steps, fractions count) off the surface under the sketch, each element along its own normal.
struct Peel {
    Sketch mask;
    double layers = 0;
    int radius = 3; // steps: the radiation's R
    bool restores =
        false; // the sign reversed: puts layers of what was cut back on, never past the uncut surface
    std::optional<Canvas> canvas;
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
};

// Drills along the view's ray through the mask's centre, or along the pen's tilt.
struct Drill : PenCut {
    bool followsTilt = false;
};

// Burns down from the surface along its own normal: the mask lies on the surface, turned to its normal.
struct Laser : PenCut {
    Laser() { depthMax = 20; }
};

// Cuts through the whole volume along the view's rays: all that is seen inside the closed stroke, or outside
// it. With a depth (steps), only so deep below the surface seen.
struct Scissors {
    Sketch outline;
    bool cutsOutside = false;
    std::optional<double> depth = {};
    int radius = 3;
    bool restores = false;
    std::optional<Canvas> canvas = {};
};

// Where a sweep goes. Drawn paths are in viewport pixels, on the surface seen or in the plane across the view
// through the surface at its beginning; all others are in voxel space.
struct SweepPath {
    enum class Kind { Surface, ViewPlane, Polyline, Spline, Helix, Standing };
    Kind kind = Kind::Polyline;
    std::vector<glm::dvec2> stroke; // Surface, ViewPlane
    // Polyline, Spline: the corners. Helix: the ends of its axis. Standing: where the mask stands, and a
    // point that it faces.
    std::vector<glm::dvec3> points;
    double helixRadius = 0; // steps
    double turns = 1;

    [[nodiscard]] bool isDrawn() const { return kind == Kind::Surface || kind == Kind::ViewPlane; }
};

// Sweeps a mask along a path and cuts what it covers. For drawn paths the mask is a sketch in viewport
// pixels, carried along by its centre; for others it is in steps, the path running through (0, 0).
struct Sweep {
    enum class Method { Radiation, Projection };
    Sketch mask;
    SweepPath path;
    sculpt::FrameKind frame = sculpt::FrameKind::ParallelTransport;
    sculpt::MaskFilter filter = {};
    sculpt::Subdivision subdivision = sculpt::Subdivision::CubicBSpline; // of the outline, so many times
    int subdivisionLevels = 0;
    double pitch = sculpt::kSweepPitch; // steps between the mask's elements
    int radius = 3;
    bool isRaw = false; // the thesis' uncalibrated energy
    Method method = Method::Radiation;
    bool restores = false;
    std::optional<Canvas> canvas = {};
};

// Cuts what lies outside a box, or inside it, in voxel space; and what lies beyond each of a list of planes
// (on the side that the normal points to), in the patient's millimetres.
struct Clip {
    struct Box {
        glm::dvec3 lo{0};
        glm::dvec3 hi{0};
    };
    struct Plane {
        glm::dvec3 point{0};
        glm::dvec3 normal{0, 0, 1};
    };
    std::optional<Box> box;
    std::vector<Plane> planes;
    bool cutsInside = false; // what lies in the box and behind all planes, instead of the rest
    int radius = 3;
    bool restores = false;
};

// Cuts everything visible that is not connected to what is under a pixel: the table below a patient. `voxel`
// is what was found there; when set it is used instead of casting a ray again.
struct KeepConnected {
    glm::dvec2 pixel{0};
    std::optional<glm::ivec3> voxel = {};
    int connectivity = 26;
    std::optional<Canvas> canvas = {};
};

// Pastes what was cut since the last paste as a part of its own at a place. Until the next paste it takes in
// what is cut further.
struct Paste {
    render::Placement place;
};

// Moves, turns and scales a pasted part (counted from 0).
struct MovePart {
    int part = 0;
    render::Placement place;
};

// Where a round brush has gone in the volume: the voxels whose centres lie within the radius of its way, a
// line through points in voxel space, and those that the way itself runs through, so that a thin brush leaves
// no gaps. With an axis (0 to 2) the brush is a disc across that voxel axis, on the slice that its first
// point lies in; without, a ball.
struct Trail {
    std::vector<glm::dvec3> points;
    double radiusMm = 0;
    std::optional<int> axis = {};

    bool operator==(const Trail&) const = default;
};

// Puts seeds on the surface under the strokes: free-form and polyline sketches are open lines of the given
// width, the others are filled; and on the voxels in range under trails, as they are drawn on slices. The run
// takes the displayed range as its intensity range when `range` is not set. `voxels` holds what was found;
// when it is not empty on replay, those are used instead of looking again.
struct Seed {
    std::vector<Sketch> strokes;
    double widthPixels = 5;
    std::optional<Range> range;
    int connectivity = 6;
    std::vector<glm::ivec3> voxels;
    std::optional<Canvas> canvas;
    std::vector<Trail> trails = {};
};

// Lets the region grow: so many generations, or until nothing grows any more. The sculpture fences it as
// `sculptureView` says: the view's when not set.
struct Grow {
    std::optional<int> generations = {};
    std::optional<field::SculptureView> sculptureView = {};
};

// Plays backward by so many generations.
struct Rewind {
    int generations = 1;
};

// Shows the region up to a generation: scrubbing. Growing goes on from there.
struct ShowGeneration {
    int generation = 0;
};

// Changes what the segment at work may grow into, in the volume's unit (gradients per mm). What is not set
// stays; a rule set to nothing is dropped.
struct SetGrowthRules {
    std::optional<Range> range = {};
    std::optional<std::optional<Range>> difference = {};         // child - parent
    std::optional<std::optional<Range>> gradient = {};           // magnitude at the child
    std::optional<std::optional<Range>> gradientDifference = {}; // child - parent
    std::optional<int> connectivity = {};                        // 6 or 26
    std::optional<bool> isLive = {}; // from now on new rules also take away what they do not reach
};

// Targeted shrink: takes away the segment at work from under the strokes outward, by so many expansions or
// until nothing is left. What was taken away does not grow again until it is seeded. `voxels` as in Seed.
struct Absorb {
    std::vector<Sketch> strokes;
    double widthPixels = 5;
    std::optional<int> expansions = {};
    std::vector<glm::ivec3> voxels = {};
    std::optional<Canvas> canvas = {};
};

// Goes to work on the segment of that name, which is made if there is none, and changes what is set: its
// name, its colour (sRGB, 0 to 1), its opacity, whether it is seen, and whether it is locked. With
// `goesToWork` false another one stays at work. A segment that is made takes the place of the first one, and
// its label, while that is still alone, empty and as it was made: `takesFirst` says whether it did. Where it
// is not set, names like `Segment 2` do not, since that is how another one is called.
struct UseSegment {
    std::string segment;
    std::optional<std::string> name = {};
    std::optional<glm::dvec3> colour = {};
    std::optional<double> opacity = {};
    std::optional<bool> isVisible = {};
    std::optional<bool> isLocked = {};
    bool goesToWork = true;
    std::optional<bool> takesFirst = {};
};

// Makes a segment of each label of a label map that lies on the volume's grid, by the names and colours that
// the file has for them. What is in a segment already stays there; a single segment that is still empty is
// used for the first label, unless it has taken the first one's place by name.
struct LoadLabels {
    std::filesystem::path path; // in memory absolute, or relative to the current folder
    std::string checksum = {};  // empty: not checked; filled in when the file is read
    // What was read; when it is set the file is not read again.
    std::shared_ptr<const volume::LabelMap> map = {};
};

// Erases a segment and forgets its name.
struct RemoveSegment {
    std::string segment;
};

// One edit of a finished segment: of the one at work. Afterwards only new seeds grow.
struct EditSegment {
    enum class Kind {
        KeepIsland, // under a pixel, or at `voxel`
        DropIsland,
        KeepLargest,
        DropSmall, // islands below `amount` ml
        FillHoles, // up to `amount` ml; 0: all
        Margin,    // grows (or shrinks, below zero) by `amount` mm
        Open,      // shrinks and grows by `amount` mm: cuts thin bridges and spikes
        Close,     // grows and shrinks by `amount` mm: closes gaps
        Smooth,    // over `amount` mm
        Hollow,    // leaves a wall of `amount` mm inside the surface
        Unite,     // takes in all of `other`, which is left empty
        Subtract,  // what lies within `amount` mm of `other`
        Intersect, // keeps only that
    };
    Kind kind = Kind::KeepLargest;
    double amount = 0;
    std::string other = {};
    std::optional<glm::dvec2> pixel = {};
    std::optional<glm::ivec3> voxel = {}; // what was found under the pixel
    std::optional<Canvas> canvas = {};
};

// Adds to the segment at work, or removes from it, what a stroke of a sculpting tool would have cut. Adds
// only voxels in the displayed range.
struct BrushSegment {
    bool isToAdd = false;
    std::variant<Peel, Drill, Laser, Scissors> stroke;
};

// Adds what lies under a trail to the segment at work, or removes it. With a range only voxels whose values
// lie in it are added or removed. Afterwards only new seeds grow.
struct PaintSegment {
    bool isToAdd = true;
    Trail trail;
    std::optional<Range> range = {};
};

// Cuts away the segment at work, or all but it, with a margin in mm around it.
struct CutSegment {
    bool keeps = false;
    double marginMm = 0;
};

struct Undo {};
struct Redo {};
struct UnCut {};  // clears all cuts
struct ReSeed {}; // clears all segments that are not locked

// Writes the view as a PNG into the output folder, with a scale bar and an orientation marker if asked for.
// Does not change the document.
struct SavePicture {
    std::string file;
    glm::ivec2 size{1230, 870};
    int samples = 8;
    render::Background background = {};
    bool annotations = false;
};

// Writes the segments as a label map (uint8, numbered in the order they were made, 0 = none) into the output
// folder.
struct SaveLabels {
    std::string file;
};

// Writes the sculpture volume (float, 0 untouched .. 1 cut away) into the output folder.
struct SaveSculpture {
    std::string file;
};

using Operation = std::variant<SetView, Peel, Drill, Laser, Sweep, Scissors, Clip, KeepConnected, Paste,
                               MovePart, Seed, Grow, Rewind, ShowGeneration, SetGrowthRules, Absorb,
                               UseSegment, LoadLabels, RemoveSegment, EditSegment, BrushSegment, PaintSegment,
                               CutSegment, Undo, Redo, UnCut, ReSeed, SavePicture, SaveLabels, SaveSculpture>;

// The name in sessions, reports and the history: "view", "peel", ... (kOperationNames).
const char* name(const Operation& operation);

// Whether an operation is a stroke or another cut of the sculpture (or restores some of it).
bool cuts(const Operation& operation);

// Whether an operation changes the document; looking and writing files do not.
bool isEdit(const Operation& operation);

// Whether an operation only writes a file and leaves the document as it is.
bool isOutput(const Operation& operation);

} // namespace vs::studio
