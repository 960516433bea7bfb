// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/continuation.h"

#include "field/cell_ranges.h"
#include "gl/pass.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <limits>

namespace vs::segment {

namespace {

constexpr std::size_t kLabels = 256;
constexpr int kContinuationReach = 6; // voxels from a hidden one to the farthest that it goes by
constexpr double kFarthestAside = 3;

// Mirrors shaders/continue_segments.comp.
enum FencedTo : std::uint32_t { Nothing, Visible, Hidden };

FencedTo fencedTo(const Constraints& constraints, field::SculptureView view) {
    if (!constraints.hasFence() || view == field::SculptureView::Whole) {
        return Nothing;
    }
    return constraints.view == view ? Visible : Hidden;
}

// The ends rounded to float; nothing given: all there are.
glm::vec2 ends(const std::optional<Range>& range) {
    constexpr float all = std::numeric_limits<float>::max();
    return range ? glm::vec2(float(range->lo), float(range->hi)) : glm::vec2(-all, all);
}

field::SculptureView shownBy(const Fence& fence) {
    return fence.sculpture != nullptr ? fence.view : field::SculptureView::Whole;
}

void bindFence(gl::Program& program, const Fence& fence) {
    if (fence.sculpture != nullptr) {
        fence.sculpture->bindTexture(kSculptureTexture);
        fence.cells->bindTexture(kSculptureCellsTexture);
    }
    const field::SculptureView view = shownBy(fence);
    program.set("hides", view == field::SculptureView::Cut ? 1 : view == field::SculptureView::Probe ? 2 : 0);
}

bool touches(const Box3& a, const Box3& b) { return !intersect(a, b).isEmpty(); }

} // namespace

Continuation::Continuation(glm::ivec3 dims)
    : isFenced_(BrickTable(dims).count(), false), rulesOnDevice_(kLabels * sizeof(Rules), "rules of labels"),
      list_(4, "continued bricks"), answers_(4, "fence answers"),
      findFences_("segment/shaders/find_fences.comp") {}

bool Continuation::isNeeded(const Growth& growth, const Fence& fence) {
    bool isFenced = false;
    for (std::size_t label = 1; label < kLabels && !isFenced; ++label) {
        isFenced = growth.state(std::uint8_t(label)).constraints.hasFence();
    }
    return isFenced && shownBy(fence) != field::SculptureView::Whole;
}

bool Continuation::takeRules(const Growth& growth, field::SculptureView view) {
    std::vector<Rules> rules(kLabels);
    hasGradients_ = false;
    takesAway_ = false;
    for (std::size_t label = 1; label < kLabels; ++label) {
        const GrowthState& state = growth.state(std::uint8_t(label));
        const Constraints& constraints = state.constraints;
        const FencedTo fenced = fencedTo(constraints, view);
        if (fenced != Nothing) {
            rules[label] = {
                glm::vec4(comparableRange(growth.field(), constraints.range), ends(constraints.gradient)),
                glm::vec4(ends(constraints.difference), ends(constraints.gradientDifference)),
                glm::uvec4(fenced, std::uint32_t(state.frozen), 0, 0)};
        }
        hasGradients_ = hasGradients_ || constraints.gradient || constraints.gradientDifference;
        takesAway_ = takesAway_ || fenced == Hidden;
    }
    const bool isOther = rules != rules_;
    rules_ = std::move(rules);
    if (isOther) {
        rulesOnDevice_.write(std::span<const Rules>(rules_));
    }
    return isOther;
}

bool Continuation::isStale(const Fence& fence) const {
    const field::SculptureView view = shownBy(fence);
    return view != view_ || (view != field::SculptureView::Whole && fence.version != version_);
}

std::vector<std::uint32_t> Continuation::takeFence(const BrickTable& table, const Fence& fence) {
    if (!isStale(fence)) {
        return {};
    }
    const Box3 all{glm::ivec3(0), table.brickDims() * field::kBrick};
    const bool isSameView = shownBy(fence) == view_ && fence.changedSince;
    const Box3 box = isSameView ? grow(fence.changedSince(version_), kContinuationReach) : all;
    view_ = shownBy(fence);
    version_ = fence.version;
    std::vector<std::uint32_t> listed;
    for (std::uint32_t brick = 0; brick < table.count(); ++brick) {
        if (touches(grow(table.box(brick), field::kCell), box)) {
            listed.push_back(brick);
        }
    }
    if (listed.empty()) {
        return {};
    }
    list_.reserve(listed.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(listed));
    list_.bindStorage(kBricksStorage);
    answers_.reserve(listed.size() * sizeof(std::uint32_t));
    answers_.bindStorage(kAnswersStorage);
    bindFence(findFences_, fence);
    findFences_.set("brickDims", table.brickDims()).set("count", int(listed.size()));
    findFences_.dispatchOverList(listed.size(), gl::Barrier::All); // the sculpture may be cut next
    const auto answers = answers_.read<std::uint32_t>(listed.size());
    std::vector<std::uint32_t> affected;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const bool isFenced = answers[i] != 0;
        if (isFenced || isFenced_[listed[i]]) {
            affected.push_back(listed[i]);
        }
        isFenced_[listed[i]] = isFenced;
    }
    return affected;
}

std::vector<std::uint32_t> Continuation::refresh(const Growth& growth, const Fence& fence,
                                                 const std::vector<std::uint32_t>& changed, bool isAnew) {
    const BrickTable& table = growth.seedMap().bricks();
    std::vector<bool> isStale(table.count(), false);
    for (const std::uint32_t brick : takeFence(table, fence)) {
        isStale[brick] = true;
    }
    const bool everything = takeRules(growth, view_) || isAnew;
    std::vector<bool> isNearChange(table.count(), false);
    for (const std::uint32_t brick : changed) {
        const glm::ivec3 place = table.brickAt(brick);
        const glm::ivec3 lo = glm::max(place - 1, glm::ivec3(0));
        const glm::ivec3 hi = glm::min(place + 1, table.brickDims() - 1);
        for (int z = lo.z; z <= hi.z; ++z) {
            for (int y = lo.y; y <= hi.y; ++y) {
                for (int x = lo.x; x <= hi.x; ++x) {
                    isNearChange[table.brickOf(glm::ivec3(x, y, z) * field::kBrick)] = true;
                }
            }
        }
    }
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t brick = 0; brick < table.count(); ++brick) {
        if (isStale[brick] || (isFenced_[brick] && (everything || isNearChange[brick]))) {
            bricks.push_back(brick);
        }
    }
    return bricks;
}

void Continuation::run(const Growth& growth, const Fence& fence, const gl::Buffer& shown,
                       const gl::Buffer& turned, const gl::Buffer& reach,
                       const std::vector<std::uint32_t>& bricks, std::optional<std::uint8_t> alone) {
    const gl::Pass pass("continue segments");
    gl::Defines defines = growth.seedMap().widthDefines();
    if (hasGradients_) {
        defines.emplace_back("VS_GRADIENTS", "1");
    }
    if (alone) {
        defines.emplace_back("VS_ALONE", "1");
    }
    gl::Program& program = continue_.prepare(growth.field(), {}, defines);
    growth.seedMap().bind(program);
    growth.seedMap().bindOwner(program, growth.owner());
    rulesOnDevice_.bindStorage(kRulesOfLabelsStorage);
    shown.bindStorage(kShownBitsStorage);
    reach.bindStorage(kReachStorage);
    turned.bindStorage(kTurnedBitsStorage);
    list_.reserve(bricks.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(bricks));
    list_.bindStorage(kBricksStorage);
    bindFence(program, fence);
    const glm::dvec3 spacing = growth.field().geometry.spacing();
    const glm::dvec3 aside = std::max({spacing.x, spacing.y, spacing.z}) / spacing;
    program.set("takesAway", takesAway_ ? 1 : 0)
        .set("aside", glm::ivec3(glm::round(glm::min(aside, glm::dvec3(kFarthestAside)))));
    if (alone) {
        program.set("ownLabel", std::uint32_t(*alone));
    }
    constexpr int groupsPerBrick = 16;
    for (std::size_t first = 0; first < bricks.size(); first += gl::kMaxGroups) {
        program.set("firstBrick", int(first));
        program.dispatch(
            {groupsPerBrick, int(std::min<std::size_t>(gl::kMaxGroups, bricks.size() - first)), 1},
            gl::Barrier::All); // labels and sculpture, which this reads, are written as images
    }
}

} // namespace vs::segment
