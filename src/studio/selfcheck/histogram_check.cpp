// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "field/histogram.h"

namespace vs::studio {

namespace {

// A prime number, which the values' range is no multiple of: no whole number lies at the border of two bins.
constexpr int kHistogramBins = 37;
constexpr int kHistogramMost = 120;

// Counts the voxels of a volume whose `isCounted` says so.
template <typename IsCounted>
std::vector<std::uint32_t> counted(const volume::Volume& volume, const IsCounted& isCounted) {
    std::vector<std::uint32_t> counts(kHistogramBins);
    forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
        const int bin = int(volume.at(v) * kHistogramBins / kHistogramMost);
        counts[std::size_t(std::min(bin, kHistogramBins - 1))] += isCounted(n) ? 1U : 0U;
    });
    return counts;
}

void compareCounts(Tally& tally, const std::vector<std::uint32_t>& found,
                   const std::vector<std::uint32_t>& expected) {
    tally.compareAll(std::span<const std::uint32_t>(found), std::span<const std::uint32_t>(expected));
}

// What a cut leaves of a volume and what it takes away; one in seven of the sculpture's voxels is at 0.5.
void checkVisibleCounts(Tally& tally, const volume::Volume& volume, const field::Field& field) {
    std::vector<float> cut(volume.geometry.voxelCount());
    for (std::size_t n = 0; n < cut.size(); ++n) {
        cut[n] = float(n % 7) / 6;
    }
    gl::Texture sculpture(volume.geometry.dims, gl::Format::R32F, gl::Filter::Nearest, "self check cut");
    sculpture.upload(volume.geometry.box(), std::as_bytes(std::span(cut)));
    field::VisibleHistogram counting(field, kHistogramBins);
    for (const auto view : {field::SculptureView::Cut, field::SculptureView::Probe}) {
        counting.start(view);
        while (!counting.advance(sculpture, 0)) {
        }
        const bool isCut = view == field::SculptureView::Cut;
        tally.about(isCut ? "counts of what a cut leaves" : "counts of what a cut takes away");
        compareCounts(tally, counting.counts(),
                      counted(volume, [&](std::size_t n) { return (cut[n] < 0.5F) == isCut; }));
    }
}

} // namespace

void checkHistograms(Tally& tally) {
    for (const auto type : volume::kScalarTypes) {
        const auto volume = makeNoise({37, 21, 19}, type, 0, kHistogramMost);
        const auto field = field::uploadVolume(volume);
        tally.about(std::string("counts of ") + name(type));
        compareCounts(tally, field::intensityHistogram(field, kHistogramBins),
                      counted(volume, [](std::size_t) { return true; }));
        if (type == volume::ScalarType::UInt8 || type == volume::ScalarType::Float32) {
            checkVisibleCounts(tally, volume, field);
        }
    }
}

} // namespace vs::studio
