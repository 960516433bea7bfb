// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/pipeline.h"

#include "render/colours/colour.h"
#include "render/colours/function_edits.h"
#include "studio/editing/shown_places.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

Pipeline::Pipeline(const field::Field& field)
    : field_(&field), serial_(field.serial), cellRanges_(field::computeCellRanges(field)) {}

void Pipeline::showFiner(field::Detail& detail, field::CellRanges cells) {
    detail_ = &detail;
    cellRanges_ = std::move(cells);
    filledCells_ = {};
    segmentsLaid_ = {};
    cells_.key.reset();
    light_.key.reset();
    partStages_.clear();
}

void Pipeline::follow(const View& view) {
    if (std::exchange(serial_, field_->serial) != field_->serial) {
        smoothed_.reset();
        dropSegments();
    }
    if (std::exchange(areSegmentsSmooth_, view.smoothsSegments) != view.smoothsSegments) {
        dropSegments();
    }
}

void Pipeline::dropSegments() {
    segmentation_.reset();
    partSegmentation_.reset();
    cells_.key.reset();
    segmentCells_.key.reset();
    light_.key.reset();
    partStages_.clear();
}

segment::Looks Pipeline::looksOf(const SegmentList& list) {
    segment::Looks looks = segment::allOpaque();
    for (const SegmentInfo& segment : list.segments) {
        looks[segment.label] = !segment.isVisible    ? segment::Look::Hidden
                               : segment.opacity < 1 ? segment::Look::Translucent
                                                     : segment::Look::Opaque;
    }
    return looks;
}

render::TransferFunction Pipeline::resolved(const render::TransferFunction& function) {
    if (!classification_) {
        classification_.emplace();
    }
    return classification_->resolved(function, *field_);
}

const render::Classification* Pipeline::classify(const State& state) {
    const View& view = *state.view;
    if (!view.transferFunction && view.mode != render::Mode::Volume) {
        return nullptr;
    }
    if (!classification_) {
        classification_.emplace();
    }
    std::vector<double> values;
    for (const Material& material : *state.filled.materials) {
        values.push_back(material.value);
    }
    classification_->update(view.transferFunction ? *view.transferFunction
                                                  : render::functionOfRange(view.range),
                            *field_, values);
    return &*classification_;
}

segment::Fence Pipeline::fence(const State& state, field::SculptureView view) {
    if (state.sculpture->isEmpty()) {
        return {};
    }
    segment::Fence fence{&state.sculpture->texels(), &state.sculpture->cells(), view};
    // While a stroke cuts, what it hides is known, and need not be looked at before it has ended.
    fence.version = state.cuttingSince.value_or(state.sculpture->version());
    fence.changedSince = [sculpture = state.sculpture](std::uint64_t version) {
        return sculpture->changedSince(version);
    };
    return fence;
}

const field::SmoothedField* Pipeline::smooth(const View& view) {
    const bool showsSurface = view.mode == render::Mode::Surface || view.mode == render::Mode::Segment;
    if (!showsSurface || view.surfaceSmoothing <= 0) {
        return nullptr;
    }
    if (!smoothed_ || smoothed_->sigmaSteps != view.surfaceSmoothing) {
        smoothed_.reset(); // there may be no room for two
        smoothed_ = field::smoothField(*field_, view.surfaceSmoothing);
    }
    return &*smoothed_;
}

void Pipeline::makeSegmentation() {
    if (!segmentation_) {
        segmentation_.emplace(field_->geometry);
        ++segmentationsMade_;
    }
}

void Pipeline::prepareSegments(const View& view) {
    follow(view);
    makeSegmentation();
}

void Pipeline::forgetSegments() {
    if (cells_.key && cells_.key->drawsSegmentation) {
        dropSegments();
    }
    segmentation_.reset();
}

field::Scene Pipeline::scene(const State& state, bool wantsSegments) {
    const bool hasSegmentation = wantsSegments && state.growth != nullptr;
    if (hasSegmentation) {
        makeSegmentation();
        segmentation_->keepApart(apartFromOthers(state));
        segmentation_->update(*state.growth, state.smoothing, looksOf(*state.segments), state.segmentsMs,
                              fence(state, state.view->sculptureView));
    }
    isBehind_ = hasSegmentation && segmentation_->isBehind();
    // With nothing cut yet the volume is drawn whole, in probe view too: there must be something to draw on.
    const bool isSculpted = !state.sculpture->isEmpty();
    field::Scene scene;
    scene.data = field_;
    scene.view = isSculpted ? state.view->sculptureView : field::SculptureView::Whole;
    scene.sculpture = isSculpted ? &state.sculpture->texels() : nullptr;
    layCuts(state);
    scene.hasFinerCuts = isSculpted && state.sculpture->finer() != nullptr && detail_ != nullptr &&
                         detail_->hasOverlay(field::BrickLayer::Cuts);
    scene.isCutAlongSegments = state.isCutAlongSegments;
    scene.segmentation = hasSegmentation ? &segmentation_->texels() : nullptr;
    // Tools that spare segments do so at the scene's resolution, and cut along its surfaces.
    const bool endsAtScenes = isSculpted && state.isCutAlongSegments;
    if (hasSegmentation && state.finest != nullptr && detail_ != nullptr && !endsAtScenes) {
        laySegments(state);
        scene.hasFinerSegments = detail_->hasOverlay(field::BrickLayer::Segments);
    }
    if (hasSegmentation && usesLabels(state)) {
        state.growth->syncLabels();
        scene.segmentLabels = &state.growth->seedMap().labels();
    }
    marks_.show(state.marks);
    scene.marks = marks_.isEmpty() ? nullptr : &marks_;
    fill_.show(state.filled.fill);
    // The view of what was cut shows what is gone, and no material.
    const bool showsFill = !fill_.isEmpty() && scene.view != field::SculptureView::Probe;
    scene.fill = showsFill ? &fill_ : nullptr;
    scene.materials = shownMaterials(state);
    scene.displayedRange = state.view->range;
    scene.showsAbove = state.view->showsAbove();
    scene.greyWindow = state.greyWindow;
    scene.sampling = state.view->sampling;
    return scene;
}

field::ShownMaterials Pipeline::shownMaterials(const State& state) const {
    const View& view = *state.view;
    const Range seen = field::withTolerance(view.visibleRange(field_->range), *field_);
    field::ShownMaterials shown;
    for (const Material& material : *state.filled.materials) {
        const bool isInRange = view.mode == render::Mode::Volume || seen.contains(material.value);
        shown.push_back({glm::vec3(render::linearFromDisplay(material.colour)), float(material.value),
                         material.isVisible && isInRange});
    }
    return shown;
}

bool Pipeline::usesLabels(const State& state) { return state.growth->hasOthers() || state.finest != nullptr; }

render::SegmentColours Pipeline::segmentColours(const State& state) {
    if (state.growth == nullptr) {
        return {};
    }
    auto colours = state.segments->colours();
    if (state.finest != nullptr) {
        // What is too thin in another one to have voxels of the scene, where its labels are asked.
        colours.entries[0] = colours.entries[state.segments->atWork];
    }
    if (!usesLabels(state)) { // pictures have 1 everywhere
        colours.entries[1] = colours.entries[state.growth->activeLabel()];
    }
    return colours;
}

render::SliceFrame Pipeline::slice(const State& state, const render::SliceView& view) {
    follow(*state.view);
    render::SliceFrame frame;
    frame.scene = scene(state, true);
    if (frame.scene.segmentation != nullptr && segmentation_->goesOnBehindCuts()) {
        // Slices show what is grown and nothing more, which is what labels say.
        state.growth->syncLabels();
        frame.scene.segmentLabels = &state.growth->seedMap().labels();
    }
    frame.segmentColours = segmentColours(state);
    frame.tintsVisible = state.view->tintsSlices;
    frame.visible = state.view->visibleRange(field_->range);
    if (frame.tintsVisible && state.view->transferFunction) {
        frame.classification = classify(state);
    }
    frame.view = view;
    frame.detail = detailFor(state);
    return frame;
}

render::Frame Pipeline::frame(const State& state, glm::ivec2 size) {
    follow(*state.view);
    const View& view = *state.view;
    const bool drawsSegments = view.mode == render::Mode::Overlay || view.mode == render::Mode::Segment ||
                               view.mode == render::Mode::Volume;
    const bool tintsSegments =
        view.tintsSegments && (view.mode == render::Mode::Mip || view.mode == render::Mode::XRay);
    const bool pullsOut = !pulledOut(state).empty();
    render::Frame frame;
    const field::Scene withSegments = scene(state, drawsSegments || tintsSegments || pullsOut);
    frame.scene = withSegments;
    if (!drawsSegments && !tintsSegments) {
        frame.scene.segmentation = nullptr;
    }
    const bool hasSegmentation = frame.scene.segmentation != nullptr;
    const bool hasSurfaces = hasSegmentation && drawsSegments;
    const bool isSculpted = frame.scene.sculpture != nullptr;
    if (const field::SmoothedField* smoothed = smooth(view)) {
        frame.scene.smoothed = &smoothed->field;
    }
    if (withSegments.segmentation != nullptr) {
        frame.segmentColours = segmentColours(state);
    }
    frame.rays = render::viewRays(view.camera, field_->geometry, size);
    frame.mode = view.mode;
    frame.isInverted = view.isInverted;
    frame.classification = classify(state);
    const bool byFunction = view.mode == render::Mode::Volume;

    Key key{view.visibleRange(field_->range),
            frame.scene.view,
            state.sculpture->version(),
            hasSurfaces ? segmentation_->version() : 0,
            nullptr,
            0,
            hasSurfaces,
            true,
            byFunction ? classification_->version() : 0,
            view.sampling,
            frame.scene.smoothed != nullptr ? view.surfaceSmoothing : 0,
            hasSurfaces && frame.scene.hasFinerSegments};
    if (frame.scene.fill != nullptr) {
        filledCells_.update(cellRanges_.cells, field_->serial, fill_.shown(), frame.scene.materials);
        key.fill = fill_.shown();
        key.fillSerial = filledCells_.serial();
        for (const field::ShownMaterial& material : frame.scene.materials) {
            key.materials.emplace_back(material.value, material.isSeen ? 1 : 0);
        }
    }
    refresh(cells_, key, state, frame, isSculpted ? &state.sculpture->cells() : nullptr,
            segmentation_ ? &*segmentation_ : nullptr);
    frame.macrocells = &cells_.macrocells;
    if (hasSurfaces && (view.mode != render::Mode::Segment || detailFor(state) != nullptr)) {
        refreshSegmentCells(frame.scene.hasFinerSegments);
        frame.segmentCells = &segmentCells_.macrocells;
    }
    if (view.shadows) {
        refresh(light_, key, state, frame.scene, frame, cells_.macrocells);
        frame.occlusion = &light_.occlusion;
    }
    if (isSculpted && !view.pasted.empty()) {
        addParts(frame, key, state);
        // Parts whose segments go on behind the other side of the cut have them in other cells.
        const bool haveOthers = std::any_of(frame.pasted.begin(), frame.pasted.end(), [&](const auto& part) {
            return part.segmentation != nullptr && part.segmentation != frame.scene.segmentation;
        });
        frame.segmentCells = haveOthers ? nullptr : frame.segmentCells;
    }
    if (pullsOut) {
        addPulledOut(frame, withSegments, state);
    }
    frame.detail = detailFor(state);
    content_ = contentOf(state, frame);
    return frame;
}

field::Detail* Pipeline::detailFor(const State& state) const {
    return state.sculpture->isRough() ? nullptr : detail_;
}

PictureContent Pipeline::contentOf(const State& state, const render::Frame& frame) const {
    const View& view = *state.view;
    PictureContent content;
    content.view = viewOfPicture(view);
    content.fieldSerial = field_->serial;
    content.functionVersion = frame.classification != nullptr ? frame.classification->version() : 0;
    content.sculptureVersion = state.sculpture->version();
    content.isRough = state.sculpture->isRough();
    content.showsUncut =
        frame.scene.sculpture == nullptr && view.sculptureView == field::SculptureView::Probe;
    content.isCutAlongSegments = frame.scene.isCutAlongSegments;
    content.marks = state.marks;
    content.filled = state.filled;
    content.isLocal = frame.pasted.empty() && frame.pulled.empty() && frame.occlusion == nullptr;
    content.segments.making = segmentationsMade_;
    if (frame.scene.segmentation != nullptr) {
        content.segments = {true,
                            segmentationsMade_,
                            segmentation_->version(),
                            segmentation_->looks(),
                            frame.segmentColours,
                            frame.scene.segmentLabels != nullptr,
                            frame.scene.hasFinerSegments ? segmentsLaid_.version : 0};
    }
    return content;
}

std::optional<Box3> Pipeline::changedSince(const State& state, const PictureContent& before) const {
    const auto box =
        changedBetween(before, content_, *state.sculpture, segmentation_ ? &*segmentation_ : nullptr);
    const std::uint64_t laid = before.segments.finerVersion;
    if (!box || laid == content_.segments.finerVersion) {
        return box;
    }
    const auto finer =
        laid > 0 && content_.segments.finerVersion > 0 ? finerSegmentsSince(laid) : std::nullopt;
    return finer ? std::optional(unite(*box, *finer)) : std::nullopt;
}

std::vector<const SegmentInfo*> Pipeline::pulledOut(const State& state) {
    std::vector<const SegmentInfo*> found;
    if (state.growth != nullptr) {
        for (const SegmentInfo& segment : state.segments->segments) {
            if (segment.isSeenPulledOut()) {
                found.push_back(&segment);
            }
        }
    }
    return found;
}

std::vector<std::uint8_t> Pipeline::apartFromOthers(const State& state) {
    std::vector<std::uint8_t> labels;
    for (const SegmentInfo* segment : pulledOut(state)) {
        if (state.growth->hasOthers()) {
            labels.push_back(segment->label);
        }
    }
    return labels;
}

void Pipeline::addPulledOut(render::Frame& frame, const field::Scene& withSegments, const State& state) {
    refreshSegmentCells(withSegments.hasFinerSegments);
    for (const SegmentInfo* segment : pulledOut(state)) {
        if (state.growth->voxelCount(segment->label) == 0) {
            continue;
        }
        render::PulledSegment pulled;
        pulled.place = shownPlace(*state.view, *segment, field_->geometry);
        pulled.label = usesLabels(state) ? segment->label : 1;
        pulled.isTranslucent = segment->opacity < 1;
        pulled.scene = withSegments;
        if (const segment::ApartTiles* apart = segmentation_->apart()) {
            pulled.scene.apartTiles = &apart->texels();
            pulled.scene.apartPages = &apart->pages(segment->label);
        }
        pulled.macrocells = &segmentCells_.macrocells;
        frame.pulled.push_back(pulled);
    }
}

Pipeline::PartStages& Pipeline::stagesOf(const gl::Texture* texels) {
    for (const auto& stages : partStages_) {
        if (stages->texels == texels) {
            return *stages;
        }
    }
    partStages_.push_back(std::make_unique<PartStages>());
    partStages_.back()->texels = texels;
    return *partStages_.back();
}

const segment::Segmentation* Pipeline::segmentsOfParts(const State& state, const render::Frame& frame) {
    const segment::Fence fence = Pipeline::fence(state, field::SculptureView::Probe);
    const bool isDrawn = frame.scene.segmentation != nullptr;
    if (!isDrawn || frame.scene.view == field::SculptureView::Probe ||
        !segment::Continuation::isNeeded(*state.growth, fence)) {
        partSegmentation_.reset();
        return segmentation_ ? &*segmentation_ : nullptr;
    }
    if (!partSegmentation_) {
        partSegmentation_.emplace(field_->geometry);
    }
    partSegmentation_->update(*state.growth, state.smoothing, looksOf(*state.segments), state.segmentsMs,
                              fence);
    isBehind_ = isBehind_ || partSegmentation_->isBehind();
    return &*partSegmentation_;
}

void Pipeline::addParts(render::Frame& frame, Key key, const State& state) {
    key.fill = nullptr; // parts are of the scan alone
    key.fillSerial = 0;
    key.materials.clear();
    const View& view = *state.view;
    const auto parts =
        pastedParts_.parts(*state.sculpture, *state.trimmed, *state.pasted, view.pasted.size());
    const auto places = shownPlaces(view, *state.pasted, field_->geometry);
    std::erase_if(partStages_, [&](const auto& stages) {
        return std::none_of(parts.begin(), parts.end(),
                            [&](const auto& part) { return part.texels == stages->texels; });
    });
    key.view = field::SculptureView::Probe;
    const segment::Segmentation* segmentation = segmentsOfParts(state, frame);
    key.segmentationVersion = key.drawsSegmentation ? segmentation->version() : 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i < state.pasted->parts.size() && !state.pasted->parts[i].isVisible) {
            continue;
        }
        PartStages& stages = stagesOf(parts[i].texels);
        key.part = parts[i].texels;
        key.partMaking = parts[i].making;
        refresh(stages.cells, key, state, frame, parts[i].cells, segmentation);
        render::PastedPart part{places[i], parts[i].texels, &stages.cells.macrocells};
        field::Scene scene = frame.scene;
        scene.fill = nullptr;
        scene.sculpture = part.sculpture;
        if (key.drawsSegmentation) {
            scene.segmentation = part.segmentation = &segmentation->texels();
        }
        if (view.shadows) {
            refresh(stages.light, key, state, scene, frame, stages.cells.macrocells);
            part.occlusion = &stages.light.occlusion;
        }
        frame.pasted.push_back(part);
    }
}

PastedParts::Part Pipeline::partAt(const State& state, std::size_t place) {
    return pastedParts_.parts(*state.sculpture, *state.trimmed, *state.pasted, state.view->pasted.size())
        .at(place);
}

std::vector<glm::vec2> Pipeline::cellsOfNextPart(const State& state, bool takesTrimmed) {
    PastedPart next = state.pasted->next();
    next.takesTrimmed = takesTrimmed;
    return pastedParts_.cellsOf(next, *state.sculpture, *state.trimmed);
}

} // namespace vs::studio
