// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "field/histogram.h"
#include "studio/document/document.h"
#include "studio/document/pipeline.h"
#include "studio/operations/segment_list.h"
#include "studio/operations/trail.h"
#include "studio/state/history.h"
#include "studio/state/region.h"
#include "studio/strokes/peel_stroke.h"
#include "studio/strokes/pen_stroke.h"
#include "studio/strokes/solid_strokes.h"
#include "studio/strokes/sweep_stroke.h"

#include <optional>

namespace vs::studio {

// What a Document holds, and one function per operation. Private to the document's own files.
struct Document::Impl {
    Impl(volume::Volume v, sculpt::Precision precision);

    // Each carries out one operation, fills in what it found (canvas, seed voxels), and remembers how to undo
    // it. Throws Error before anything has changed. `folder` is where files go.
    Outcome run(SetView& op, const std::filesystem::path& folder);
    Outcome run(Peel& op, const std::filesystem::path& folder);
    Outcome run(Drill& op, const std::filesystem::path& folder);
    Outcome run(Laser& op, const std::filesystem::path& folder);
    Outcome run(Sweep& op, const std::filesystem::path& folder);
    Outcome run(Scissors& op, const std::filesystem::path& folder);
    Outcome run(Clip& op, const std::filesystem::path& folder);
    Outcome run(KeepConnected& op, const std::filesystem::path& folder);
    Outcome run(Paste& op, const std::filesystem::path& folder);
    Outcome run(MovePart& op, const std::filesystem::path& folder);
    Outcome run(Seed& op, const std::filesystem::path& folder);
    Outcome run(Grow& op, const std::filesystem::path& folder);
    Outcome run(Rewind& op, const std::filesystem::path& folder);
    Outcome run(ShowGeneration& op, const std::filesystem::path& folder);
    Outcome run(SetGrowthRules& op, const std::filesystem::path& folder);
    Outcome run(Absorb& op, const std::filesystem::path& folder);
    Outcome run(UseSegment& op, const std::filesystem::path& folder);
    Outcome run(LoadLabels& op, const std::filesystem::path& folder);
    Outcome run(RemoveSegment& op, const std::filesystem::path& folder);
    Outcome run(EditSegment& op, const std::filesystem::path& folder);
    Outcome run(BrushSegment& op, const std::filesystem::path& folder);
    Outcome run(PaintSegment& op, const std::filesystem::path& folder);
    Outcome run(CutSegment& op, const std::filesystem::path& folder);
    Outcome run(Undo& op, const std::filesystem::path& folder);
    Outcome run(Redo& op, const std::filesystem::path& folder);
    Outcome run(UnCut& op, const std::filesystem::path& folder);
    Outcome run(ReSeed& op, const std::filesystem::path& folder);
    Outcome run(Note& op, const std::filesystem::path& folder);
    Outcome run(SavePicture& op, const std::filesystem::path& folder);
    Outcome run(SaveLabels& op, const std::filesystem::path& folder);
    Outcome run(SaveSculpture& op, const std::filesystem::path& folder);

    render::Frame frame(const View& from, glm::ivec2 size);
    Pipeline::State stateOf(const View& from);
    // The canvas given, or the document's view on the usual viewport.
    void settle(std::optional<Canvas>& canvas) const;
    // Appends to the log, after the view that it happened in.
    void record(Operation operation);

    // Opens the stroke of an operation that cuts, whose canvas is set.
    void beginStroke(const Operation& operation);
    void discardStroke();
    Outcome endStroke();
    // A whole stroke; if something is thrown in its midst (a device without room), everything is as before.
    // Fills in what the stroke has found.
    template <typename Cut>
    Outcome cutAtOnce(Cut& op);
    // Sets which parts are pasted where, in the view too, as one undoable step.
    void arrangeParts(const Operation& operation, const PastedState& state,
                      std::optional<sculpt::BrickDelta> cut = {});
    void showParts(const PastedState& state);
    // What an operation does to segments, once all it needs has been found; also done again by redo.
    segment::SeedCounts perform(const Seed& op, Region::Records& records);
    int perform(const Grow& op, Region::Records& records);
    int perform(const Rewind& op, Region::Records& records);
    void perform(const ShowGeneration& op, Region::Records& records);
    void perform(const SetGrowthRules& op, Region::Records& records);
    int perform(const Absorb& op, Region::Records& records);
    void perform(const UseSegment& op, Region::Records& records);
    std::size_t perform(const LoadLabels& op, Region::Records& records);
    void perform(const RemoveSegment& op, Region::Records& records);
    void perform(const EditSegment& op, Region::Records& records);
    void perform(const BrushSegment& op, Region::Records& records);
    void perform(const PaintSegment& op, Region::Records& records);
    void perform(const ReSeed& op, Region::Records& records);
    // Performs and remembers; when it throws midway, everything is as before.
    template <typename Op>
    auto change(const Op& op);
    // Goes to work on the segment at work; throws Error when it is locked.
    void workUnlocked(Region::Records& records);
    segment::VoxelSet brushed(const BrushSegment& op);
    // Whether a voxel, or one next to it, is of a locked segment, so that cutting it would cut that; empty
    // when nothing is locked.
    [[nodiscard]] std::function<bool(glm::ivec3)> lockedVoxels() const;
    std::vector<glm::ivec3> voxelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                        const Canvas& canvas, const segment::Constraints& constraints);
    // What lies under a trail; with a range only voxels in it.
    [[nodiscard]] segment::VoxelSet voxelsUnder(const Trail& trail, const std::optional<Range>& range) const;
    std::vector<glm::dvec3> seenCells(const std::function<bool(std::size_t)>& isThere);
    [[nodiscard]] std::size_t grownVoxels() const;
    [[nodiscard]] Outcome describeGrowth(int generations, std::size_t voxelsBefore) const;
    // So many voxels in ml, with one decimal.
    [[nodiscard]] std::string millilitres(std::size_t voxels) const;
    // "120 voxels added", "7 voxels removed".
    static Phrase describeChange(std::size_t voxelsBefore, std::size_t voxelsNow);
    Region::Records repeat(const Operation& operation);
    void remember(Operation operation, std::optional<sculpt::BrickDelta> cut, Region::Records growth);
    Outcome travel(Step& step, bool isUndo);

    volume::Volume volume;
    field::Field field;
    std::vector<std::uint32_t> histogram;
    // What Document::visibleHistogram() has counted, or is counting, of which contents.
    struct VisibleCounts {
        field::VisibleHistogram counting;
        std::optional<std::pair<std::uint64_t, field::SculptureView>> of;
        bool isDone = false;
        std::vector<std::uint32_t> counts;
    };
    std::optional<VisibleCounts> visibleCounts; // made when first asked for
    sculpt::Sculpture sculpture;
    Pipeline pipeline;
    Region region;
    SegmentList segments;
    std::optional<int> scrubbedFrom; // the generation shown before
    Cutter cutter;
    std::optional<render::RayCaster> caster; // for SavePicture; made when first used
    History history;
    std::vector<Operation> log;
    std::size_t sealed = 0; // operations that are never replaced
    View view;
    View loggedView; // what replaying the log would show
    Range grey;
    std::uint64_t version = 0;

    std::unique_ptr<CutStroke> stroke; // the live one
    PastedState pasted;
    struct LiveGrowth {
        Region::Records records;
        int generations = 0;
        std::size_t voxelsBefore = 0;
        field::SculptureView sculptureView = field::SculptureView::Cut;
        Timer timer;
    };
    std::optional<LiveGrowth> live;
    Timer strokeTimer;
};

} // namespace vs::studio
