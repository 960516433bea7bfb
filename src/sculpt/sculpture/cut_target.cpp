// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/cut_target.h"

#include "base/check.h"
#include "base/progress.h"
#include "field/field.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

// A box that begins and ends with bricks, or with the grid.
Box3 toBricks(const Box3& box, glm::ivec3 dims) {
    const Box3 part = intersect(box, {glm::ivec3(0), dims});
    if (part.isEmpty()) {
        return {};
    }
    return {part.lo / kFineBrick * kFineBrick, glm::min(divideUp(part.hi, kFineBrick) * kFineBrick, dims)};
}

} // namespace

Sculpture& FineWindow::look(const FineSculpture& fine, const Box3& box, const Limits& limits) {
    const bool isThere = version_ == fine.version() && intersect(shown_, box) == box;
    if (!isThere) {
        sculpture_.moveTo(box.lo);
        sculpture_.texels().upload({glm::ivec3(0), box.size()}, fine.texels(box));
        shown_ = box;
        version_ = fine.version();
    }
    sculpture_.limitTo(limitsIn(shown_, limits));
    return sculpture_;
}

Limits FineWindow::limitsIn(const Box3& box, const Limits& limits) {
    if (limits.finest == nullptr) {
        VS_CHECK(limits.memberships == nullptr);
        return {};
    }
    if (limited_.lock() != limits.finest || limitedBox_ != box) {
        limited_.reset();
        if (!memberships_) {
            memberships_ = gl::Texture(glm::ivec3(kSide), gl::Format::RG8, gl::Filter::Nearest,
                                       "limits at the finest level");
        }
        const Box3 texels{glm::ivec3(0), box.size()};
        const std::vector<std::byte> bytes = (*limits.finest)(box);
        if (bytes.empty()) {
            memberships_.clear(texels);
        } else {
            memberships_.upload(texels, bytes);
        }
        limited_ = limits.finest;
        limitedBox_ = box;
    }
    return {&memberships_, limits.takesOnly};
}

std::vector<std::byte> FineWindow::texels(const Box3& box) const {
    return sculpture_.download({box.lo - sculpture_.origin(), box.hi - sculpture_.origin()});
}

Box3 FineTarget::cutIn(const Box3& box, const Work& work, const Reaches& reaches) {
    const Box3 all = toBricks(box, fine_.dims());
    if (all.isEmpty()) {
        return {};
    }
    constexpr int side = FineWindow::kSide;
    Box3 changed;
    if (glm::all(glm::lessThanEqual(all.size(), glm::ivec3(side)))) {
        changed = cutInWindow(all, work);
    } else {
        const Box3 cells{all.lo / side, (all.hi - 1) / side + 1};
        forEachVoxel(cells, [&](glm::ivec3 cell, std::size_t n) {
            reportProgress(double(n) / double(cells.volume()));
            const Box3 part = intersect(all, {cell * side, (cell + 1) * side});
            if (!reaches || reaches(part)) {
                changed = unite(changed, cutInWindow(part, work));
            }
        });
    }
    derived_.derive(changed, backup_);
    return changed;
}

// Half of what was cut is taken back by whoever holds the originals, if something is thrown.
Box3 FineTarget::cutInWindow(const Box3& box, const Work& work) {
    Sculpture& window = window_.look(fine_, box, derived_.limits());
    window_.disagrees();
    const Box3 changed = toBricks(intersect(work({&window, box, nullptr}), box), fine_.dims());
    if (!changed.isEmpty()) {
        fine_.put(changed, window_.texels(changed), originals_);
    }
    window_.agrees(fine_);
    return changed;
}

bool FineTarget::fill(const Box3& brick, Combine how) {
    const Allowed allowed = allowedAtFinest(derived_.limits(), brick);
    if (allowed == Allowed::Some) {
        return false;
    }
    if (allowed == Allowed::All && fine_.fill(brick.lo / kFineBrick, how == Combine::Cut, originals_)) {
        filled_ = unite(filled_, brick);
    }
    return true;
}

void FineTarget::finish() {
    derived_.derive(filled_, backup_);
    filled_ = {};
}

} // namespace vs::sculpt
