// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/segment_measures.h"

#include "studio/document/document.h"
#include "studio/state/region.h"

#include <algorithm>

namespace vs::studio {

namespace {

// The grid of a box of another one.
volume::GridGeometry part(const volume::GridGeometry& grid, const Box3& box) {
    volume::GridGeometry of = grid;
    of.dims = box.size();
    of.worldFromVoxel[3] = grid.worldFromVoxel * glm::dvec4(glm::dvec3(box.lo), 1.0);
    return of;
}

} // namespace

SegmentMeasures::SegmentMeasures(const Document& document)
    : volume_(document.volume()), geometry_(document.volume().geometry),
      labels_(document.region().labelMap()) {
    const Region& region = document.region();
    if (const segment::FineGrowth* grown = region.finest()) {
        finest_ = {document.levels(), region.geometry(), grown->labelReader(), {}};
        for (const SegmentInfo& info : document.segments().segments) {
            const std::size_t voxels = region.voxelCount(info.label);
            if (voxels > 0) {
                finest_->segments.push_back({info.label, grown->boxOf(info.label), voxels});
            }
        }
        std::sort(finest_->segments.begin(), finest_->segments.end(),
                  [](const auto& a, const auto& b) { return a.label < b.label; });
    }
}

std::optional<segment::SegmentStatistics> SegmentMeasures::measured(const Finest::Segment& segment,
                                                                    std::size_t mostBytes) const {
    const volume::ScalarType type = finest_->source->type();
    if (segment.box.volume() > mostBytes / (volume::sizeOf(type) + 1)) {
        return {};
    }
    volume::Volume around;
    around.geometry = part(finest_->geometry, segment.box);
    around.type = type;
    around.bytes = finest_->source->read(0, segment.box);
    volume::computeRange(around);
    auto labels = finest_->labels(segment.box);
    std::replace_if(
        labels.begin(), labels.end(), [&](std::uint8_t label) { return label != segment.label; },
        std::uint8_t(0));
    auto figures = segment::measure(around, labels);
    if (figures.empty()) {
        return {};
    }
    figures.front().box = {figures.front().box.lo + segment.box.lo, figures.front().box.hi + segment.box.lo};
    return figures.front();
}

std::vector<segment::SegmentStatistics> SegmentMeasures::all(std::size_t mostBytes) const {
    if (!finest_) {
        return segment::measure(volume_, geometry_, labels_);
    }
    std::vector<segment::SegmentStatistics> figures;
    std::optional<std::vector<segment::SegmentStatistics>> ofScene; // where some segment needs it
    for (const Finest::Segment& segment : finest_->segments) {
        if (const auto one = measured(segment, mostBytes)) {
            figures.push_back(*one);
            continue;
        }
        if (!ofScene) {
            ofScene = segment::measure(volume_, geometry_, labels_);
        }
        const auto coarse = std::find_if(ofScene->begin(), ofScene->end(),
                                         [&](const auto& one) { return one.label == segment.label; });
        if (coarse != ofScene->end()) {
            coarse->voxels = segment.voxels;
            coarse->millilitres = double(segment.voxels) * finest_->geometry.voxelMm3() / 1000;
            figures.push_back(*coarse);
        }
    }
    return figures;
}

} // namespace vs::studio
