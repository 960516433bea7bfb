// SPDX-License-Identifier: Apache-2.0
#include "base/timer.h"
#include "studio/document/part_queries.h"
#include "studio/exports/exports.h"
#include "studio/state/region.h"

#include <algorithm>

namespace vs::studio {

namespace {
constexpr std::size_t kVoxelsAtOnce = 1 << 21; // of a sculpture: about 10 ms of downloading
} // namespace

std::vector<ExportedSegment> exportable(const Document& document) {
    std::vector<ExportedSegment> found;
    for (const SegmentInfo& info : document.segments().segments) {
        if (document.region().voxelCount(info.label) > 0) {
            found.push_back({info.label, info.label, info.name, info.colour, info.opacity});
        }
    }
    return found;
}

ExportReader::ExportReader(Document& document, ExportSettings::What what,
                           std::vector<ExportedSegment> segments)
    : document_(document) {
    source_.volume = &document.volume();
    source_.geometry = document.volume().geometry;
    source_.isCorrected = source_.geometry != document.geometryInFile();
    source_.segments = std::move(segments);
    source_.marks = document.marks();
    source_.view = document.view().sculptureView;
    needsLabels_ = what == ExportSettings::What::Segments;
    if (what == ExportSettings::What::Volume) {
        const bool isCut = !document.sculpture().isEmpty();
        const auto parts = isCut ? document.parts().seen() : std::vector<SeenPart>{};
        for (const SeenPart& part : parts) {
            source_.parts.push_back({{}, part.place, part.name});
            places_.push_back(part.at);
        }
        sculptures_ = isCut ? 1 + parts.size() : 0;
        if (const sculpt::FineSculpture* finer = document.sculpture().finer()) {
            source_.finest = {document.levels(), finer->reader(), finer->emptyBoxes(),
                              field::finerGeometry(source_.geometry, finer->grid())};
        }
    }
}

std::vector<std::uint16_t>& ExportReader::sculptureInHand() {
    return at_ == 0 ? source_.sculpture : source_.parts[at_ - 1].sculpture;
}

void ExportReader::readSlab() {
    const glm::ivec3 dims = source_.geometry.dims;
    const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
    const int to = std::min(dims.z, slice_ + int(std::max<std::size_t>(kVoxelsAtOnce / slice, 1)));
    const Box3 slab{{0, 0, slice_}, {dims.x, dims.y, to}};
    const auto values =
        at_ == 0 ? document_.sculpture().values(slab) : document_.parts().values(places_[at_ - 1], slab);
    auto& sculpture = sculptureInHand();
    sculpture.reserve(source_.geometry.voxelCount());
    std::transform(values.begin(), values.end(), std::back_inserter(sculpture), mesh::packed);
    slice_ = to;
    if (slice_ == dims.z) {
        slice_ = 0;
        ++at_;
    }
}

bool ExportReader::readSome(double budgetMs) {
    const Timer timer;
    if (needsLabels_) {
        source_.labels = document_.region().labelMap();
        if (const segment::FineGrowth* finest = document_.region().finest()) {
            source_.finestLabels = {finest->labelReader(), finest->emptyBoxes(),
                                    document_.region().geometry()};
            source_.finestMeasures = std::make_shared<const SegmentMeasures>(document_);
        }
        needsLabels_ = false;
    }
    for (bool isFirst = true; at_ < sculptures_ && (isFirst || timer.milliseconds() < budgetMs);
         isFirst = false) {
        readSlab();
    }
    return at_ >= sculptures_;
}

double ExportReader::share() const {
    return sculptures_ == 0 ? 1
                            : (double(at_) + double(slice_) / source_.geometry.dims.z) / double(sculptures_);
}

} // namespace vs::studio
