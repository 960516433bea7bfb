// SPDX-License-Identifier: Apache-2.0
#include "reference/growth.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace vs::reference {

void QueueGrowth::setRules(Admits admits, bool cornersTouch) {
    truncate();
    admits_ = std::move(admits);
    cornersTouch_ = cornersTouch;
    requeueAll();
}

void QueueGrowth::addSeeds(std::span<const glm::ivec3> seeds) {
    std::vector<glm::ivec3> entering;
    for (const glm::ivec3 seed : seeds) {
        if (glm::all(glm::greaterThanEqual(seed, glm::ivec3(0))) && glm::all(glm::lessThan(seed, dims_)) &&
            admits_(seed)) {
            const std::uint32_t g = generations_[indexOf(seed)];
            if (g == 0 || int(g) > playhead_) {
                entering.push_back(seed);
            }
        }
    }
    if (entering.empty()) {
        return;
    }
    truncate();
    playhead_ = std::max(1, playhead_);
    extent_ = playhead_;
    for (const glm::ivec3 seed : entering) {
        if (generations_[indexOf(seed)] == 0) { // else offered twice
            generations_[indexOf(seed)] = std::uint32_t(playhead_);
            queue_.push_back(seed);
        }
    }
}

int QueueGrowth::advance(int generations) {
    const int before = playhead_;
    playhead_ += std::min(extent_ - playhead_, generations);
    while (playhead_ - before < generations && expand()) {
        playhead_ = ++extent_;
    }
    return playhead_ - before;
}

void QueueGrowth::reset() {
    playhead_ = 0;
    truncate();
}

void QueueGrowth::truncate() {
    if (playhead_ == extent_) {
        return;
    }
    for (std::uint32_t& g : generations_) {
        g = int(g) > playhead_ ? 0 : g;
    }
    extent_ = playhead_;
    requeueAll();
}

void QueueGrowth::requeueAll() {
    queue_.clear();
    for (int z = 0; z < dims_.z; ++z) {
        for (int y = 0; y < dims_.y; ++y) {
            for (int x = 0; x < dims_.x; ++x) {
                if (generations_[indexOf({x, y, z})] != 0) {
                    queue_.emplace_back(x, y, z);
                }
            }
        }
    }
}

bool QueueGrowth::expand() {
    std::vector<glm::ivec3> next;
    for (const glm::ivec3 parent : queue_) {
        for (int n = 0; n < 27; ++n) {
            const glm::ivec3 offset = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            const int apart = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z);
            const glm::ivec3 child = parent + offset;
            if (apart == 0 || (apart > 1 && !cornersTouch_) ||
                glm::any(glm::lessThan(child, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(child, dims_))) {
                continue;
            }
            if (generations_[indexOf(child)] == 0 && admits_(child)) {
                generations_[indexOf(child)] = std::uint32_t(extent_ + 1);
                next.push_back(child);
            }
        }
    }
    queue_ = std::move(next);
    return !queue_.empty();
}

} // namespace vs::reference
