// SPDX-License-Identifier: Apache-2.0
#include "studio/region.h"

#include "base/error.h"

namespace vs::studio {

segment::Growth& Region::madeGrowth() {
    if (!growth_) {
        growth_ = std::make_unique<segment::Growth>(*field_);
    }
    return *growth_;
}

segment::Constraints Region::constraints(const Range& range, field::SculptureView view,
                                         segment::Connectivity connectivity) const {
    segment::Constraints constraints;
    constraints.range = range;
    constraints.connectivity = connectivity;
    if (!sculpture_->isEmpty() && view != field::SculptureView::Whole) {
        constraints.sculpture = &sculpture_->texels();
        constraints.sculptureVersion = sculpture_->contentVersion();
        constraints.view = view;
    }
    return constraints;
}

std::vector<glm::ivec3> Region::findSeeds(const field::SurfacePoints& points,
                                          const segment::Constraints& constraints) {
    return finder_.find(points, *field_, constraints);
}

segment::SeedCounts Region::seed(const std::vector<glm::ivec3>& voxels,
                                 const segment::Constraints& constraints, Records& records) {
    segment::Growth& growth = madeGrowth();
    growth.setConstraints(constraints, &records.emplace_back());
    return growth.addSeeds(voxels, &records.emplace_back());
}

void Region::refreshFence(field::SculptureView view, Records& records) {
    const auto& now = growth_->constraints();
    growth_->setConstraints(constraints(now.range, view, now.connectivity), &records.emplace_back());
}

int Region::grow(int generations, field::SculptureView view, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to grow from: draw seeds first");
    }
    refreshFence(view, records);
    return growth_->advance(generations, &records.emplace_back());
}

int Region::rewind(int generations, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to rewind: no region has been grown");
    }
    return growth_->stepBack(generations, &records.emplace_back());
}

void Region::setRange(const Range& range, Records& records) {
    if (!hasSeeds()) {
        throw Error("no region to change the range of: draw seeds first");
    }
    segment::Constraints changed = growth_->constraints();
    changed.range = range;
    growth_->setConstraints(changed, &records.emplace_back());
}

void Region::clear(Records& records) {
    if (growth_) {
        growth_->reset(&records.emplace_back());
    }
}

void Region::undo(const Records& records) {
    for (auto record = records.rbegin(); record != records.rend(); ++record) {
        record->undo(*growth_);
    }
}

void Region::beginLive(field::SculptureView view, Records& records) { grow(0, view, records); }

int Region::growFor(double budgetMs, int maxGenerations) {
    return growth_->advanceFor(budgetMs, maxGenerations);
}

void Region::endLive(Records& records) { records.back().continueTo(*growth_); }

} // namespace vs::studio
