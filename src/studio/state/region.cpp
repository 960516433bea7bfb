// SPDX-License-Identifier: Apache-2.0
#include "studio/state/region.h"

#include "base/error.h"

#include <new>

namespace vs::studio {

segment::Connectivity connectivityOf(int neighbours) {
    return neighbours == 26 ? segment::Connectivity::TwentySix : segment::Connectivity::Six;
}

bool Region::isUntouched() const {
    return growth_ == nullptr ||
           (!hasSeeds() && growth_->constraints() == segment::Constraints() && !growth_->state().isLive);
}

void Region::prepare() {
    if (!growth_ && (!prepared_ || preparedFor_ != field_->serial)) {
        prepared_.reset(); // there may be no room for both
        prepared_ = std::make_unique<segment::Growth>(*field_);
        preparedFor_ = field_->serial;
    }
}

segment::Growth& Region::madeGrowth() {
    if (!growth_) {
        prepare();
        growth_ = std::move(prepared_);
    }
    return *growth_;
}

segment::Constraints Region::constraints(const Range& range, field::SculptureView view,
                                         segment::Connectivity connectivity) const {
    segment::Constraints constraints = rules();
    constraints.range = range;
    constraints.connectivity = connectivity;
    constraints.sculpture = nullptr;
    constraints.sculptureVersion = 0;
    constraints.view = field::SculptureView::Whole;
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
    return growth_->takeBack(generations, &records.emplace_back());
}

void Region::showGeneration(int generation, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to show: no region has been grown");
    }
    growth_->setPlayhead(generation, &records.emplace_back());
}

void Region::scrub(int generation) { growth_->setPlayhead(generation); }

const segment::Constraints& Region::rules() const {
    static const segment::Constraints none;
    return growth_ ? growth_->constraints() : none;
}

void Region::setRules(const SetGrowthRules& rules, Records& records) {
    segment::Growth& growth = madeGrowth();
    if (rules.isLive) {
        growth.setLive(*rules.isLive, &records.emplace_back());
    }
    segment::Constraints changed = growth.constraints();
    changed.range = rules.range.value_or(changed.range);
    changed.difference = rules.difference.value_or(changed.difference);
    changed.gradient = rules.gradient.value_or(changed.gradient);
    changed.gradientDifference = rules.gradientDifference.value_or(changed.gradientDifference);
    if (rules.connectivity) {
        changed.connectivity = connectivityOf(*rules.connectivity);
    }
    growth.setConstraints(changed, &records.emplace_back());
}

int Region::absorb(const std::vector<glm::ivec3>& voxels, int expansions, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to absorb: the segment is empty");
    }
    return growth_->absorb(voxels, expansions, &records.emplace_back());
}

segment::VoxelSet Region::voxels(std::uint8_t label, Records& records) {
    if (!growth_) {
        return {};
    }
    const std::uint8_t before = growth_->activeLabel();
    workOn(label, records);
    const Box3 box = growth_->touchedBox();
    segment::VoxelSet set{box, growth_->labels(box)};
    workOn(before, records);
    return set.tight();
}

segment::VoxelSet Region::voxelsOf(std::uint8_t label) {
    Records records;
    segment::VoxelSet set;
    try {
        set = voxels(label, records);
    } catch (...) {
        undo(records);
        throw;
    }
    undo(records);
    return set;
}

void Region::replace(const segment::VoxelSet& set, Records& records) {
    madeGrowth().replace(set.box, set.inside, &records.emplace_back());
}

void Region::paint(const segment::VoxelSet& set, bool isToAdd, Records& records) {
    madeGrowth().paint(set.box, set.inside, isToAdd, &records.emplace_back());
}

void Region::workOn(std::uint8_t label, Records& records) {
    if ((growth_ || label != 1) && madeGrowth().activeLabel() != label) {
        growth_->activate(label, &records.emplace_back());
    }
}

void Region::clear(Records& records) {
    if (growth_) {
        growth_->reset(&records.emplace_back());
    }
}

void Region::forgetRules(Records& records) {
    if (growth_) {
        growth_->setLive(false, &records.emplace_back());
        growth_->setConstraints({}, &records.emplace_back());
    }
}

void Region::undo(const Records& records) {
    for (auto record = records.rbegin(); record != records.rend(); ++record) {
        try {
            record->undo(*growth_);
        } catch (const std::bad_alloc&) {
            record->undo(*growth_);
        } catch (const GlError&) {
            record->undo(*growth_);
        }
    }
}

void Region::beginLive(field::SculptureView view, Records& records) { grow(0, view, records); }

int Region::growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels) {
    return growth_->advanceFor(budgetMs, maxGenerations, nullptr, mostVoxels);
}

void Region::endLive(Records& records) { records.back().continueTo(*growth_); }

std::size_t Region::voxelCount(std::uint8_t label) const {
    return exists() ? std::size_t(growth_->voxelCount(label)) : 0;
}

std::uint64_t Region::revision() const { return exists() ? growth_->revision() : 0; }

std::vector<std::uint32_t> Region::generations() const {
    return exists() ? growth_->generations(true)
                    : std::vector<std::uint32_t>(field_->geometry.voxelCount(), 0);
}

std::vector<std::uint8_t> Region::labels() const {
    return exists() ? growth_->labels() : std::vector<std::uint8_t>(field_->geometry.voxelCount(), 0);
}

std::vector<std::uint8_t> Region::labelMap() const {
    return exists() ? growth_->labelMap() : std::vector<std::uint8_t>(field_->geometry.voxelCount(), 0);
}

} // namespace vs::studio
