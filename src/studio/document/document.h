// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "image/image.h"
#include "render/rays/ray_caster.h"
#include "render/slices/slice_renderer.h"
#include "sculpt/sculpture/sculpture.h"
#include "sculpt/sculpture/trimmed.h"
#include "studio/document/document_facts.h"
#include "studio/editing/outcome.h"
#include "studio/operations/operation.h"
#include "studio/state/history.h"
#include "studio/state/picture_content.h"
#include "studio/state/read_labels.h"
#include "volume/grid/volume.h"

#include <filesystem>
#include <memory>
#include <span>

namespace vs::studio {

struct DocumentState;
class LiveGrowth;
class LiveMark;
class LiveStroke;
class PartQueries;
class Region;
class SurfaceQueries;
struct FinerLevels;

// A volume with everything a person has done to it. All edits go through apply(), or through a live stroke or
// live growth, which end as one operation. Needs a current GL context for its whole life; one thread.
class Document {
public:
    // Takes the volume and uploads it. The first displayed range is the suggested one. `precision` is that of
    // what has been cut.
    explicit Document(volume::Volume volume, sculpt::Precision precision = sculpt::Precision::Bits16);
    // Becomes what another one on that volume was (state()), to the byte, with its undo and redo. Throws
    // Error when the state does not fit the volume.
    Document(volume::Volume volume, DocumentState state);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    // --- what it is made of

    [[nodiscard]] const volume::Volume& volume() const;
    // Where its voxels lie by its file; corrections (CorrectGeometry) are in volume().
    [[nodiscard]] const volume::GridGeometry& geometryInFile() const;
    // Where labels that are read for it must lie.
    [[nodiscard]] LabelGrids labelGrids() const;
    [[nodiscard]] const field::Field& field() const;
    // Voxel counts in equal bins over volume().usual, at most 256.
    [[nodiscard]] const std::vector<std::uint32_t>& histogram() const;
    // Counts the voxels on the visible side of what was cut, in the same bins, in portions of about
    // `budgetMs`: what choosing a displayed range can show. Anew after each cut; null until all are counted.
    // No stroke may be open.
    const std::vector<std::uint32_t>* visibleHistogram(double budgetMs);
    [[nodiscard]] const View& view() const;
    [[nodiscard]] const sculpt::Sculpture& sculpture() const;
    [[nodiscard]] const sculpt::Trimmed& trimmed() const; // what of it was trimmed away
    // All segments: their names, labels and looks, and which is at work; and where they are.
    [[nodiscard]] const SegmentList& segments() const;
    [[nodiscard]] const Region& region() const;
    [[nodiscard]] const History& history() const;
    // All operations so far, in order, pictures and label maps included: what a session saves.
    [[nodiscard]] const std::vector<Operation>& log() const;
    // What is known of all this now, as one value that does not change any more. Cheap when nothing has
    // changed since the last time. Needs no current GL context.
    [[nodiscard]] std::shared_ptr<const DocumentFacts> facts() const;
    // All that it holds beside its volume, for sessions. Nothing may be in hand.
    [[nodiscard]] DocumentState state() const;
    // Counts document changes that a picture can show (view, sculpture, segmentation); and of them those that
    // the 3D picture shows, which slices' windows are not.
    [[nodiscard]] std::uint64_t version() const;
    [[nodiscard]] std::uint64_t pictureVersion() const;

    // --- operations

    // Applies one operation and appends it to the log. `outputFolder` is where pictures and label maps go.
    // `coming` is what a session does afterwards, for pictures that show the strokes to come. Throws Error
    // (one line) and changes nothing if the operation makes no sense here.
    Outcome apply(const Operation& operation, const std::filesystem::path& outputFolder = ".",
                  std::span<const Operation> coming = {});

    // Takes the last step back, as if it had never been done, and does this instead, where that step was an
    // operation of the same kind and nothing has happened since; else as apply(). What a slider sends while
    // it is dragged becomes one operation and one undo step in this way. When this is refused, the last step
    // stays.
    Outcome replaceLast(const Operation& operation);

    // Plays backward; when the last thing done was that too, both become one operation and one undo step, so
    // that a button held down leaves one.
    Outcome rewindFurther(int generations);

    // A file holds what is logged so far: what comes is not merged with it any more (replaceLast(),
    // rewindFurther()).
    void seal();

    // Appends an operation that only writes a file (isOutput) to the log without writing it again: a session
    // that is opened in the window keeps what it asks for.
    void logOutput(const Operation& operation);

    // Changes the view without logging; used while the view is being dragged. The next apply() logs it first.
    void showView(const View& view);

    // Pictures show finer levels of the scan from now on, where their pixels ask for them; all that is done
    // is done to volume() all the same. Throws Error, and GlError where the device has no room.
    void showFinerLevels(const FinerLevels& levels);
    // What it has of them; null: it shows none.
    [[nodiscard]] const field::Detail* detail() const;
    // All levels of the scan, where finer ones are shown; else null.
    [[nodiscard]] std::shared_ptr<const volume::BrickSource> levels() const;

    // Undo has no end, but what it keeps of cuts takes no more than so many bytes of memory; the rest is in a
    // temporary file.
    void setUndoMemory(std::size_t bytes);

    LiveStroke& stroke(); // what the pen does now
    LiveMark& mark();     // what a marking pen does now
    // Colours that were laid on the material.
    [[nodiscard]] const field::SharedMarks& marks() const;
    [[nodiscard]] const Filled& filled() const;
    LiveGrowth& growing(); // growth that goes on

    // --- pictures, and what is where in them

    // A frame of the current view, ready for a RayCaster or Picker. Brings macrocells up to date first. Valid
    // until the document is changed or another frame is made. What grew far at once may take many
    // milliseconds to smooth: no more than `segmentsMs` are spent on it, and isBehind() tells that the
    // segments' surface is not all there yet.
    render::Frame frame(glm::ivec2 size, double segmentsMs = kNoHurry);
    static constexpr double kNoHurry = 1e30;

    // What the last frame shows, and the voxels along whose rays it may differ from an earlier frame of this
    // document: none is no difference, nothing that it may differ everywhere.
    [[nodiscard]] const PictureContent& content() const;
    [[nodiscard]] std::optional<Box3> changedSince(const PictureContent& before) const;

    // A slice through it, ready for a SliceRenderer; valid as long.
    render::SliceFrame slice(const render::SliceView& view, double segmentsMs = kNoHurry);
    [[nodiscard]] bool isBehind() const; // the last frame or slice

    // What a film shows at a time of it, as a picture; the document is afterwards as it was. Throws Error
    // when the film shows what is not there.
    image::Image filmFrame(const SaveMovie& film, double seconds, glm::ivec2 size);

    // A transfer function with absolute positions on this volume: what can be edited on its histogram.
    render::TransferFunction resolved(const render::TransferFunction& function);

    SurfaceQueries& surface();
    PartQueries& parts();

private:
    friend class FilmPlayer;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace vs::studio
