// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/fine_labels.h"
#include "studio/operations/sculpting.h"
#include "studio/operations/segment_list.h"
#include "volume/reading/label_map.h"

#include <filesystem>
#include <memory>
#include <variant>

namespace vs::studio {

// The operations on segments: seeding, growing, painting and editing them. A canvas that is not set means the
// document's view at that moment, on a viewport of 1230 x 870.

inline constexpr Rule kGenerations{.least = 0, .most = 1 << 30};
inline constexpr Rule kLineWidth{.least = 0.1, .most = 1000, .unit = "pixels"};
inline constexpr Rule kNewName{.leastCount = 1, .mostCount = 200};
inline constexpr Rule kSegmentName{.leastCount = 1, .mostCount = 200, .isReference = true};
inline constexpr Rule kMillimetres{.least = -1e4, .most = 1e4, .unit = "mm"};

// Puts seeds on the surface under the strokes: free-form and polyline sketches are open lines of the given
// width, the others are filled; and on the voxels in range under trails, as they are drawn on slices. The run
// takes the displayed range as its intensity range when `range` is not set. `voxels` holds what was found;
// when it is not empty on replay, those are used instead of looking again. `finest` holds what was found of
// the finest level of a scan that is worked on at a coarser one; there it comes before `voxels`, which mean
// all of that level in them.
struct Seed {
    static constexpr About kAbout{VS_TEXT("library", "seed"), Effect::Segments,
                                  "seeds on the surface under the strokes, and on the voxels in range under "
                                  "the trails; `voxels`, or `finest` where segments grow at a finer level "
                                  "than the one that is worked on, are used instead of looking again",
                                  "seed"};
    static constexpr std::array<const char*, 4> kNeedsOneOf{"strokes", "trails", "voxels", "finest"};

    std::vector<Sketch> strokes;
    double widthPixels = 5;
    std::optional<Range> range;
    int connectivity = 6;
    std::vector<glm::ivec3> voxels;
    std::optional<Canvas> canvas;
    std::vector<Trail> trails = {};
    std::vector<glm::ivec3> finest = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{written("width", &Seed::widthPixels, kLineWidth, "of strokes that are open lines"),
                          written("connectivity", &Seed::connectivity, kConnectivity),
                          sparse("range", &Seed::range, {}, "of the growth; without: the displayed range"),
                          written("strokes", &Seed::strokes),
                          written("voxels", &Seed::voxels, kVoxel),
                          sparse("canvas", &Seed::canvas, {}, "on what it was drawn"),
                          sparse("trails", &Seed::trails),
                          sparse("finest", &Seed::finest, kFinestVoxel)};
    }
};

// Lets the region grow: so many generations, or until nothing grows any more. The sculpture fences it as
// `sculptureView` says: the view's when not set.
struct Grow {
    static constexpr About kAbout{
        VS_TEXT("library", "grow"), Effect::Segments,
        "grows so many generations, or until nothing grows; the sculpture fences it as the view (or "
        "`sculptureView`) says",
        "play"};

    std::optional<int> generations = {};
    std::optional<field::SculptureView> sculptureView = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("generations", &Grow::generations, kGenerations),
                          sparse("sculptureView", &Grow::sculptureView)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Plays backward by so many generations.
struct Rewind {
    static constexpr About kAbout{VS_TEXT("library", "rewind"), Effect::Segments, "plays backward", "back"};

    int generations = 1;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("generations", &Rewind::generations, kGenerations)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Shows the region up to a generation: scrubbing. Growing goes on from there.
struct ShowGeneration {
    static constexpr About kAbout{
        VS_TEXT("library", "show generation"), Effect::Segments,
        "scrubs: shows the region up to that generation; growing goes on from there", "step"};

    int generation = 0;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("generation", &ShowGeneration::generation, kGenerations)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Changes what the segment at work may grow into, in the volume's unit (gradients per mm). What is not set
// stays; a rule set to nothing is dropped.
struct SetGrowthRules {
    static constexpr About kAbout{
        VS_TEXT("library", "growth rules"), Effect::Segments,
        "changes what the segment at work may grow into: closed ranges of intensity, of its signed "
        "difference "
        "from voxel to voxel (child - parent), of the gradient's magnitude (unit per mm) and of its "
        "difference; `null` drops a rule, what is not given stays. With `live` true, later changes also take "
        "away what they do not reach"};

    std::optional<Range> range = {};
    std::optional<std::optional<Range>> difference = {};         // child - parent
    std::optional<std::optional<Range>> gradient = {};           // magnitude at the child
    std::optional<std::optional<Range>> gradientDifference = {}; // child - parent
    std::optional<int> connectivity = {};                        // 6 or 26
    std::optional<bool> isLive = {}; // from now on new rules also take away what they do not reach

    template <typename = void>
    static constexpr auto fields() {
        constexpr Rule rule{.mayBeNull = true};
        return std::tuple{sparse("range", &SetGrowthRules::range),
                          sparse("difference", &SetGrowthRules::difference, rule),
                          sparse("gradient", &SetGrowthRules::gradient, rule),
                          sparse("gradientDifference", &SetGrowthRules::gradientDifference, rule),
                          sparse("connectivity", &SetGrowthRules::connectivity, kConnectivity),
                          sparse("live", &SetGrowthRules::isLive)};
    }
};

// Targeted shrink: takes away the segment at work from under the strokes outward, by so many expansions or
// until nothing is left. What was taken away does not grow again until it is seeded. `voxels` and `finest` as
// in Seed.
struct Absorb {
    static constexpr About kAbout{
        VS_TEXT("library", "absorb"), Effect::Segments,
        "targeted shrink: takes the segment away from under the strokes outward, so many expansions or all; "
        "that does not grow again until it is seeded"};
    static constexpr std::array<const char*, 3> kNeedsOneOf{"strokes", "voxels", "finest"};

    std::vector<Sketch> strokes;
    double widthPixels = 5;
    std::optional<int> expansions = {};
    std::vector<glm::ivec3> voxels = {};
    std::optional<Canvas> canvas = {};
    std::vector<glm::ivec3> finest = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            written("width", &Absorb::widthPixels, kLineWidth, "of strokes that are open lines"),
            sparse("expansions", &Absorb::expansions, kGenerations),
            written("strokes", &Absorb::strokes),
            written("voxels", &Absorb::voxels, kVoxel),
            sparse("canvas", &Absorb::canvas, {}, "on what it was drawn"),
            sparse("finest", &Absorb::finest, kFinestVoxel)};
    }
};

// Goes to work on the segment of that name, which is made if there is none, and changes what is set: its
// name, its colour (sRGB, 0 to 1), its opacity, whether it is seen, whether it is locked, and what tools do
// with it. With
// `goesToWork` false another one stays at work. A segment that is made takes the place of the first one, and
// its label, while that is still alone, empty and as it was made: `takesFirst` says whether it did. Where it
// is not set, names like `Segment 2` do not, since that is how another one is called.
struct UseSegment {
    static constexpr About kAbout{
        VS_TEXT("library", "segment"), Effect::Segments,
        "goes to work on the segment of that name, which is made if there is none, and changes what is "
        "given; "
        "with `work` false another one stays at work. The first segment is called `Segment 1` until one is "
        "named (below)"};

    std::string segment;
    std::optional<std::string> name = {};
    std::optional<glm::dvec3> colour = {};
    std::optional<double> opacity = {};
    std::optional<bool> isVisible = {};
    std::optional<bool> isLocked = {};
    bool goesToWork = true;
    std::optional<bool> takesFirst = {};
    std::optional<SegmentInfo::Treatment> treatment = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("segment", &UseSegment::segment, kSegmentName),
            sparse("name", &UseSegment::name, kNewName, "a new name"),
            sparse("colour", &UseSegment::colour, {.least = 0, .most = 1}, "sRGB"),
            sparse("opacity", &UseSegment::opacity, {.least = 0.01, .most = 1}),
            sparse("visible", &UseSegment::isVisible),
            sparse("locked", &UseSegment::isLocked),
            sparse("work", &UseSegment::goesToWork, {}, "false: another segment stays at work"),
            sparse("first", &UseSegment::takesFirst, {},
                   "whether it takes the place of the first segment while that is empty and as it was made"),
            sparse(
                "tools", &UseSegment::treatment, {},
                "what tools that cut do with it: take it like all else, spare it (as if it were locked), or "
                "take nothing but it and others of which that is said")};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Makes a segment of each label of a label map that lies on the volume's grid, by the names and colours that
// the file has for them. What is in a segment already stays there; a single segment that is still empty is
// used for the first label, unless it has taken the first one's place by name.
struct LoadLabels {
    static constexpr About kAbout{
        VS_TEXT("library", "load labels"), Effect::Segments,
        "makes a segment of each label of a label map on the volume's grid, or on that of its finest level "
        "where segments grow at that one, with the names and colours of a "
        "3D Slicer segmentation (`.seg.nrrd`), else called `Label 7`; voxels that are in a segment stay "
        "there. The path is absolute or relative to the session file; with a `checksum` another file is "
        "refused, where one is read whole, or in bricks, both times"};

    std::filesystem::path path; // in memory absolute, or relative to the current folder
    std::string checksum = {};  // empty: not checked; filled in when the file is read
    // What was read; when it is set the file is not read again. Not in files.
    std::shared_ptr<const volume::LabelMap> map = {};
    // Its voxels, where they are those of a finer level than the scene's: then the map has none itself.
    std::shared_ptr<const segment::LabelSets> sets = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("path", &LoadLabels::path), sparse("checksum", &LoadLabels::checksum)};
    }
};

// Erases a segment and forgets its name.
struct RemoveSegment {
    static constexpr About kAbout{VS_TEXT("library", "remove segment"), Effect::Segments, "erases it"};

    std::string segment;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("segment", &RemoveSegment::segment, kSegmentName)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Draws a segment once more, elsewhere, without cutting it out: it stays in its place too, and both follow
// all that becomes of it. Said again it is moved there. Without a name all segments that have voxels are
// pulled out there; those that are out already stay where they are.
struct PullOut {
    static constexpr About kAbout{
        VS_TEXT("library", "pull out"), Effect::Segments,
        "draws a segment once more, elsewhere, without cutting it out; said again "
        "it is moved there. It stays "
        "in its place too, and both follow all that becomes of it. Without a name: all "
        "that have voxels and are not out yet",
        "paste"};

    std::optional<std::string> segment;
    render::Placement place;
    bool isVisible = true;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("segment", &PullOut::segment, kSegmentName), spread(&PullOut::place),
                          sparse("visible", &PullOut::isVisible, {},
                                 "false: it is seen in its own place alone for the time being")};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Draws a segment that was pulled out, or all of them, in its own place alone.
struct PutBack {
    static constexpr About kAbout{
        VS_TEXT("library", "put back"), Effect::Segments,
        "a segment that was pulled out is drawn in its own place alone; without a name: "
        "all of them",
        "move"};

    std::optional<std::string> segment;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("segment", &PutBack::segment, kSegmentName)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// One edit of a finished segment: of the one at work. Afterwards only new seeds grow.
struct EditSegment {
    static constexpr About kAbout{VS_TEXT("library", "edit segment"), Effect::Segments,
                                  "edits the segment at work (below); afterwards only new seeds grow"};
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
    static constexpr std::array<const char*, 13> kKinds{
        VS_TEXT("library", "keep island"),  VS_TEXT("library", "drop island"),
        VS_TEXT("library", "keep largest"), VS_TEXT("library", "drop small"),
        VS_TEXT("library", "fill holes"),   VS_TEXT("library", "margin"),
        VS_TEXT("library", "open"),         VS_TEXT("library", "close"),
        VS_TEXT("library", "smooth"),       VS_TEXT("library", "hollow"),
        VS_TEXT("library", "unite"),        VS_TEXT("library", "subtract"),
        VS_TEXT("library", "intersect")};

    Kind kind = Kind::KeepLargest;
    double amount = 0;
    std::string other = {};
    std::optional<glm::dvec2> pixel = {};
    std::optional<glm::ivec3> voxel = {};  // what was found under the pixel
    std::optional<glm::ivec3> finest = {}; // of the finest level, where segments are of that one
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("edit", &EditSegment::kind),
            written("amount", &EditSegment::amount, {.least = -1e4, .most = 1e4, .unit = "mm or ml"}),
            sparse("other", &EditSegment::other, kSegmentName, "another segment"),
            sparse("pixel", &EditSegment::pixel, {.unit = "pixels"}),
            sparse("voxel", &EditSegment::voxel, kVoxel, "used instead of looking again"),
            sparse("finest", &EditSegment::finest, kFinestVoxel),
            sparse("canvas", &EditSegment::canvas, {}, "on what it was drawn")};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};
constexpr const auto& namesOf(EditSegment::Kind) { return EditSegment::kKinds; }

// Adds to the segment at work, or removes from it, what a stroke of a sculpting tool would have cut. Adds
// only voxels in the displayed range.
struct BrushSegment {
    static constexpr About kAbout{
        VS_TEXT("library", "brush segment"), Effect::Segments,
        "adds to the segment at work (only what is in the displayed range), or removes from it, what a "
        "`stroke` (a whole `peel`, `drill`, `laser` or `scissors`) would have cut"};

    bool isToAdd = false;
    std::variant<Peel, Drill, Laser, Scissors> stroke;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("adds", &BrushSegment::isToAdd),
                          required("stroke", &BrushSegment::stroke)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Adds what lies under a trail to the segment at work, or removes it. With a range only voxels whose values
// lie in it are added or removed. Afterwards only new seeds grow.
struct PaintSegment {
    static constexpr About kAbout{
        VS_TEXT("library", "paint segment"), Effect::Segments,
        "adds to the segment at work, or removes from it, what lies under the trail; with a `range` only "
        "voxels in it"};

    bool isToAdd = true;
    Trail trail;
    std::optional<Range> range = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("adds", &PaintSegment::isToAdd), required("trail", &PaintSegment::trail),
                          sparse("range", &PaintSegment::range)};
    }
};

// Cuts away the segment at work, or all but it, with a margin in mm around it.
struct CutSegment {
    static constexpr About kAbout{VS_TEXT("library", "cut segment"), Effect::Cuts,
                                  "cuts the segment at work away, or all but it, with a margin", "cut"};

    bool keeps = false;
    double marginMm = 0;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{written("keeps", &CutSegment::keeps),
                          written("margin", &CutSegment::marginMm, kMillimetres)};
    }
    [[nodiscard]] bool isTrim() const { return keeps; }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Shows one segment and hides all others, or shows all of them.
struct ShowSegments {
    static constexpr About kAbout{VS_TEXT("library", "show segments"), Effect::Segments,
                                  "shows one segment and hides all others, or without a name shows all"};

    std::optional<std::string> only = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("only", &ShowSegments::only, kSegmentName)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Clears all segments that are not locked.
struct ReSeed {
    static constexpr About kAbout{VS_TEXT("library", "re-seed"), Effect::Segments,
                                  "empties all segments that are not locked", "reseed"};
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{};
    }
};

using SegmentingOperations =
    std::variant<Seed, Grow, Rewind, ShowGeneration, SetGrowthRules, Absorb, UseSegment, LoadLabels,
                 RemoveSegment, ShowSegments, PullOut, PutBack, EditSegment, BrushSegment, PaintSegment,
                 CutSegment, ReSeed>;

} // namespace vs::studio
