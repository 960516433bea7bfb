// SPDX-License-Identifier: Apache-2.0
#include "studio/state/region.h"

#include "base/check.h"
#include "base/error.h"

#include <algorithm>
#include <new>
#include <type_traits>

namespace vs::studio {

namespace {

// Sets of finest voxels are for segments of the finest level.
void replace(segment::FineGrowth& growth, const segment::FineSet& set, segment::FineUndo* undo) {
    growth.replace(set, undo);
}
void replace(segment::Growth&, const segment::FineSet&, segment::GrowthUndo*) { VS_CHECK(false); }
void paint(segment::FineGrowth& growth, const segment::FineSet& set, bool isToAdd, segment::FineUndo* undo) {
    growth.paint(set, isToAdd, undo);
}
void paint(segment::Growth&, const segment::FineSet&, bool, segment::GrowthUndo*) { VS_CHECK(false); }

} // namespace

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

FinestRegion& Region::madeFinest() {
    if (!finest_) {
        finest_ = std::make_unique<FinestRegion>(*finestLevel_, *field_, *sculpture_);
    }
    finest_->follow(field_->geometry);
    return *finest_;
}

template <typename Change>
void Region::change(const Change& change) {
    if (isFiner()) {
        segment::Growth& scene = madeGrowth();
        FinestRegion& finest = madeFinest();
        change(finest.growth());
        finest.show(scene);
    } else {
        change(madeGrowth());
    }
}

template <typename Change>
void Region::change(Records& records, const Change& change) {
    RegionUndo& record = records.emplace_back();
    this->change([&](auto& growth) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(growth)>, segment::Growth>) {
            change(growth, &record.scene);
        } else {
            record.finest = std::make_shared<segment::FineUndo>();
            change(growth, record.finest.get());
        }
    });
}

volume::GridGeometry Region::geometry() const {
    return isFiner() ? field::finerGeometry(field_->geometry, finestLevel_->grid) : field_->geometry;
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

FinestRegion Region::apart() const {
    FinestLevel level = *finestLevel_;
    level.hostBytes /= 2; // there may be segments beside it
    return {level, *field_, *sculpture_};
}

std::vector<glm::ivec3> Region::findFinestSeeds(const field::SurfacePoints& points,
                                                const segment::Constraints& constraints) {
    return madeFinest().found(points, constraints);
}

std::vector<glm::ivec3> Region::finestIn(const std::vector<glm::ivec3>& sceneVoxels) {
    return madeFinest().finestIn(sceneVoxels);
}

segment::SeedCounts Region::seed(const std::vector<glm::ivec3>& voxels, const std::vector<glm::ivec3>& finest,
                                 const segment::Constraints& constraints, Records& records) {
    change(records, [&](auto& growth, auto* undo) { growth.setConstraints(constraints, undo); });
    const bool isWidened = isFiner() && finest.empty();
    const std::vector<glm::ivec3> widened = isWidened ? finest_->finestIn(voxels) : std::vector<glm::ivec3>();
    const auto& seeds = isWidened ? widened : isFiner() ? finest : voxels;
    segment::SeedCounts counts;
    change(records, [&](auto& growth, auto* undo) { counts = growth.addSeeds(seeds, undo); });
    if (isWidened && counts.added + counts.present > 0) {
        counts.refused = 0; // voxels of the scene need not lie in the range wholly
    }
    return counts;
}

void Region::refreshFence(field::SculptureView view, Records& records) {
    const auto& now = growth_->constraints();
    const auto refreshed = constraints(now.range, view, now.connectivity);
    change(records, [&](auto& growth, auto* undo) { growth.setConstraints(refreshed, undo); });
}

int Region::grow(int generations, field::SculptureView view, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to grow from: draw seeds first");
    }
    refreshFence(view, records);
    int grown = 0;
    change(records, [&](auto& growth, auto* undo) { grown = growth.advance(generations, undo); });
    return grown;
}

int Region::rewind(int generations, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to rewind: no region has been grown");
    }
    int taken = 0;
    change(records, [&](auto& growth, auto* undo) { taken = growth.takeBack(generations, undo); });
    return taken;
}

void Region::showGeneration(int generation, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to show: no region has been grown");
    }
    change(records, [&](auto& growth, auto* undo) { growth.setPlayhead(generation, undo); });
}

void Region::scrub(int generation) {
    if (isFiner()) {
        finest_->growth().setPlayhead(generation);
        finest_->scrub(*growth_);
    } else {
        growth_->setPlayhead(generation);
    }
}

const segment::Constraints& Region::rules() const {
    static const segment::Constraints none;
    return growth_ ? growth_->constraints() : none;
}

void Region::setRules(const SetGrowthRules& rules, Records& records) {
    madeGrowth();
    if (rules.isLive) {
        change(records, [&](auto& growth, auto* undo) { growth.setLive(*rules.isLive, undo); });
    }
    segment::Constraints changed = growth_->constraints();
    changed.range = rules.range.value_or(changed.range);
    changed.difference = rules.difference.value_or(changed.difference);
    changed.gradient = rules.gradient.value_or(changed.gradient);
    changed.gradientDifference = rules.gradientDifference.value_or(changed.gradientDifference);
    if (rules.connectivity) {
        changed.connectivity = connectivityOf(*rules.connectivity);
    }
    change(records, [&](auto& growth, auto* undo) { growth.setConstraints(changed, undo); });
}

int Region::absorb(const std::vector<glm::ivec3>& voxels, const std::vector<glm::ivec3>& finest,
                   int expansions, Records& records) {
    if (!hasSeeds()) {
        throw Error("nothing to absorb: the segment is empty");
    }
    const bool isWidened = isFiner() && finest.empty();
    const std::vector<glm::ivec3> widened =
        isWidened ? madeFinest().finestIn(voxels) : std::vector<glm::ivec3>();
    const auto& from = isWidened ? widened : isFiner() ? finest : voxels;
    int found = 0;
    change(records, [&](auto& growth, auto* undo) { found = growth.absorb(from, expansions, undo); });
    return found;
}

segment::VoxelSet Region::voxels(std::uint8_t label, Records& records) {
    if (!growth_) {
        return {};
    }
    if (isFiner()) {
        segment::VoxelSet set{field_->geometry.box(), growth_->labelMap()};
        std::transform(set.inside.begin(), set.inside.end(), set.inside.begin(),
                       [&](std::uint8_t own) { return std::uint8_t(own == label ? 1 : 0); });
        return set.tight();
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
    if (isFiner()) {
        replace(madeFinest().finestOf(set), records);
    } else {
        madeGrowth().replace(set.box, set.inside, &records.emplace_back().scene);
    }
}

void Region::paint(const segment::VoxelSet& set, bool isToAdd, Records& records) {
    VS_CHECK(!isFiner());
    madeGrowth().paint(set.box, set.inside, isToAdd, &records.emplace_back().scene);
}

segment::FineSet Region::finestVoxels(std::uint8_t label) { return madeFinest().growth().voxels(label); }

segment::FineSet Region::finestInRange(const segment::FineSet& set, const Range& range) {
    return madeFinest().growth().inRange(set, range);
}

void Region::replace(const segment::FineSet& set, Records& records) {
    change(records, [&](auto& growth, auto* undo) { studio::replace(growth, set, undo); });
}

void Region::paint(const segment::FineSet& set, bool isToAdd, Records& records) {
    change(records, [&](auto& growth, auto* undo) { studio::paint(growth, set, isToAdd, undo); });
}

void Region::workOn(std::uint8_t label, Records& records) {
    if ((growth_ || label != 1) && madeGrowth().activeLabel() != label) {
        change(records, [&](auto& growth, auto* undo) { growth.activate(label, undo); });
    }
}

void Region::clear(Records& records) {
    if (growth_) {
        change(records, [&](auto& growth, auto* undo) { growth.reset(undo); });
    }
}

void Region::forgetRules(Records& records) {
    if (growth_) {
        change(records, [&](auto& growth, auto* undo) { growth.setLive(false, undo); });
        change(records, [&](auto& growth, auto* undo) { growth.setConstraints({}, undo); });
    }
}

void Region::undo(const Records& records) {
    for (auto record = records.rbegin(); record != records.rend(); ++record) {
        if (finest_) {
            if (record->finest != nullptr) { // else the call never began
                finest_->growth().undo(*record->finest);
            }
            continue;
        }
        try {
            record->scene.undo(*growth_);
        } catch (const std::bad_alloc&) {
            record->scene.undo(*growth_);
        } catch (const GlError&) {
            record->scene.undo(*growth_);
        }
    }
    if (finest_ && growth_) {
        finest_->show(*growth_);
    }
}

void Region::beginLive(field::SculptureView view, Records& records) { grow(0, view, records); }

int Region::growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels) {
    int grown = 0;
    change([&](auto& growth) { grown = growth.advanceFor(budgetMs, maxGenerations, nullptr, mostVoxels); });
    return grown;
}

void Region::endLive(Records& records) {
    if (!isFiner()) { // there undoing erases whatever advancing added
        records.back().scene.continueTo(*growth_);
    }
}

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
