// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/fine_sculpture.h"

#include "base/check.h"
#include "base/parallel.h"
#include "field/cell_ranges.h"
#include "field/field.h"
#include "sculpt/sculpture/fine_reader.h"
#include "sculpt/sculpture/fine_texels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vs::sculpt {

namespace {

constexpr std::size_t kChangesRemembered = 64;

std::vector<std::byte> oneTexel(float value, Precision precision) {
    return texelsOf(std::span(&value, 1), precision);
}

// Null where all texels are 0, one texel where they are alike.
FineBrick brickOf(std::vector<std::byte> texels, std::size_t texelBytes) {
    const bool isUniform =
        std::memcmp(texels.data(), texels.data() + texelBytes, texels.size() - texelBytes) == 0;
    if (isUniform) {
        texels.resize(texelBytes);
        texels.shrink_to_fit();
        if (std::all_of(texels.begin(), texels.end(), [](std::byte b) { return b == std::byte(0); })) {
            return {};
        }
    }
    return std::make_shared<const std::vector<std::byte>>(std::move(texels));
}

} // namespace

FineSculpture::FineSculpture(field::BrickGrid grid, Precision precision)
    : grid_(grid), precision_(precision) {
    changes_.reserve(kChangesRemembered);
}

glm::ivec3 FineSculpture::counts() const { return divideUp(grid_.dims, kFineBrick); }

int FineSculpture::placeOf(glm::ivec3 brick) const {
    const glm::ivec3 n = counts();
    return (brick.z * n.y + brick.y) * n.x + brick.x;
}

Box3 FineSculpture::boxOf(int place) const {
    const glm::ivec3 n = counts();
    const glm::ivec3 lo = glm::ivec3(place % n.x, place / n.x % n.y, place / n.x / n.y) * kFineBrick;
    return {lo, glm::min(lo + kFineBrick, grid_.dims)};
}

FineBrick FineSculpture::at(int place) const {
    const auto found = bricks_->find(place);
    return found == bricks_->end() ? FineBrick() : found->second;
}

std::size_t FineSculpture::bytesOf(int place) const {
    return boxOf(place).volume() * gl::bytesPerTexel(formatOf(precision_));
}

// What snapshots share is copied before it changes.
FineBricks& FineSculpture::writable() {
    if (bricks_.use_count() > 1) {
        bricks_ = std::make_shared<FineBricks>(*bricks_);
    }
    return *bricks_;
}

void FineSculpture::set(int place, FineBrick brick) {
    if (brick == nullptr) {
        writable().erase(place);
    } else {
        writable()[place] = std::move(brick);
    }
}

void FineSculpture::noteChange(const Box3& box) {
    if (changes_.size() == kChangesRemembered) { // the oldest two become one
        changes_[1].box = unite(changes_[0].box, changes_[1].box);
        changes_.erase(changes_.begin());
    }
    changes_.push_back({++version_, box});
}

Box3 FineSculpture::changedSince(std::uint64_t version) const {
    Box3 all;
    for (const Change& change : changes_) {
        all = change.version > version ? unite(all, change.box) : all;
    }
    return all;
}

std::vector<std::byte> FineSculpture::texels(const Box3& box) const {
    return texelsIn(*bricks_, grid_.dims, gl::bytesPerTexel(formatOf(precision_)), box);
}

std::function<std::vector<float>(const Box3&)> FineSculpture::reader() const {
    return [bricks = std::shared_ptr<const FineBricks>(bricks_), dims = grid_.dims,
            precision = precision_](const Box3& box) {
        return valuesOf(texelsIn(*bricks, dims, gl::bytesPerTexel(formatOf(precision)), box), precision);
    };
}

std::function<bool(const Box3&)> FineSculpture::emptyBoxes() const {
    return [bricks = std::shared_ptr<const FineBricks>(bricks_), counts = counts()](const Box3& box) {
        bool isEmpty = true;
        forEachVoxel(Box3{box.lo / kFineBrick, divideUp(box.hi, kFineBrick)},
                     [&](glm::ivec3 at, std::size_t) {
                         isEmpty = isEmpty && !bricks->contains((at.z * counts.y + at.y) * counts.x + at.x);
                     });
        return isEmpty;
    };
}

void FineSculpture::put(const Box3& box, std::span<const std::byte> texels, FineBricks& before) {
    const std::size_t texelBytes = gl::bytesPerTexel(formatOf(precision_));
    Box3 changed;
    forEachVoxel(Box3{box.lo / kFineBrick, (box.hi - 1) / kFineBrick + 1},
                 [&](glm::ivec3 brickAt, std::size_t) {
                     const int place = placeOf(brickAt);
                     const Box3 own = boxOf(place);
                     VS_CHECK(intersect(own, box) == own);
                     std::vector<std::byte> now(own.volume() * texelBytes);
                     copyTexels(box, texels.data(), own, now.data(), texelBytes);
                     const FineBrick was = at(place);
                     FineBrick brick = brickOf(std::move(now), texelBytes);
                     const bool isSame = was == nullptr || brick == nullptr ? was == brick : *was == *brick;
                     if (!isSame) {
                         before.emplace(place, was);
                         set(place, std::move(brick));
                         changed = unite(changed, own);
                     }
                 });
    if (!changed.isEmpty()) {
        noteChange(changed);
    }
}

bool FineSculpture::fill(glm::ivec3 brick, bool isCut, FineBricks& before) {
    const int place = placeOf(brick);
    const FineBrick was = at(place);
    const auto texel = oneTexel(1, precision_);
    if (isCut ? was != nullptr && *was == texel : was == nullptr) {
        return false;
    }
    before.emplace(place, was);
    set(place, isCut ? std::make_shared<const std::vector<std::byte>>(texel) : FineBrick());
    noteChange(boxOf(place));
    return true;
}

void FineSculpture::swap(FineDelta& delta) {
    const std::size_t count = delta.bricks.size();
    std::vector<FineBrick> wanted(count);
    std::vector<FineBrick> kept(count);
    inParallel(int(count), [&](int n) {
        const auto& [place, brick] = delta.bricks[std::size_t(n)];
        wanted[std::size_t(n)] = unpacked(brick, bytesOf(place));
        kept[std::size_t(n)] = packed(at(place));
    });
    // Places get their room first; then nothing fails.
    FineBricks& bricks = writable();
    try {
        for (std::size_t n = 0; n < count; ++n) {
            if (wanted[n] != nullptr) {
                bricks.try_emplace(delta.bricks[n].first);
            }
        }
    } catch (...) {
        std::erase_if(bricks, [](const auto& entry) { return entry.second == nullptr; });
        throw;
    }
    Box3 changed;
    for (std::size_t n = 0; n < count; ++n) {
        auto& [place, brick] = delta.bricks[n];
        if (wanted[n] == nullptr) {
            bricks.erase(place);
        } else {
            bricks[place] = std::move(wanted[n]);
        }
        brick = std::move(kept[n]);
        changed = unite(changed, boxOf(place));
    }
    if (!changed.isEmpty()) {
        noteChange(changed);
    }
}

FineDelta FineSculpture::since(const FineBricks& before) const {
    const std::size_t texelBytes = gl::bytesPerTexel(formatOf(precision_));
    const std::vector<std::byte> zero(texelBytes);
    std::vector<std::pair<int, FineBrick>> bricks(before.begin(), before.end());
    std::sort(bricks.begin(), bricks.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> counts(bricks.size());
    inParallel(int(bricks.size()), [&](int n) {
        auto& [place, was] = bricks[std::size_t(n)];
        const FineBrick now = at(place);
        if (was == now) {
            return;
        }
        const auto texel = [&](const FineBrick& brick, std::size_t i) {
            return brick == nullptr ? zero.data()
                                    : brick->data() + (brick->size() == texelBytes ? 0 : i * texelBytes);
        };
        const bool areUniform =
            (was == nullptr || was->size() == texelBytes) && (now == nullptr || now->size() == texelBytes);
        const std::size_t voxels = boxOf(place).volume();
        std::size_t& count = counts[std::size_t(n)];
        if (areUniform) {
            count = std::memcmp(texel(was, 0), texel(now, 0), texelBytes) != 0 ? voxels : 0;
            return;
        }
        for (std::size_t i = 0; i < voxels; ++i) {
            count += std::memcmp(texel(was, i), texel(now, i), texelBytes) != 0 ? 1 : 0;
        }
        was = packed(was);
    });
    FineDelta delta;
    for (std::size_t n = 0; n < bricks.size(); ++n) {
        if (counts[n] > 0) {
            delta.changedVoxels += counts[n];
            delta.bricks.push_back(std::move(bricks[n]));
        }
    }
    return delta;
}

void FineSculpture::takeBack(const FineBricks& before) {
    Box3 changed;
    for (const auto& [place, brick] : before) {
        set(place, brick);
        changed = unite(changed, boxOf(place));
    }
    if (!changed.isEmpty()) {
        noteChange(changed);
    }
}

FineDelta FineSculpture::clear() {
    const std::size_t texelBytes = gl::bytesPerTexel(formatOf(precision_));
    const std::vector<std::byte> zero(texelBytes);
    FineDelta delta;
    FineBricks nothing;
    for (const auto& [place, brick] : *bricks_) {
        delta.bricks.emplace_back(place, packed(brick));
        nothing.emplace(place, FineBrick());
        for (std::size_t n = 0; n < brick->size(); n += texelBytes) {
            const bool isCut = std::memcmp(brick->data() + n, zero.data(), texelBytes) != 0;
            delta.changedVoxels += !isCut ? 0 : brick->size() == texelBytes ? boxOf(place).volume() : 1;
        }
    }
    takeBack(nothing);
    return delta;
}

Box3 FineSculpture::sceneBox(const Box3& box) const {
    if (box.isEmpty()) {
        return {};
    }
    // The half voxel around the outermost centres belongs to them.
    const glm::dvec3 lo = (glm::dvec3(box.lo) - 1.0 - grid_.origin) / grid_.perSceneVoxel;
    const glm::dvec3 hi = (glm::dvec3(box.hi) - grid_.origin) / grid_.perSceneVoxel;
    return {glm::ivec3(glm::floor(lo)), glm::ivec3(glm::ceil(hi)) + 1};
}

std::vector<float> FineSculpture::sceneValues(const Box3& sceneBox) const {
    std::vector<float> values(sceneBox.volume());
    if (values.empty() || bricks_->empty()) {
        return values;
    }
    // In slabs, each on a processor; with few of them none is worth it.
    constexpr int kSlab = 16;
    const std::size_t slice = std::size_t(sceneBox.size().x) * std::size_t(sceneBox.size().y);
    inParallel(divideUp(sceneBox.size().z, kSlab), [&](int n) {
        FineReader reader(*bricks_, grid_.dims, precision_);
        Box3 slab = sceneBox;
        slab.lo.z = sceneBox.lo.z + n * kSlab;
        slab.hi.z = std::min(slab.lo.z + kSlab, sceneBox.hi.z);
        float* first = values.data() + std::size_t(n) * kSlab * slice;
        sample(reader, *bricks_, {grid_.perSceneVoxel, grid_.origin}, slab,
               [&](std::size_t i, float value) { first[i] = value; });
    });
    return values;
}

std::vector<glm::vec2> FineSculpture::cellRanges(const Box3& cells) const {
    std::vector<glm::vec2> ranges(cells.volume(), glm::vec2(0));
    if (bricks_->empty()) {
        return ranges;
    }
    const glm::ivec3 size = cells.size();
    inParallel(size.z, [&](int slice) {
        FineReader reader(*bricks_, grid_.dims, precision_);
        const Box3 own{{cells.lo.x, cells.lo.y, cells.lo.z + slice},
                       {cells.hi.x, cells.hi.y, cells.lo.z + slice + 1}};
        forEachVoxel(own, [&](glm::ivec3 cell, std::size_t n) {
            // What lies beyond a cell's corners by half a voxel of the scene may be looked up in it.
            const glm::dvec3 lo =
                (glm::dvec3(cell * field::kCell) - 0.5) * grid_.perSceneVoxel + grid_.origin;
            const glm::dvec3 hi =
                (glm::dvec3((cell + 1) * field::kCell) + 0.5) * grid_.perSceneVoxel + grid_.origin;
            const glm::ivec3 top = grid_.dims - 1;
            const glm::ivec3 first = glm::clamp(glm::ivec3(glm::floor(lo)), glm::ivec3(0), top);
            const glm::ivec3 last = glm::clamp(glm::ivec3(glm::ceil(hi)), glm::ivec3(0), top);
            ranges[std::size_t(slice) * std::size_t(size.x) * std::size_t(size.y) + n] =
                reader.rangeOf({first, last + 1});
        });
    });
    return ranges;
}

} // namespace vs::sculpt
