// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/sculpture.h"

#include "field/cell_ranges.h"
#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

#include <algorithm>
#include <string>

namespace vs::sculpt {

namespace {

glm::ivec3 brickGrid(glm::ivec3 dims) { return divideUp(dims, field::kBrick); }

// The cells that have corners among these voxels.
Box3 cellsOf(const Box3& voxels, glm::ivec3 cellCount) {
    return intersect({(voxels.lo - 1) / field::kCell, (voxels.hi - 1) / field::kCell + 1},
                     {glm::ivec3(0), cellCount});
}

} // namespace

Sculpture::Sculpture(glm::ivec3 dims, Precision precision)
    : dims_(dims), precision_(precision),
      cells_(field::cellDims(dims), gl::Format::RG32F, gl::Filter::Nearest, "sculpture cells"),
      summarize_("sculpt/shaders/summarize_tiles.comp"), changed_(sizeof(std::uint32_t), "changed voxels"),
      touched_(Box3{glm::ivec3(0), brickGrid(dims)}.volume(), false) {
    combine_.with(defines()); // compiled now, not in the middle of a stroke
    changes_.reserve(kChangesRemembered);
}

Sculpture Sculpture::window(glm::ivec3 dims, Precision precision) {
    Sculpture window(dims, precision);
    window.isWindow_ = true;
    return window;
}

gl::Texture& Sculpture::allocated() const {
    if (!texels_) {
        texels_ = gl::Texture(dims_, format(), gl::Filter::Linear, "sculpture");
    }
    return texels_;
}

gl::Defines Sculpture::defines() const {
    gl::Defines defines = storedDefines(precision_);
    if (limits_.memberships != nullptr) {
        defines.emplace_back("LIMITED", "1");
    }
    return defines;
}

void Sculpture::bindLimits(gl::Program& program) const {
    if (limits_.memberships != nullptr) {
        limits_.memberships->bindTexture(kLimitsTexture);
        program.set("takesOnly", limits_.takesOnly ? 1 : 0);
    }
}

Box3 Sculpture::combine(const Radiator& radiation, Combine how) {
    return combine(radiation, how, Base::Itself, nullptr);
}

Box3 Sculpture::combineWith(const gl::Texture* before, const Radiator& radiation) {
    return combine(radiation, Combine::Cut, before != nullptr ? Base::Texture : Base::Nothing, before);
}

Box3 Sculpture::combine(const Radiator& radiation, Combine how, Base base, const gl::Texture* before) {
    changed_.clear();
    const Box3 box = radiation.resultBox();
    if (box.isEmpty() || (how == Combine::Restore && !isWindow_ && isEmpty())) {
        return {};
    }
    {
        const gl::Pass pass("combine sculpture");
        radiation.bindResultTiles(0);
        changed_.bindStorage(kChangedStorage);
        radiation.energy().bindImage(kEnergyImage, gl::Access::Read);
        texels().bindImage(kSculptureImage, gl::Access::ReadWrite);
        (before != nullptr ? *before : texels()).bindImage(kEarlierImage, gl::Access::Read);
        gl::Program& program = combine_.with(defines());
        bindLimits(program);
        program.set("tileDims", radiation.tileDims())
            .set("originVoxel", radiation.originVoxel())
            .set("firstVoxel", origin_)
            .set("dims", dims())
            .set("isRestore", how == Combine::Restore ? 1 : 0)
            .set("base", int(base));
        // The list of tiles is written again by the next round of radiation.
        program.dispatchIndirect(radiation.tileArguments(), 0, gl::Barrier::All);
    }
    if (isWindow_) {
        return box;
    }
    // A cut only adds: what was not empty stays so.
    const bool staysNonEmpty = how == Combine::Cut && base == Base::Itself && isEmpty_ == false;
    summarizeTiles(radiation, box);
    noteWritten(box);
    if (staysNonEmpty) {
        isEmpty_ = false;
    }
    return box;
}

// The macrocells that have a corner in the radiation's tiles; `box` holds those tiles.
void Sculpture::summarizeTiles(const Radiator& radiation, const Box3& box) {
    const gl::Pass pass("update cell ranges");
    const Box3 cells = cellsOf(box, cells_.size());
    texels().bindTexture(kWholeSculptureTexture);
    cells_.bindImage(kSculptureCellsImage, gl::Access::Write);
    radiation.bindStages(0);
    summarize_.set("dims", dims())
        .set("cellLo", cells.lo)
        .set("cellHi", cells.hi)
        .set("originTile", radiation.originVoxel() / kTile)
        .set("tileDims", radiation.tileDims());
    // The stages, which this reads, are written by the next round.
    summarize_.dispatchOver(cells.size(), gl::Barrier::All);
}

std::uint64_t Sculpture::changedVoxels() const { return changed_.readValue<std::uint32_t>(); }

void Sculpture::clear() {
    Box3 all;
    const std::vector<Box3> bricks = touchedBricks();
    for (const Box3& brick : bricks) {
        texels().clear(brick);
        cells_.clear(cellsOf(brick, cells_.size()));
        all = unite(all, brick);
    }
    touched_.assign(touched_.size(), false);
    isEmpty_ = true;
    noteChange(all);
}

void Sculpture::noteChange(const Box3& box) {
    if (changes_.size() == kChangesRemembered) { // the oldest two become one
        changes_[1].box = unite(changes_[0].box, changes_[1].box);
        changes_.erase(changes_.begin());
    }
    changes_.push_back({++version_, box});
    contentVersion_ = version_;
}

Box3 Sculpture::changedSince(std::uint64_t version) const {
    Box3 all;
    for (const Change& change : changes_) {
        all = change.version > version ? unite(all, change.box) : all;
    }
    return all;
}

void Sculpture::markTouched(const Box3& box) {
    const glm::ivec3 grid = brickGrid(dims());
    const glm::ivec3 last = (box.hi - 1) / field::kBrick;
    for (int z = box.lo.z / field::kBrick; z <= last.z; ++z) {
        for (int y = box.lo.y / field::kBrick; y <= last.y; ++y) {
            for (int x = box.lo.x / field::kBrick; x <= last.x; ++x) {
                touched_[std::size_t((z * grid.y + y) * grid.x + x)] = true;
            }
        }
    }
}

std::vector<Box3> Sculpture::touchedBricks() const {
    const glm::ivec3 grid = brickGrid(dims());
    std::vector<Box3> bricks;
    for (std::size_t n = 0; n < touched_.size(); ++n) {
        if (touched_[n]) {
            const int number = int(n);
            const glm::ivec3 lo =
                glm::ivec3(number % grid.x, number / grid.x % grid.y, number / (grid.x * grid.y)) *
                field::kBrick;
            bricks.push_back(intersect({lo, lo + field::kBrick}, {glm::ivec3(0), dims()}));
        }
    }
    return bricks;
}

void Sculpture::upload(const Box3& box, std::span<const std::byte> texels) {
    allocated().upload(box, texels);
    refresh(box);
}

void Sculpture::swap(BrickDelta& delta) {
    delta.swap(texels());
    refresh(delta.box());
}

void Sculpture::swap(SculptureDelta& delta) {
    Box3 box = delta.box();
    const bool hasFiner = finer_ != nullptr && !delta.finer.isEmpty();
    if (hasFiner) {
        const std::uint64_t before = finer_->version();
        finer_->swap(delta.finer);
        box = unite(box, finer_->sceneBox(finer_->changedSince(before)));
    }
    try {
        delta.BrickDelta::swap(texels());
    } catch (...) {
        if (hasFiner) {
            finer_->swap(delta.finer);
        }
        throw;
    }
    refresh(intersect(box, {glm::ivec3(0), dims_}));
}

void Sculpture::refine(std::unique_ptr<FineSculpture> finer) {
    if (!isEmpty()) {
        FineBricks originals; // all of it is new
        for (const Box3& brick : touchedBricks()) {
            const Box3 box = intersect(grow(brick, 1), {glm::ivec3(0), dims_});
            finer->raise(box, std::vector<float>(box.volume(), 0.0F), values(box), originals);
        }
    }
    const bool isCut = !isEmpty();
    finer_ = std::move(finer);
    try {
        if (isCut) {
            refresh({glm::ivec3(0), dims_});
        }
    } catch (...) {
        finer_.reset();
        throw;
    }
}

void Sculpture::derive(const Box3& finerBox, BrickBackup& backup) {
    const Box3 box = intersect(finer_->sceneBox(finerBox), {glm::ivec3(0), dims_});
    if (!box.isEmpty()) {
        backup.protect(box);
        upload(box, texelsOf(finer_->sceneValues(box), precision_));
    }
}

void Sculpture::cutFiner(SculptureDelta& change) {
    if (finer_ == nullptr || change.BrickDelta::isEmpty()) {
        return;
    }
    FineBricks originals;
    try {
        const Box3 whole{glm::ivec3(0), dims_};
        const Box3 all = change.box();
        const gl::Texture was = change.before(texels(), "sculpture before a cut");
        for (const Box3& brick : change.bricks()) {
            // What is between the brick's voxels and those beside it rises too; those are in turn.
            const Box3 box = intersect(grow(brick, 1), whole);
            const Box3 known = intersect(box, all);
            auto before = values(box); // what lies beside all that has changed is as it was
            const auto earlier = valuesOf(was.download({known.lo - all.lo, known.hi - all.lo}), precision_);
            const auto after = before;
            const glm::ivec3 size = box.size();
            forEachVoxel(known, [&](glm::ivec3 v, std::size_t n) {
                const glm::ivec3 at = v - box.lo;
                before[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                       std::size_t(at.x)] = earlier[n];
            });
            finer_->raise(box, before, after, originals, limits_);
        }
        change.finer = finer_->since(originals);
        refresh(all);
    } catch (...) {
        finer_->takeBack(originals);
        change.finer = {};
        swap(change);
        throw;
    }
}

BrickDelta Sculpture::content() const {
    return takesRoom() ? contentOf(texels(), touchedBricks(), untouchedTexel(precision_)) : BrickDelta{};
}

void Sculpture::restore(const BrickDelta& content, std::uint64_t version, std::uint64_t contentVersion) {
    VS_CHECK_EQ(version_, std::uint64_t(0));
    if (!content.isEmpty()) {
        content.bringInto(texels(), untouchedTexel(precision_));
    }
    for (const Box3& brick : content.bricks()) {
        summarize(brick);
        markTouched(brick);
    }
    isEmpty_.reset();
    changes_.assign(1, {version, content.box()});
    version_ = version;
    contentVersion_ = contentVersion;
}

void Sculpture::refresh(const Box3& box) {
    if (!box.isEmpty() && !isWindow_) {
        summarize(box);
        noteWritten(box);
    }
}

// The macrocells that have corners in a box.
void Sculpture::summarize(const Box3& box) {
    if (finer_ == nullptr || isRough_) {
        updater_.update(texels(), box, cells_);
        return;
    }
    const Box3 cells = cellsOf(box, cells_.size());
    const std::vector<glm::vec2> ranges = finer_->cellRanges(cells);
    cells_.upload(cells, std::as_bytes(std::span(ranges)));
}

void Sculpture::noteWritten(const Box3& box) {
    markTouched(box);
    isEmpty_.reset();
    noteChange(box);
}

bool Sculpture::isEmpty() const {
    if (finer_ != nullptr && !finer_->isEmpty()) {
        return false;
    }
    if (!isEmpty_) {
        // The cells know: a voxel is a corner of some cell, and only where something was written can there be
        // anything.
        const auto bricks = touchedBricks();
        isEmpty_ = std::none_of(bricks.begin(), bricks.end(), [&](const Box3& brick) {
            const Box3 cells = cellsOf(brick, cells_.size());
            const auto bytes = cells_.download(cells);
            const auto* ranges = reinterpret_cast<const glm::vec2*>(bytes.data());
            return std::any_of(ranges, ranges + cells.volume(), [](glm::vec2 range) { return range.y > 0; });
        });
    }
    return *isEmpty_;
}

} // namespace vs::sculpt
