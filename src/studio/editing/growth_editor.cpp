// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/growth_editor.h"

#include "base/error.h"
#include "studio/editing/segment_change.h"
#include "studio/operations/sketch.h"
#include "studio/operations/trail.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace vs::studio {

namespace {

// In the order of a grid's voxels, which found ones have.
bool isBefore(glm::ivec3 a, glm::ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); }

// The voxels of a set, after those there are.
void addTo(std::vector<glm::ivec3>& voxels, const segment::VoxelSet& set) {
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        if (set.inside[i] != 0) {
            voxels.push_back(set.voxelAt(i));
        }
    }
}

// How far from a segment's voxels, in voxels, what is seen of its surface may lie: it is smooth.
constexpr int kSurfaceReach = 2;

// The voxels of the set that are nearest to the given ones, each once; nothing for those that are farther
// away than the set's surface is.
std::vector<glm::ivec3> nearestOf(const segment::VoxelSet& set, const std::vector<glm::ivec3>& voxels,
                                  const volume::GridGeometry& geometry) {
    const glm::dmat3 millimetres(geometry.worldFromVoxel);
    std::vector<glm::ivec3> nearest;
    for (const glm::ivec3 voxel : voxels) {
        double least = std::numeric_limits<double>::infinity();
        glm::ivec3 found{0};
        forEachVoxel({voxel - kSurfaceReach, voxel + kSurfaceReach + 1}, [&](glm::ivec3 other, std::size_t) {
            const double distance = glm::length(millimetres * glm::dvec3(other - voxel));
            if (distance < least && set.contains(other)) {
                least = distance;
                found = other;
            }
        });
        if (std::isfinite(least)) {
            nearest.push_back(found);
        }
    }
    std::sort(nearest.begin(), nearest.end(), isBefore);
    nearest.erase(std::unique(nearest.begin(), nearest.end()), nearest.end());
    return nearest;
}

// Where no level is finer than the one that is worked on, and the operation has none of its voxels.
template <typename Op>
void requireVoxels(const Op& op) {
    bool isDrawn = !op.strokes.empty();
    if constexpr (requires { op.trails; }) {
        isDrawn = isDrawn || !op.trails.empty();
    }
    if (!op.finest.empty() && !isDrawn) {
        throw Error(
            "its voxels are those of a finer level, and none is finer than the one that is worked on; "
            "give `voxels`");
    }
}

} // namespace

std::vector<glm::ivec3> GrowthEditor::voxelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                                  const Canvas& canvas,
                                                  const segment::Constraints& constraints, bool isOfFinest) {
    // Piece by piece, so that a stroke over all of a large window takes no more room, and none that a
    // processor's cache has not: to fill fresh memory costs more than to look for points.
    constexpr std::size_t kMostAtOnce = std::size_t(1) << 17;
    const auto pixels = pixelsUnder(strokes, widthPixels, canvas.viewport);
    const render::Frame frame = display_.frame(canvas.view, canvas.viewport);
    std::vector<glm::ivec3> voxels;
    for (std::size_t done = 0; done < pixels.size(); done += kMostAtOnce) {
        const auto some = std::span(pixels).subspan(done, std::min(kMostAtOnce, pixels.size() - done));
        const auto points = cutter_.picker.pick(frame, some, render::Picker::Meets::Brightest);
        const auto found = isOfFinest ? contents_.region.findFinestSeeds(points, constraints)
                                      : contents_.region.findSeeds(points, constraints);
        std::vector<glm::ivec3> both;
        std::set_union(voxels.begin(), voxels.end(), found.begin(), found.end(), std::back_inserter(both),
                       isBefore);
        voxels = std::move(both);
    }
    return voxels;
}

segment::SeedCounts GrowthEditor::perform(const Seed& op, Region::Records& records) {
    workUnlocked(contents_, records);
    return contents_.region.seed(op.voxels, op.finest,
                                 contents_.region.constraints(*op.range, op.canvas->view.sculptureView,
                                                              connectivityOf(op.connectivity)),
                                 records);
}

void GrowthEditor::prepare() {
    contents_.region.prepare();
    display_.prepareSegments();
}

void GrowthEditor::giveBack() {
    contents_.region.giveBack();
    if (!contents_.region.exists()) {
        display_.forgetSegments();
    }
}

Outcome GrowthEditor::run(Seed& op) {
    contents_.fillIn(op.canvas);
    if (!op.range) {
        op.range = op.canvas->view.visibleRange(contents_.scan.volume.range);
    }
    const bool isFiner = contents_.region.isFiner();
    if (op.voxels.empty() && !(isFiner && !op.finest.empty())) {
        if (!op.strokes.empty()) {
            auto found = voxelsUnder(op.strokes, op.widthPixels, *op.canvas,
                                     contents_.region.constraints(*op.range, op.canvas->view.sculptureView,
                                                                  connectivityOf(op.connectivity)),
                                     isFiner);
            (isFiner ? op.finest : op.voxels) = std::move(found);
        }
        for (const Trail& trail : op.trails) {
            addTo(op.voxels, voxelsAlong(trail, contents_.scan.volume, op.range));
        }
        if (isFiner && !op.finest.empty()) { // trails are of the scene's voxels
            const auto widened = contents_.region.finestIn(op.voxels);
            op.finest.insert(op.finest.end(), widened.begin(), widened.end());
            op.voxels.clear(); // or strokes would not be looked under again where only the scene is grown in
        }
    }
    if (op.voxels.empty() && !(isFiner && !op.finest.empty())) {
        requireVoxels(op);
        return {{}, 0, 0, say(VS_TEXT("library", "nothing seeded: no voxel in range lies under the stroke"))};
    }
    const segment::SeedCounts counts = changeSegments(contents_, *this, op);
    return {{},
            0,
            std::size_t(counts.added),
            counts.refused > 0
                ? say(VS_TEXT("library", "%1 voxels seeded, %2 refused (outside the grid or the range, cut "
                                         "away, or another segment's)"),
                      counts.added, counts.refused)
                : say(VS_TEXT("library", "%1 voxels seeded"), counts.added)};
}

int GrowthEditor::perform(const Grow& op, Region::Records& records) {
    workUnlocked(contents_, records);
    return contents_.region.grow(op.generations.value_or(Region::kEndless), *op.sculptureView, records);
}

Outcome GrowthEditor::run(Grow& op) {
    const std::size_t before = contents_.grownVoxels();
    op.sculptureView = op.sculptureView.value_or(contents_.view.sculptureView);
    return describeGrowth(contents_, changeSegments(contents_, *this, op), before);
}

int GrowthEditor::perform(const Rewind& op, Region::Records& records) {
    workUnlocked(contents_, records);
    return contents_.region.rewind(op.generations, records);
}

Outcome GrowthEditor::run(Rewind& op) {
    const std::size_t before = contents_.grownVoxels();
    return describeGrowth(contents_, -changeSegments(contents_, *this, op), before);
}

void GrowthEditor::perform(const ShowGeneration& op, Region::Records& records) {
    workUnlocked(contents_, records);
    contents_.region.showGeneration(op.generation, records);
}

Outcome GrowthEditor::run(ShowGeneration& op) {
    const std::size_t before = contents_.grownVoxels();
    const int generation = contents_.region.exists() ? contents_.region.growth()->playhead() : 0;
    changeSegments(contents_, *this, op);
    return describeGrowth(contents_, contents_.region.growth()->playhead() - generation, before);
}

void GrowthEditor::perform(const SetGrowthRules& op, Region::Records& records) {
    workUnlocked(contents_, records);
    contents_.region.setRules(op, records);
}

Outcome GrowthEditor::run(SetGrowthRules& op) {
    const std::size_t before = contents_.grownVoxels();
    changeSegments(contents_, *this, op);
    Outcome outcome = describeGrowth(contents_, 0, before);
    const Range& range = contents_.region.rules().range;
    outcome.message = say(VS_TEXT("library", "growing in %1 to %2; %3 voxels"), fmt::format("{:g}", range.lo),
                          fmt::format("{:g}", range.hi), contents_.grownVoxels());
    return outcome;
}

int GrowthEditor::perform(const Absorb& op, Region::Records& records) {
    workUnlocked(contents_, records);
    return contents_.region.absorb(op.voxels, op.finest, op.expansions.value_or(Region::kEndless), records);
}

Outcome GrowthEditor::run(Absorb& op) {
    contents_.fillIn(op.canvas);
    if (op.voxels.empty() && !(contents_.region.isFiner() && !op.finest.empty())) {
        segment::Constraints anything; // of what is seen: only the segment's own voxels are taken
        anything.range = contents_.scan.volume.range;
        requireVoxels(op);
        op.voxels = nearestOf(contents_.region.voxelsOf(contents_.segments.atWork),
                              voxelsUnder(op.strokes, op.widthPixels, *op.canvas, anything, false),
                              contents_.scan.volume.geometry);
        if (contents_.region.isFiner()) { // those are what it is about on any level
            op.finest = contents_.region.finestIn(op.voxels);
        }
    }
    const std::size_t before = contents_.grownVoxels();
    const int expansions = changeSegments(contents_, *this, op);
    const std::size_t taken = before - contents_.grownVoxels();
    return {{},
            0,
            taken,
            taken == 0 ? say(VS_TEXT("library", "nothing absorbed: the stroke does not lie on the segment"))
                       : say(VS_TEXT("library", "%1 voxels absorbed in %2 expansions"), taken, expansions)};
}

void GrowthEditor::perform(const ReSeed&, Region::Records& records) {
    for (const SegmentInfo& segment : contents_.segments.segments) {
        if (!segment.isLocked) {
            contents_.region.workOn(segment.label, records);
            contents_.region.clear(records);
        }
    }
    contents_.region.workOn(contents_.segments.atWork, records);
}

Outcome GrowthEditor::run(ReSeed& op) {
    const std::size_t before = contents_.grownVoxels();
    changeSegments(contents_, *this, op);
    return {{}, 0, before - contents_.grownVoxels(), say(VS_TEXT("library", "segmentation cleared"))};
}

} // namespace vs::studio
