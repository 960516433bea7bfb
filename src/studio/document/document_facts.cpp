// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_facts.h"

#include "segment/growth/leaks.h"
#include "studio/editing/contents.h"

#include <algorithm>
#include <iterator>

namespace vs::studio {

namespace {

std::shared_ptr<const Edits> editsOf(const History& history) {
    auto edits = std::make_shared<Edits>();
    const auto operation = [](const Edit& edit) { return edit.operation; };
    std::transform(history.done().begin(), history.done().end(), std::back_inserter(edits->operations),
                   operation);
    std::transform(history.undone().rbegin(), history.undone().rend(), std::back_inserter(edits->operations),
                   operation);
    edits->done = history.done().size();
    edits->statistics = history.statistics();
    edits->revision = history.revision();
    return edits;
}

// The last generation that did not come from the one before it alone.
int begunAt(const segment::GrowthState& state) {
    int begun = state.frozen;
    for (const segment::Seed& seed : *state.seeds) {
        begun = std::max(begun, std::min(seed.generation, state.extent));
    }
    return begun;
}

GrowthStatus statusOf(const Contents& contents) {
    GrowthStatus status;
    if (const segment::Growth* growth = contents.region.growth()) {
        status.generation = growth->playhead();
        status.extent = growth->extent();
        status.voxels = std::size_t(growth->voxelCount());
        status.millilitres = double(status.voxels) * contents.region.geometry().voxelMm3() / 1000;
        status.range = growth->constraints().range;
        status.hasSeeds = contents.region.hasSeeds();
        status.leaks = segment::leaks(growth->state().voxels, begunAt(growth->state()));
    }
    return status;
}

std::shared_ptr<const std::vector<Measured>> measuredIn(const Contents& contents,
                                                        const DocumentFacts& before) {
    const bool isSameGrid = before.geometry == contents.scan.volume.geometry;
    return std::make_shared<const std::vector<Measured>>(
        allMeasured(*contents.measurements, contents.scan.volume,
                    isSameGrid ? std::span<const Measured>(*before.measured) : std::span<const Measured>()));
}

GrowthRules rulesOf(const Region& region) {
    const segment::Constraints& rules = region.rules();
    GrowthRules result{rules.range, rules.difference, rules.gradient, rules.gradientDifference};
    result.connectivity = rules.connectivity == segment::Connectivity::TwentySix ? 26 : 6;
    result.isLive = region.exists() && region.growth()->state().isLive;
    return result;
}

} // namespace

std::shared_ptr<const DocumentFacts> factsOf(const Contents& contents, std::size_t logged,
                                             const DocumentFacts& before) {
    auto facts = std::make_shared<DocumentFacts>();
    facts->version = contents.version;
    facts->logged = logged;
    facts->inHand = contents.inHand;
    facts->geometry = contents.scan.volume.geometry;
    facts->finestDims =
        contents.scan.detail != nullptr ? contents.scan.detail->grids().front().dims : glm::ivec3(0);
    facts->view = contents.view;
    facts->firstLook = contents.scan.firstLook;
    facts->sliceWindow = contents.scan.slices;
    facts->edits =
        before.edits->revision == contents.history.revision() ? before.edits : editsOf(contents.history);
    facts->measurements = contents.measurements;
    facts->hasMarks = !contents.marks->isEmpty();
    facts->hasFill = !contents.filled.fill->isEmpty();
    facts->materials = contents.filled.materials;
    const bool isMeasured =
        before.measurements == contents.measurements && before.geometry == contents.scan.volume.geometry;
    facts->measured = isMeasured ? before.measured : measuredIn(contents, before);
    facts->parts.assign(contents.pasted.parts.begin(), contents.pasted.parts.end());
    facts->segments = contents.segments;
    for (const SegmentInfo& segment : contents.segments.segments) {
        facts->voxels[segment.label] = contents.region.voxelCount(segment.label);
    }
    facts->segmentVoxelMm3 = contents.region.geometry().voxelMm3();
    facts->segmentsRevision = contents.region.revision();
    facts->growth = statusOf(contents);
    facts->rules = rulesOf(contents.region);
    return facts;
}

} // namespace vs::studio
