// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/brick_backup.h"

#include "base/check.h"
#include "field/field.h"
#include "gl/pass.h"
#include "sculpt/sculpture/brick_codec.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

constexpr std::size_t kBricksTogether = 16; // in one encoding

} // namespace

void BrickDelta::swap(gl::Texture& texture) {
    const gl::Pass pass("swap bricks");
    const std::size_t texelBytes = gl::bytesPerTexel(texture.format());
    std::vector<std::byte> other;
    std::vector<std::size_t> otherEnds;
    for (std::size_t first = 0; first < bricks_.size(); first += kBricksTogether) {
        const std::size_t group = first / kBricksTogether;
        const std::size_t begin = group == 0 ? 0 : ends_[group - 1];
        VS_CHECK(ends_[group] <= held_.size()); // else they were never given back
        BrickDecoder decoder(texelBytes, std::span(held_).subspan(begin, ends_[group] - begin));
        BrickEncoder encoder(texelBytes);
        for (std::size_t n = first; n < std::min(first + kBricksTogether, bricks_.size()); ++n) {
            const auto current = texture.download(bricks_[n]);
            auto wanted = current;
            decoder.next(bricks_[n].size(), wanted);
            encoder.add(bricks_[n].size(), current, wanted);
            texture.upload(bricks_[n], wanted);
        }
        const auto encoded = encoder.finish();
        other.insert(other.end(), encoded.begin(), encoded.end());
        otherEnds.push_back(other.size());
    }
    other.shrink_to_fit();
    held_ = std::move(other);
    ends_ = std::move(otherEnds);
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
    const std::size_t texelBytes = gl::bytesPerTexel(texture_->format());
    BrickDelta delta;
    BrickEncoder encoder(texelBytes);
    const auto endGroup = [&] {
        const auto encoded = encoder.finish();
        delta.held_.insert(delta.held_.end(), encoded.begin(), encoded.end());
        delta.ends_.push_back(delta.held_.size());
        encoder = BrickEncoder(texelBytes);
    };
    for (const auto& [number, original] : originals_) {
        const auto current = texture_->download(original.box);
        if (current == original.bytes) {
            continue;
        }
        delta.changedVoxels_ += encoder.add(original.box.size(), original.bytes, current);
        delta.bricks_.push_back(original.box);
        if (delta.bricks_.size() % kBricksTogether == 0) {
            endGroup();
        }
    }
    if (delta.bricks_.size() % kBricksTogether != 0) {
        endGroup();
    }
    delta.held_.shrink_to_fit();
    originals_.clear();
    return delta;
}

} // namespace vs::sculpt
