// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "field/field.h"
#include "render/rays/picker.h"
#include "render/rays/ray_caster.h"
#include "render/slices/slice_renderer.h"
#include "sculpt/sculpture/precision.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"
#include "studio/state/history.h"
#include "volume/grid/volume.h"

#include <filesystem>
#include <memory>

namespace vs::studio {

// What applying one operation did.
struct Outcome {
    std::string name;
    double milliseconds = 0;
    std::size_t voxelsTouched = 0; // sculpture voxels changed, or voxels grown or taken back
    Phrase message;                // for the status line, one line
};

// A volume with everything a person has done to it. All edits go through apply(), or through one of the live
// strokes below, which end as one operation. Needs a current GL context for its whole life; one thread.
class Document {
public:
    // Takes the volume and uploads it. The first displayed range is the suggested one. `precision` is that of
    // what has been cut.
    explicit Document(volume::Volume volume, sculpt::Precision precision = sculpt::Precision::Bits16);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    [[nodiscard]] const volume::Volume& volume() const;
    [[nodiscard]] const field::Field& field() const;
    [[nodiscard]] sculpt::Precision precision() const; // of the sculpture
    // Voxel counts in equal bins over volume().range, at most 256.
    [[nodiscard]] const std::vector<std::uint32_t>& histogram() const;
    // The same of the voxels on the visible side of what was cut: what choosing a displayed range can show.
    // Counted in slices of about `budgetMs`, anew after each cut; null until all are counted. No stroke may
    // be open.
    const std::vector<std::uint32_t>* visibleHistogram(double budgetMs);
    // A transfer function with absolute positions on this volume: what can be edited on its histogram.
    render::TransferFunction resolved(const render::TransferFunction& function);
    [[nodiscard]] const View& view() const;
    // All operations so far, in order, pictures and label maps included: what a session saves.
    [[nodiscard]] const std::vector<Operation>& log() const;

    // Applies one operation and appends it to the log. `outputFolder` is where pictures and label maps go.
    // Throws Error (one line) and changes nothing if the operation makes no sense here.
    Outcome apply(const Operation& operation, const std::filesystem::path& outputFolder = ".");

    // Takes the last step back, as if it had never been done, and does this instead, where that step was an
    // operation of the same kind and nothing has happened since; else as apply(). What a slider sends while
    // it is dragged becomes one operation and one undo step in this way. When this is refused, the last step
    // stays.
    Outcome replaceLast(const Operation& operation);

    // A file holds what is logged so far: what comes is not merged with it any more (replaceLast(),
    // rewindFurther()).
    void seal();

    // Appends an operation that only writes a file (isOutput) to the log without writing it again: a session
    // that is opened in the window keeps what it asks for.
    void logOutput(const Operation& operation);

    // Changes the view without logging; used while the view is being dragged. The next apply() logs it first.
    void look(const View& view);

    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    // Undo has no end, but what it keeps of cuts takes no more than so many bytes of memory; the rest is in a
    // temporary file.
    void setUndoMemory(std::size_t bytes);
    [[nodiscard]] UndoStatistics undoStatistics() const;
    // All that undo and redo go through, the oldest first; so many hold now. Valid until the next change.
    struct Steps {
        std::vector<const Operation*> operations;
        std::size_t done = 0;
    };
    [[nodiscard]] Steps steps() const;
    // What undo would take back; null: nothing.
    [[nodiscard]] const Operation* lastStep() const;

    // A frame of the current view, ready for a RayCaster or Picker. Brings macrocells up to date first. Valid
    // until the document is changed or another frame is made. What grew far at once may take many
    // milliseconds to smooth: no more than `segmentsMs` are spent on it, and isBehind() tells that the
    // segments' surface is not all there yet.
    render::Frame frame(glm::ivec2 size, double segmentsMs = kNoHurry);
    static constexpr double kNoHurry = 1e30;

    // A slice through it, ready for a SliceRenderer; valid as long.
    render::SliceFrame slice(const render::SliceView& view, double segmentsMs = kNoHurry);
    [[nodiscard]] bool isBehind() const; // the last frame or slice

    // Counts document changes that a picture can show (view, sculpture, segmentation).
    [[nodiscard]] std::uint64_t version() const;

    // Live strokes: what the pen does now is seen at once; commit() appends one operation and one undo step,
    // the same as apply() of that operation would have given; discard() leaves no trace. One at a time;
    // apply() must not be called before it ends.
    // A Peel, Drill, Laser or Clip; what it says of layers, pen points and planes is done already.
    void beginStroke(Operation operation);
    void updatePeel(double layers);              // the total so far; fewer than before puts layers back
    void updatePen(const sculpt::PenPoint& pen); // drill and laser
    void updateClip(const Clip& clip);           // instead of the one before
    [[nodiscard]] bool isStrokeOpen() const;
    // The operation that commitStroke() would append.
    [[nodiscard]] Operation openStroke() const;
    Outcome commitStroke();
    void discardStroke();

    // Plays backward; when the last thing done was that too, both become one operation and one undo step, so
    // that a button held down leaves one.
    Outcome rewindFurther(int generations);

    // Live scrubbing over generations: shows one at once, unsmoothed; endScrub() appends one ShowGeneration
    // operation for all of it. There must be seeds.
    void scrub(int generation);
    [[nodiscard]] bool isScrubbing() const;
    Outcome endScrub();

    // Live growth: play in slices of about `budgetMs`; endGrowth() appends one Grow operation for all of
    // them. Returns false when nothing grows any more.
    void beginGrowth();
    bool growFor(double budgetMs, int maxGenerations);
    [[nodiscard]] bool isGrowing() const;
    Outcome endGrowth();

    struct GrowthStatus {
        int generation = 0;     // the one shown
        int extent = 0;         // the last one computed
        std::size_t voxels = 0; // grown at the generation shown
        double millilitres = 0;
        Range range; // intensity range of the run
        bool hasSeeds = false;
    };
    [[nodiscard]] GrowthStatus growth() const;
    // What the segment at work may grow into; before its first seeds the rules that were set so far.
    struct GrowthRules {
        Range range;
        std::optional<Range> difference;
        std::optional<Range> gradient;
        std::optional<Range> gradientDifference;
        int connectivity = 6;
        bool isLive = false;
    };
    [[nodiscard]] GrowthRules growthRules() const;
    // Voxels shown of a segment, by its label.
    [[nodiscard]] std::size_t voxelCount(std::uint8_t label) const;
    // Counts changes of what is shown of segments.
    [[nodiscard]] std::uint64_t segmentsRevision() const;
    // All segments: their names, labels and looks, and which is at work.
    [[nodiscard]] const SegmentList& segments() const;

    // Value and place under a viewport position: the surface point there. Nothing if the ray meets nothing.
    struct Probe {
        glm::dvec3 voxel{0};
        glm::dvec3 world{0};
        double value = 0;
    };
    std::optional<Probe> probe(glm::dvec2 pixel, glm::ivec2 viewport);

    // How a mask drawn on a canvas of the present view lies on the surface under a pixel: its outline there,
    // in pixels. Empty if nothing is under the pixel. For the laser's preview.
    std::vector<glm::dvec2> outlineOnSurface(const Sketch& mask, glm::dvec2 pixel, glm::ivec2 viewport);
    // The outlines of a sweep's mask here and there along its path, in pixels of its canvas.
    std::vector<std::vector<glm::dvec2>> outlinesAlongPath(const Sweep& sweep);
    // Parts pasted so far (by Paste); the view's places may be more or fewer.
    [[nodiscard]] std::size_t pastedParts() const;
    // Voxels around what can be seen of a pasted part, where it was cut out; empty when that is nothing.
    // partBox(pastedParts()): around what the next paste would take, all that was cut since the last one.
    Box3 partBox(std::size_t part);
    // The middles (voxel space) of the macrocells in which something of such a part can be seen; and of those
    // in which something of what remains can, as the view shows the sculpture.
    std::vector<glm::dvec3> partCells(std::size_t part);
    std::vector<glm::dvec3> remainingCells();

    // Bytes of the states that undo must restore, for tests and checks.
    [[nodiscard]] std::vector<std::byte> sculptureBytes() const;
    // Whether anything is cut.
    [[nodiscard]] bool isCut() const;
    // The sculpture in a box, 0 untouched to 1 cut away; and what is drawn at a place of view().pasted: the
    // part where it is at least a half.
    [[nodiscard]] std::vector<float> sculptureValues(const Box3& box) const;
    std::vector<float> partValues(std::size_t place, const Box3& box);
    // For each voxel the generation in which the segment at work took it, as far as is shown; 0 = not grown.
    [[nodiscard]] std::vector<std::uint32_t> generations() const;
    // 1 = in the segment at work.
    [[nodiscard]] std::vector<std::uint8_t> labels() const;
    // All segments by their labels, as SaveLabels writes them; 0 = none.
    [[nodiscard]] std::vector<std::uint8_t> labelMap() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace vs::studio
