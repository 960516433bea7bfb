// SPDX-License-Identifier: Apache-2.0
// Macrocells and light, brought up to date where they are stale.
#include "segment/finer/fine_growth.h"
#include "segment/membership/fine_membership.h"
#include "studio/editing/pipeline.h"

#include <utility>

namespace vs::studio {

// Where a cut or a segment changed what macrocells were made from. Nothing: more than that has changed.
std::optional<Box3> Pipeline::changedVoxels(const Key& before, const Key& now,
                                            const sculpt::Sculpture& sculpture,
                                            const segment::Segmentation* segmentation) {
    Key same = before;
    same.sculptureVersion = now.sculptureVersion;
    same.segmentationVersion = now.segmentationVersion;
    same.drawsSegmentation = now.drawsSegmentation;
    const bool hasSegments = before.drawsSegmentation || now.drawsSegmentation;
    if (same != now || now.part != nullptr || (hasSegments && segmentation == nullptr)) {
        return std::nullopt;
    }
    const bool haveStayed = before.drawsSegmentation && now.drawsSegmentation;
    const Box3 cut = sculpture.changedSince(before.sculptureVersion);
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
        old->segmentationVersion == key.segmentationVersion;
    if (mayKeep || old == key) {
        return;
    }
    render::Macrocells::Input input;
    input.dataCells = key.surfaceSmoothing > 0 ? &smoothed_->cells.cells : &cellRanges_.cells;
    input.dataSerial = key.surfaceSmoothing > 0 ? smoothed_->field.serial : field_->serial;
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
    LaidSegments laid;
    laid.revision = state.finest->revision();
    laid.label = state.finest->label();
    laid.playhead = state.finest->state().playhead;
    laid.looks = looksOf(*state.segments);
    laid.smoothing = state.smoothing;
    laid.view = finer != nullptr ? state.view->sculptureView : field::SculptureView::Whole;
    laid.cutsVersion = laid.view != field::SculptureView::Whole ? finer->version() : 0;
    if (laidVersion_ > 0 && laid == laidSegments_) {
        return;
    }
    laidSegments_ = laid;
    segment::FineShown shown{laid.looks, laid.smoothing, laid.view};
    if (laid.view != field::SculptureView::Whole) {
        shown.fence = finer->reader();
        shown.cuts = finer->snapshot();
    }
    const field::BrickGrid& finest = detail_->grids().front();
    detail_->lay(field::BrickLayer::Segments, segment::fineMembership(*state.finest, finest, shown),
                 ++laidVersion_, [all = Box3{glm::ivec3(0), finest.dims}](std::uint64_t) { return all; });
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
    if (light.key && before == key) { // nothing but cuts since
        light.occlusion.update(input, state.sculpture->changedSince(version));
    } else {
        light.occlusion.rebuild(input);
    }
    light.key = key;
}

} // namespace vs::studio
