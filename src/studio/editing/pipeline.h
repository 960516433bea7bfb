// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/detail.h"
#include "field/filled_cells.h"
#include "field/marks/mark_texture.h"
#include "field/smoothed_field.h"
#include "render/rays/ray_caster.h"
#include "render/slices/slice_renderer.h"
#include "render/space/macrocells.h"
#include "sculpt/sculpture/sculpture.h"
#include "segment/growth/growth.h"
#include "segment/membership/fine_membership.h"
#include "segment/membership/segmentation.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"
#include "studio/state/pasted_parts.h"
#include "studio/state/picture_content.h"

#include <map>
#include <memory>

namespace vs::studio {

// From the document's state to something that can be rendered: notices what is stale and runs only those
// stages (segmentation volume, then macrocells).
class Pipeline {
public:
    explicit Pipeline(const field::Field& field);

    // Frames show these levels from now on, of which `cells` says what may be seen where.
    void showFiner(field::Detail& detail, field::CellRanges cells);

    struct State {
        const View* view = nullptr;
        const sculpt::Sculpture* sculpture = nullptr;
        const sculpt::Trimmed* trimmed = nullptr;
        const PastedState* pasted = nullptr;         // whose part is drawn at which of the view's places
        const segment::Growth* growth = nullptr;     // null: nothing seeded yet
        const segment::FineGrowth* finest = nullptr; // at the finest level; null: nothing, or not to be shown
        const SegmentList* segments = nullptr;       // how they look
        bool isCutAlongSegments = false;             // field::Scene
        segment::Smoothing smoothing = segment::Smoothing::Smooth;
        double segmentsMs = segment::Segmentation::kNoHurry; // that bringing the segments up to date may take
        field::SharedMarks marks;
        Filled filled;
        Range greyWindow;
        // The sculpture's version when the stroke in hand began. While it cuts, the macrocells of that moment
        // hold everything that can be seen, and are kept so that a stamp costs only what it touches.
        std::optional<std::uint64_t> cuttingSince;
    };
    render::Frame frame(const State& state, glm::ivec2 size);
    // What the last frame shows, and where that may differ from an earlier one of the same document: see
    // changedBetween().
    [[nodiscard]] const PictureContent& content() const { return content_; }
    [[nodiscard]] std::optional<Box3> changedSince(const State& state, const PictureContent& before) const;
    // Takes the room that drawing segments needs, ahead of the first; and gives it back while there are none.
    void prepareSegments(const View& view);
    void forgetSegments();
    // The document's content on a slice. Segments are drawn whatever the view's mode is.
    render::SliceFrame slice(const State& state, const render::SliceView& view);

    // What of the sculpture is drawn at a place of the view, and the ranges of the macrocells of the part
    // that a paste would make now.
    PastedParts::Part partAt(const State& state, std::size_t place);
    std::vector<glm::vec2> cellsOfNextPart(const State& state, bool takesTrimmed);

    // The segments of the last frame or slice are not up to date, because there was no time for it.
    [[nodiscard]] bool isBehind() const { return isBehind_; }

    // A transfer function with absolute positions on the field.
    render::TransferFunction resolved(const render::TransferFunction& function);

    [[nodiscard]] const field::CellRanges& cellRanges() const { return cellRanges_; }

private:
    // What the macrocells were last made from.
    struct Key {
        Range range;
        field::SculptureView view = field::SculptureView::Cut;
        std::uint64_t sculptureVersion = 0;
        std::uint64_t segmentationVersion = 0;
        const gl::Texture* part = nullptr; // instead of the sculpture
        std::uint64_t partMaking = 0;
        bool drawsSegmentation = false;
        bool drawsData = true;   // as far as light is concerned
        int functionVersion = 0; // of the transfer function, where it says what can be seen
        field::Sampling sampling = field::Sampling::Trilinear;
        double surfaceSmoothing = 0; // steps
        bool hasFinerSegments = false;
        field::SharedFill fill = {};           // null: none is shown
        std::uint64_t fillSerial = 0;          // of the ranges with it
        std::vector<glm::vec2> materials = {}; // value, and 1 where they are seen
        bool operator==(const Key&) const = default;
    };

    // The finer levels that a picture shows: none while a stroke in hand has cut nothing of them yet.
    [[nodiscard]] field::Detail* detailFor(const State& state) const;
    // Drops what was made for voxels that lay elsewhere, or for segments that were smoothed otherwise.
    void follow(const View& view);
    void dropSegments();

    const field::Field* field_;
    field::Detail* detail_ = nullptr;
    std::uint64_t serial_; // the field's, for which all the following was made
    bool areSegmentsSmooth_ = true;
    field::CellRanges cellRanges_;
    std::optional<segment::Segmentation> segmentation_; // made when first drawn
    int segmentationsMade_ = 0;
    field::MarkTexture marks_;
    field::FillTexture fill_;
    field::FilledCells filledCells_;
    PictureContent content_; // of the last frame
    // The same for pasted parts, while they are drawn beside what is left and growth had a fence.
    std::optional<segment::Segmentation> partSegmentation_;
    bool isBehind_ = false;
    // What segments over the bricks of finer levels are made from.
    struct FinerSegments {
        std::uint64_t revision = 0; // of what has grown
        std::uint64_t serial = 0;   // of the field
        std::uint8_t label = 0;     // of the segment at work, and how far it is shown
        int playhead = 0;
        segment::Looks looks = segment::allOpaque();
        segment::Smoothing smoothing = segment::Smoothing::Smooth;
        field::SculptureView view = field::SculptureView::Whole;
        std::uint64_t cutsVersion = 0;
        bool operator==(const FinerSegments&) const = default;
    };
    // What lies over them now, its number, and in which voxels of the finest level late ones differ from
    // those before.
    struct SegmentsLaid {
        FinerSegments from;
        segment::FineShown shown;
        std::shared_ptr<const field::BrickOverlay> overlay;
        std::uint64_t version = 0;
        std::map<std::uint64_t, Box3> changes;
    };
    SegmentsLaid segmentsLaid_;
    std::uint64_t segmentsMade_ = 0;
    [[nodiscard]] static std::optional<Box3> changedSince(const SegmentsLaid& laid, std::uint64_t version);
    // The voxels of the scene in which they may differ from an earlier one; nothing: anywhere.
    [[nodiscard]] std::optional<Box3> finerSegmentsSince(std::uint64_t version) const;
    void makeSegmentation();
    // What shaders see of the document, with the segments if they are wanted; brings those up to date.
    field::Scene scene(const State& state, bool wantsSegments);
    static segment::Looks looksOf(const SegmentList& list);
    // What pictures show of materials.
    [[nodiscard]] field::ShownMaterials shownMaterials(const State& state) const;
    void layCuts(const State& state);
    void laySegments(const State& state);
    // What the viewer does not see of the sculpture in a view.
    static segment::Fence fence(const State& state, field::SculptureView view);
    // The segments as pasted parts show them: their cut faces look the other way.
    const segment::Segmentation* segmentsOfParts(const State& state, const render::Frame& frame);
    // Else all that has grown is of the segment at work; its labels may lag behind and are not asked.
    static bool usesLabels(const State& state);
    // How segments look.
    static render::SegmentColours segmentColours(const State& state);

    // The values that the view's surfaces are looked for in; null: the data's own. Made when they are not
    // there.
    const field::SmoothedField* smooth(const View& view);

    [[nodiscard]] PictureContent contentOf(const State& state, const render::Frame& frame) const;

    // Brings the tables of the view's transfer function up to date; null if it has none and needs none.
    const render::Classification* classify(const State& state);

    // Macrocells and what they were made from.
    struct Cells {
        render::Macrocells macrocells;
        std::optional<Key> key;
    };
    static std::optional<Box3> changedVoxels(const Key& before, const Key& now,
                                             const sculpt::Sculpture& sculpture,
                                             const segment::Segmentation* segmentation);
    void refresh(Cells& cells, const Key& key, const State& state, const render::Frame& frame,
                 const gl::Texture* sculptureCells, const segment::Segmentation* segmentation);

    // What blocks the light in a scene; made when shadows are first wanted.
    struct Light {
        render::OcclusionVolume occlusion;
        std::optional<Key> key;
    };
    void refresh(Light& light, Key key, const State& state, const field::Scene& scene,
                 const render::Frame& frame, const render::Macrocells& macrocells);

    // One for each texture that parts are drawn from: places that show the same share them.
    struct PartStages {
        const gl::Texture* texels = nullptr;
        Cells cells;
        Light light;
    };
    PartStages& stagesOf(const gl::Texture* texels);
    void addParts(render::Frame& frame, Key key, const State& state);
    // Segments that are drawn once more, elsewhere.
    static std::vector<const SegmentInfo*> pulledOut(const State& state);
    // The pulled-out segments that others may touch, by label.
    static std::vector<std::uint8_t> apartFromOthers(const State& state);
    void addPulledOut(render::Frame& frame, const field::Scene& withSegments, const State& state);

    // Brings the macrocells of the segments alone up to date.
    void refreshSegmentCells(bool hasFinerSegments);

    Cells cells_;
    Cells segmentCells_;
    Light light_;
    PastedParts pastedParts_;
    std::vector<std::unique_ptr<PartStages>> partStages_;
    std::optional<render::Classification> classification_; // made when first needed
    std::optional<field::SmoothedField> smoothed_;         // the last one that a view wanted
};

} // namespace vs::studio
