// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/brick_backup.h"

#include "base/check.h"
#include "base/error.h"
#include "field/field.h"
#include "gl/pass.h"
#include "sculpt/sculpture/brick_codec.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

constexpr std::size_t kBricksTogether = 16; // in one encoding

// So many bytes of texels that are all alike.
std::vector<std::byte> repeated(std::span<const std::byte> texel, std::size_t bytes) {
    std::vector<std::byte> all(bytes);
    for (std::size_t n = 0; n < bytes; ++n) {
        all[n] = texel[n % texel.size()];
    }
    return all;
}

} // namespace

// Makes a delta brick by brick.
class DeltaMaker {
public:
    explicit DeltaMaker(const gl::Texture& texture)
        : texelBytes_(gl::bytesPerTexel(texture.format())), encoder_(texelBytes_) {}

    // Adds a brick in which the delta is to hold `held` while the texture has `current`.
    void add(const Box3& box, std::span<const std::byte> held, std::span<const std::byte> current) {
        delta_.changedVoxels_ += encoder_.add(box.size(), held, current);
        delta_.bricks_.push_back(box);
        if (delta_.bricks_.size() % kBricksTogether == 0) {
            endGroup();
        }
    }
    BrickDelta finish() {
        if (delta_.bricks_.size() % kBricksTogether != 0) {
            endGroup();
        }
        delta_.held_.shrink_to_fit();
        return std::move(delta_);
    }

private:
    void endGroup() {
        const auto encoded = encoder_.finish();
        delta_.held_.insert(delta_.held_.end(), encoded.begin(), encoded.end());
        delta_.ends_.push_back(delta_.held_.size());
        encoder_ = BrickEncoder(texelBytes_);
    }

    std::size_t texelBytes_;
    BrickEncoder encoder_;
    BrickDelta delta_;
};

BrickDelta contentOf(const gl::Texture& texture, std::span<const Box3> bricks,
                     std::span<const std::byte> untouched) {
    const gl::Pass pass("keep bricks");
    VS_CHECK_EQ(untouched.size(), gl::bytesPerTexel(texture.format()));
    DeltaMaker maker(texture);
    for (const Box3& box : bricks) {
        const auto bytes = texture.download(box);
        const auto base = repeated(untouched, bytes.size());
        if (bytes != base) {
            maker.add(box, bytes, base);
        }
    }
    return maker.finish();
}

std::vector<Box3> bricksOf(glm::ivec3 dims) {
    const glm::ivec3 grid = divideUp(dims, field::kBrick);
    std::vector<Box3> bricks;
    forEachVoxel(Box3{glm::ivec3(0), grid}, [&](glm::ivec3 brick, std::size_t) {
        const glm::ivec3 lo = brick * field::kBrick;
        bricks.push_back({lo, glm::min(lo + field::kBrick, dims)});
    });
    return bricks;
}

BrickDelta BrickDelta::from(std::vector<Box3> bricks, std::vector<std::byte> held,
                            std::vector<std::size_t> ends, std::size_t changedVoxels, glm::ivec3 dims) {
    const auto isInside = [&](const Box3& box) {
        return !box.isEmpty() && intersect(box, {glm::ivec3(0), dims}) == box &&
               glm::all(glm::lessThanEqual(box.size(), glm::ivec3(field::kBrick)));
    };
    if (!std::all_of(bricks.begin(), bricks.end(), isInside) || !std::is_sorted(ends.begin(), ends.end()) ||
        ends.size() != (bricks.size() + kBricksTogether - 1) / kBricksTogether ||
        held.size() != (ends.empty() ? 0 : ends.back())) {
        throw Error("a change that is kept there does not fit the volume");
    }
    BrickDelta delta;
    delta.bricks_ = std::move(bricks);
    delta.held_ = std::move(held);
    delta.ends_ = std::move(ends);
    delta.changedVoxels_ = changedVoxels;
    return delta;
}

std::span<const Box3> BrickDelta::together(std::size_t group) const {
    const std::size_t first = group * kBricksTogether;
    return std::span(bricks_).subspan(first, std::min(kBricksTogether, bricks_.size() - first));
}

std::span<const std::byte> BrickDelta::encoding(std::size_t group) const {
    const std::size_t begin = group == 0 ? 0 : ends_[group - 1];
    VS_CHECK(ends_[group] <= held_.size()); // else they were never given back
    return std::span(held_).subspan(begin, ends_[group] - begin);
}

void BrickDelta::swap(gl::Texture& texture) {
    const gl::Pass pass("swap bricks");
    BrickDelta other;
    other.bricks_ = bricks_;
    other.ends_.reserve(ends_.size());
    try {
        for (std::size_t group = 0; group < ends_.size(); ++group) {
            exchange(texture, group, other);
        }
        other.held_.shrink_to_fit();
    } catch (...) { // no memory: what has been exchanged goes back
        for (std::size_t group = 0; group < other.ends_.size(); ++group) {
            BrickDelta again;
            again.ends_.reserve(1);
            other.exchange(texture, group, again);
        }
        throw;
    }
    held_ = std::move(other.held_);
    ends_ = std::move(other.ends_);
}

// Exchanges one group of bricks; what brings it back is appended to `other`. Changes nothing when it throws.
void BrickDelta::exchange(gl::Texture& texture, std::size_t group, BrickDelta& other) const {
    const std::size_t texelBytes = gl::bytesPerTexel(texture.format());
    BrickDecoder decoder(texelBytes, encoding(group));
    BrickEncoder encoder(texelBytes);
    std::vector<std::vector<std::byte>> wanted;
    for (const Box3& brick : together(group)) {
        const auto current = texture.download(brick);
        wanted.push_back(current);
        decoder.next(brick.size(), wanted.back());
        encoder.add(brick.size(), current, wanted.back());
    }
    const auto encoded = encoder.finish();
    other.held_.insert(other.held_.end(), encoded.begin(), encoded.end());
    other.ends_.push_back(other.held_.size());
    for (std::size_t n = 0; n < wanted.size(); ++n) {
        texture.upload(together(group)[n], wanted[n]);
    }
}

void BrickDelta::bringInto(gl::Texture& texture, std::span<const std::byte> untouched) const {
    const gl::Pass pass("bring bricks");
    for (std::size_t group = 0; group < ends_.size(); ++group) {
        BrickDecoder decoder(untouched.size(), encoding(group));
        for (const Box3& brick : together(group)) {
            auto texels = repeated(untouched, brick.volume() * untouched.size());
            decoder.next(brick.size(), texels);
            texture.upload(brick, texels);
        }
    }
}

gl::Texture BrickDelta::before(const gl::Texture& texture, const std::string& label) const {
    const gl::Pass pass("bricks before");
    const Box3 all = box();
    gl::Texture before(all.size(), texture.format(), gl::Filter::Nearest, label);
    before.copyFrom(texture, all, glm::ivec3(0));
    for (std::size_t group = 0; group < ends_.size(); ++group) {
        BrickDecoder decoder(gl::bytesPerTexel(texture.format()), encoding(group));
        for (const Box3& brick : together(group)) {
            auto texels = texture.download(brick);
            decoder.next(brick.size(), texels);
            before.upload({brick.lo - all.lo, brick.hi - all.lo}, texels);
        }
    }
    return before;
}

Box3 BrickDelta::box() const {
    Box3 all;
    for (const Box3& brick : bricks_) {
        all = unite(all, brick);
    }
    return all;
}

std::size_t BrickDelta::memoryBytes() const {
    return sizeof(*this) + held_.capacity() + bricks_.capacity() * sizeof(Box3) +
           ends_.capacity() * sizeof(std::size_t);
}

void BrickDelta::drop() {
    held_.clear();
    held_.shrink_to_fit();
}

void BrickBackup::protect(const Box3& voxels) {
    const Box3 whole{glm::ivec3(0), texture_->size()};
    const Box3 part = intersect(voxels, whole);
    if (part.isEmpty()) {
        return;
    }
    const gl::Pass pass("protect bricks");
    const glm::ivec3 grid = divideUp(texture_->size(), field::kBrick);
    const glm::ivec3 first = part.lo / field::kBrick;
    const glm::ivec3 last = (part.hi - 1) / field::kBrick;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const std::size_t number =
                    (std::size_t(z) * std::size_t(grid.y) + std::size_t(y)) * std::size_t(grid.x) +
                    std::size_t(x);
                if (!originals_.contains(number)) {
                    const glm::ivec3 lo = glm::ivec3(x, y, z) * field::kBrick;
                    const Box3 box = intersect({lo, lo + field::kBrick}, whole);
                    originals_.emplace(number, Original{box, texture_->download(box)});
                }
            }
        }
    }
}

Box3 BrickBackup::restore() {
    const gl::Pass pass("restore bricks");
    Box3 all;
    for (const auto& [number, original] : originals_) {
        texture_->upload(original.box, original.bytes);
        all = unite(all, original.box);
    }
    return all;
}

BrickDelta BrickBackup::finish() {
    const gl::Pass pass("finish bricks");
    DeltaMaker maker(*texture_);
    for (const auto& [number, original] : originals_) {
        const auto current = texture_->download(original.box);
        if (current != original.bytes) {
            maker.add(original.box, original.bytes, current);
        }
    }
    BrickDelta delta = maker.finish();
    originals_.clear();
    return delta;
}

} // namespace vs::sculpt
