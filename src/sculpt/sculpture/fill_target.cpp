// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/fill_target.h"

#include "base/progress.h"

namespace vs::sculpt {

FillWindow::Energies FillWindow::take(const Box3& box, const Limits& limits, const CutTarget::Work& work) {
    sculpture_.moveTo(box.lo);
    Limits own;
    if (limits.memberships != nullptr) {
        const gl::Texture& all = *limits.memberships;
        if (!memberships_ || memberships_.format() != all.format()) {
            memberships_ =
                gl::Texture(glm::ivec3(kSide), all.format(), gl::Filter::Nearest, "limits of filling");
        }
        memberships_.copyFrom(all, box, glm::ivec3(0));
        own = {&memberships_, limits.takesOnly};
    }
    sculpture_.limitTo(own);
    sculpture_.texels().clear({glm::ivec3(0), box.size()}); // what was left there before
    Energies energies;
    energies.box = intersect(work({&sculpture_, box, nullptr}), box);
    if (!energies.box.isEmpty()) {
        energies.values = sculpture_.values({energies.box.lo - box.lo, energies.box.hi - box.lo});
    }
    return energies;
}

Box3 FillTarget::cutIn(const Box3& box, const Work& work, const Reaches& reaches) {
    const Box3 grid{glm::ivec3(0), fill_->dims()};
    // What is not filled cannot be taken away.
    Box3 all = intersect(material_ == 0 ? intersect(fill_->filledWithin(box), box) : box, grid);
    if (all.isEmpty()) {
        return {};
    }
    constexpr int brick = field::kFillBrick;
    all = intersect({all.lo / brick * brick, divideUp(all.hi, brick) * brick}, grid);
    constexpr int side = FillWindow::kSide;
    if (glm::all(glm::lessThanEqual(all.size(), glm::ivec3(side)))) {
        return cutInWindow(all, work);
    }
    Box3 changed;
    const Box3 cells{all.lo / side, (all.hi - 1) / side + 1};
    forEachVoxel(cells, [&](glm::ivec3 cell, std::size_t n) {
        reportProgress(double(n) / double(cells.volume()));
        const Box3 part = intersect(all, {cell * side, (cell + 1) * side});
        const bool isWanted = material_ != 0 || !fill_->filledWithin(part).isEmpty();
        if (isWanted && (!reaches || reaches(part))) {
            changed = unite(changed, cutInWindow(part, work));
        }
    });
    return changed;
}

Box3 FillTarget::cutInWindow(const Box3& box, const Work& work) {
    const FillWindow::Energies energies = window_.take(box, limits_, work);
    if (!energies.box.isEmpty()) {
        fill_ = std::make_shared<const field::Fill>(
            material_ != 0 ? field::filledBy(*fill_, energies.box, energies.values, material_)
                           : field::takenBy(*fill_, energies.box, energies.values));
    }
    return energies.box;
}

} // namespace vs::sculpt
