// SPDX-License-Identifier: Apache-2.0
// Macrocells, light, and what lies over bricks, brought up to date where they are stale.
#include "segment/finer/fine_growth.h"
#include "studio/editing/pipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::studio {

namespace {

// How many voxels of the finest level a change of segments or cuts reaches: a few of the coarsest level that
// is finer than the scene.
int reachOf(const field::BrickGrid& finest) {
    const glm::dvec3 ratio = finest.perSceneVoxel;
    return 8 * int(std::ceil(std::max({ratio.x, ratio.y, ratio.z})));
}

} // namespace

// Where a cut or a segment changed what macrocells were made from. Nothing: more than that has changed.
std::optional<Box3> Pipeline::changedVoxels(const Key& before, const Key& now,
                                            const sculpt::Sculpture& sculpture,
                                            const segment::Segmentation* segmentation) {
    Key same = before;
    same.sculptureVersion = now.sculptureVersion;
    same.segmentationVersion = now.segmentationVersion;
    same.drawsSegmentation = now.drawsSegmentation;
    same.fill = now.fill;
    same.fillSerial = now.fillSerial;
    const bool haveFill = before.fill != nullptr && now.fill != nullptr;
    const bool hasSegments = before.drawsSegmentation || now.drawsSegmentation;
    if (same != now || now.part != nullptr || (hasSegments && segmentation == nullptr) ||
        (!haveFill && before.fill != now.fill)) {
        return std::nullopt;
    }
    const bool haveStayed = before.drawsSegmentation && now.drawsSegmentation;
    const Box3 cut = unite(sculpture.changedSince(before.sculptureVersion),
                           haveFill ? field::changedBetween(*before.fill, *now.fill) : Box3());
    return hasSegments ? unite(cut, segmentation->changedSince(haveStayed ? before.segmentationVersion : 0))
                       : cut;
}

void Pipeline::refresh(Cells& cells, const Key& key, const State& state, const render::Frame& frame,
                       const gl::Texture* sculptureCells, const segment::Segmentation* segmentation) {
    const auto& old = cells.key;
    // In probe view a cut adds to what is seen, so there nothing can be kept.
    const bool mayKeep =
        state.cuttingSince && old && old->sculptureVersion == *state.cuttingSince &&
        old->view != field::SculptureView::Probe && key.view != field::SculptureView::Probe &&
        (old->view == key.view || old->view == field::SculptureView::Whole) && old->range == key.range &&
        old->functionVersion == key.functionVersion && old->sampling == key.sampling &&
        old->surfaceSmoothing == key.surfaceSmoothing && old->drawsSegmentation == key.drawsSegmentation &&
        old->segmentationVersion == key.segmentationVersion && old->hasFinerSegments == key.hasFinerSegments;
    if (mayKeep || old == key) {
        return;
    }
    render::Macrocells::Input input;
    input.dataCells = key.surfaceSmoothing > 0 ? &smoothed_->cells.cells : &cellRanges_.cells;
    input.dataSerial = key.surfaceSmoothing > 0 ? smoothed_->field.serial : field_->serial;
    if (key.fill != nullptr) {
        input.filledCells = &filledCells_.filled();
        if (!(key.surfaceSmoothing > 0)) {
            input.dataCells = &filledCells_.ranges();
            input.dataSerial = filledCells_.serial();
        }
    }
    input.sculptureCells = sculptureCells;
    input.segmentationCells = key.drawsSegmentation ? &segmentation->cells() : nullptr;
    input.visibleRange = field::withTolerance(key.range, *field_);
    input.view = key.view;
    input.sampling = key.sampling;
    input.classification = frame.mode == render::Mode::Volume ? frame.classification : nullptr;
    input.isFiner = detail_ != nullptr;
    input.hasFinerSegments = key.hasFinerSegments;
    input.changed = old ? changedVoxels(*old, key, *state.sculpture, segmentation) : std::nullopt;
    cells.key.reset(); // or what is left half done would pass for it
    cells.macrocells.rebuild(input);
    cells.key = key;
}

// Finer levels show what is cut there now.
void Pipeline::layCuts(const State& state) {
    const sculpt::FineSculpture* finer = state.sculpture->finer();
    if (detail_ != nullptr && finer != nullptr &&
        detail_->laidVersion(field::BrickLayer::Cuts) != finer->version()) {
        detail_->lay(field::BrickLayer::Cuts, finer->snapshot(), finer->version(),
                     [finer](std::uint64_t version) { return finer->changedSince(version); });
    }
}

// And what has grown there.
void Pipeline::laySegments(const State& state) {
    const sculpt::FineSculpture* finer = state.sculpture->isEmpty() ? nullptr : state.sculpture->finer();
    FinerSegments from;
    from.revision = state.finest->revision();
    from.serial = field_->serial;
    from.label = state.finest->label();
    from.playhead = state.finest->state().playhead;
    from.looks = looksOf(*state.segments);
    from.smoothing = state.smoothing;
    from.view = finer != nullptr ? state.view->sculptureView : field::SculptureView::Whole;
    from.cutsVersion = from.view != field::SculptureView::Whole ? finer->version() : 0;
    const bool isFirst = segmentsLaid_.overlay == nullptr;
    // While a stroke cuts, they end where they ended before it: it cuts what was seen when it began.
    const bool endAsBefore = state.cuttingSince && !isFirst;
    if (endAsBefore) {
        from.view = segmentsLaid_.from.view;
        from.cutsVersion = segmentsLaid_.from.cutsVersion;
    }
    if (!isFirst && from == segmentsLaid_.from) {
        return;
    }
    SegmentsLaid laid = segmentsLaid_;
    laid.from = from;
    laid.shown.looks = from.looks;
    laid.shown.smoothing = from.smoothing;
    laid.shown.sceneSpacing = field_->geometry.spacing();
    // Room for a second channel stays once it was made: bricks would have to come again.
    laid.shown.hasTranslucent =
        laid.shown.hasTranslucent ||
        std::find(from.looks.begin(), from.looks.end(), segment::Look::Translucent) != from.looks.end();
    Box3 cut;
    if (!endAsBefore) {
        const bool isCut = from.view != field::SculptureView::Whole;
        const bool haveChanged =
            laid.shown.view != from.view || segmentsLaid_.from.cutsVersion != from.cutsVersion;
        cut = isCut && haveChanged ? finer->changedSince(segmentsLaid_.from.cutsVersion) : Box3();
        laid.shown.view = from.view;
        laid.shown.fence = isCut ? finer->reader() : segment::FineFence();
        laid.shown.cuts = isCut && haveChanged ? finer->snapshot() : laid.shown.cuts;
        laid.shown.cuts = isCut ? laid.shown.cuts : nullptr;
    }
    const field::BrickGrid& finest = detail_->grids().front();
    laid.overlay = segment::fineMembership(*state.finest, finest, laid.shown);
    laid.version = ++segmentsMade_;
    if (!isFirst) {
        const Box3 box = unite(cut, segment::changedBetween(*segmentsLaid_.overlay, *laid.overlay));
        laid.changes[laid.version] = box.isEmpty() ? box : grow(box, reachOf(finest));
    }
    constexpr std::size_t kMostRemembered = 64;
    if (laid.changes.size() > kMostRemembered) {
        laid.changes.erase(laid.changes.begin());
    }
    detail_->lay(field::BrickLayer::Segments, laid.overlay, laid.version,
                 [this, all = Box3{glm::ivec3(0), finest.dims}](std::uint64_t version) {
                     return changedSince(segmentsLaid_, version).value_or(all);
                 });
    segmentsLaid_ = std::move(laid);
}

std::optional<Box3> Pipeline::changedSince(const SegmentsLaid& laid, std::uint64_t version) {
    Box3 box;
    for (std::uint64_t step = version + 1; step <= laid.version; ++step) {
        const auto change = laid.changes.find(step);
        if (change == laid.changes.end()) {
            return std::nullopt;
        }
        box = unite(box, change->second);
    }
    return box;
}

std::optional<Box3> Pipeline::finerSegmentsSince(std::uint64_t version) const {
    const auto finest = changedSince(segmentsLaid_, version);
    if (!finest || finest->isEmpty()) {
        return finest;
    }
    const field::BrickGrid& grid = detail_->grids().front();
    const glm::dvec3 lo = (glm::dvec3(finest->lo) - grid.origin) / grid.perSceneVoxel;
    const glm::dvec3 hi = (glm::dvec3(finest->hi) - grid.origin) / grid.perSceneVoxel;
    const Box3 box{glm::ivec3(glm::floor(lo)), glm::ivec3(glm::ceil(hi)) + 1};
    constexpr int kReach = 4; // of rays that look at it, as in picture_content.cpp
    return intersect(grow(box, kReach), {glm::ivec3(0), field_->geometry.dims});
}

// Of the whole grid, whatever was cut: so a stroke leaves them as they are, and pasted parts share them.
void Pipeline::refreshSegmentCells(bool hasFinerSegments) {
    Key key;
    key.hasFinerSegments = hasFinerSegments;
    key.segmentationVersion = segmentation_->version();
    key.drawsSegmentation = true;
    if (segmentCells_.key == key) {
        return;
    }
    render::Macrocells::Input input;
    input.dataCells = &cellRanges_.cells;
    input.segmentationCells = &segmentation_->cells();
    input.view = field::SculptureView::Whole;
    input.drawsData = false;
    input.hasFinerSegments = hasFinerSegments;
    if (segmentCells_.key && segmentCells_.key->hasFinerSegments == hasFinerSegments) {
        input.changed = segmentation_->changedSince(segmentCells_.key->segmentationVersion);
    }
    segmentCells_.key.reset();
    segmentCells_.macrocells.rebuild(input);
    segmentCells_.key = key;
}

void Pipeline::refresh(Light& light, Key key, const State& state, const field::Scene& scene,
                       const render::Frame& frame, const render::Macrocells& macrocells) {
    key.drawsData = frame.mode != render::Mode::Overlay;
    if (light.key == key) {
        return;
    }
    render::OcclusionVolume::Input input;
    input.scene = scene;
    input.scene.view = key.view;
    input.macrocells = &macrocells;
    input.classification = frame.mode == render::Mode::Volume ? frame.classification : nullptr;
    input.drawsData = key.drawsData;
    input.drawsSegmentation = key.drawsSegmentation;
    Key before = light.key.value_or(key);
    const std::uint64_t version = std::exchange(before.sculptureVersion, key.sculptureVersion);
    const field::SharedFill fill = std::exchange(before.fill, key.fill);
    before.fillSerial = key.fillSerial;
    const bool haveFill = fill == key.fill || (fill != nullptr && key.fill != nullptr);
    if (light.key && before == key && haveFill) { // nothing but cuts, and filling, since
        const Box3 filled = fill == key.fill ? Box3() : field::changedBetween(*fill, *key.fill);
        light.occlusion.update(input, unite(state.sculpture->changedSince(version), filled));
    } else {
        light.occlusion.rebuild(input);
    }
    light.key = key;
}

} // namespace vs::studio
