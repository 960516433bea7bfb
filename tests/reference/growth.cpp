// SPDX-License-Identifier: Apache-2.0
#include "reference/growth.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace vs::reference {

bool QueueGrowth::isInGrid(glm::ivec3 v) const {
    return glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, dims_));
}

std::vector<glm::ivec3> QueueGrowth::neighbours(glm::ivec3 voxel) const {
    std::vector<glm::ivec3> found;
    for (int n = 0; n < 27; ++n) {
        const glm::ivec3 offset = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
        const int apart = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z);
        if (apart != 0 && (apart == 1 || cornersTouch_) && isInGrid(voxel + offset)) {
            found.push_back(voxel + offset);
        }
    }
    return found;
}

void QueueGrowth::setRules(Admits admits, bool cornersTouch, AdmitsFrom admitsFrom) {
    truncate();
    admits_ = std::move(admits);
    admitsFrom_ = std::move(admitsFrom);
    cornersTouch_ = cornersTouch;
    if (isLive_) {
        retract();
    }
    reinstateSeeds();
    requeueAll();
}

void QueueGrowth::addSeeds(std::span<const glm::ivec3> seeds) {
    std::vector<glm::ivec3> entering;
    for (const glm::ivec3 seed : seeds) {
        if (isInGrid(seed) && admits_(seed)) {
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
    for (const glm::ivec3 seed : entering) {
        isForbidden_[indexOf(seed)] = false;
    }
    enter(entering);
    for (const glm::ivec3 seed : seeds) {
        if (isInGrid(seed)) {
            seeds_.push_back({seed, playhead_});
        }
    }
}

void QueueGrowth::enter(const std::vector<glm::ivec3>& seeds) {
    playhead_ = std::max({1, playhead_, frozen_ + 1});
    extent_ = playhead_;
    for (const glm::ivec3 seed : seeds) {
        if (generations_[indexOf(seed)] == 0) { // else offered twice
            generations_[indexOf(seed)] = std::uint32_t(playhead_);
            queue_.push_back(seed);
        }
    }
}

void QueueGrowth::reinstateSeeds() {
    std::vector<glm::ivec3> entering;
    for (const Seed& seed : seeds_) {
        if (generations_[indexOf(seed.voxel)] == 0 && admits_(seed.voxel) &&
            !isForbidden_[indexOf(seed.voxel)]) {
            entering.push_back(seed.voxel);
        }
    }
    if (!entering.empty()) {
        enter(entering);
    }
}

// Keeps what a queue reaches from the seeds under the present rules, within what has grown.
void QueueGrowth::retract() {
    std::vector<bool> isKept(count(), false);
    std::vector<glm::ivec3> open;
    const auto keep = [&](glm::ivec3 v) {
        const std::size_t i = indexOf(v);
        if (!isKept[i] && int(generations_[i]) > frozen_ && admits_(v)) {
            isKept[i] = true;
            open.push_back(v);
        }
    };
    for (const Seed& seed : seeds_) {
        keep(seed.voxel);
    }
    while (!open.empty()) {
        const glm::ivec3 parent = open.back();
        open.pop_back();
        for (const glm::ivec3 child : neighbours(parent)) {
            if (!admitsFrom_ || admitsFrom_(parent, child)) {
                keep(child);
            }
        }
    }
    for (std::size_t i = 0; i < generations_.size(); ++i) {
        generations_[i] = isKept[i] || int(generations_[i]) <= frozen_ ? generations_[i] : 0;
    }
}

int QueueGrowth::absorb(std::span<const glm::ivec3> voxels, int expansions) {
    truncate();
    std::vector<glm::ivec3> newest;
    const auto take = [&](glm::ivec3 v, std::vector<glm::ivec3>& list) {
        if (generations_[indexOf(v)] != 0) {
            generations_[indexOf(v)] = 0;
            isForbidden_[indexOf(v)] = true;
            list.push_back(v);
        }
    };
    for (const glm::ivec3 v : voxels) {
        if (isInGrid(v)) {
            take(v, newest);
        }
    }
    int found = 0;
    for (bool goesOn = true; goesOn && found < expansions; found += goesOn ? 1 : 0) {
        std::vector<glm::ivec3> next;
        for (const glm::ivec3 v : newest) {
            for (const glm::ivec3 neighbour : neighbours(v)) {
                take(neighbour, next);
            }
        }
        goesOn = !next.empty();
        newest = std::move(next);
    }
    requeueAll();
    return found;
}

void QueueGrowth::replace(const std::vector<std::uint8_t>& inside) {
    truncate();
    playhead_ = extent_ = frozen_ = std::max(1, playhead_);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const std::uint32_t now = generations_[i] != 0 ? generations_[i] : std::uint32_t(playhead_);
        generations_[i] = inside[i] != 0 ? now : 0;
    }
    seeds_.clear();
    requeueAll();
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
    seeds_.clear();
    isForbidden_.assign(count(), false);
}

void QueueGrowth::truncate() {
    if (playhead_ == extent_) {
        return;
    }
    for (std::uint32_t& g : generations_) {
        g = int(g) > playhead_ ? 0 : g;
    }
    std::erase_if(seeds_, [&](const Seed& seed) { return seed.generation > playhead_; });
    extent_ = playhead_;
    frozen_ = std::min(frozen_, playhead_);
    requeueAll();
}

void QueueGrowth::requeueAll() {
    queue_.clear();
    for (int z = 0; z < dims_.z; ++z) {
        for (int y = 0; y < dims_.y; ++y) {
            for (int x = 0; x < dims_.x; ++x) {
                if (int(generations_[indexOf({x, y, z})]) > frozen_) {
                    queue_.emplace_back(x, y, z);
                }
            }
        }
    }
}

bool QueueGrowth::expand() {
    std::vector<glm::ivec3> next;
    for (const glm::ivec3 parent : queue_) {
        for (const glm::ivec3 child : neighbours(parent)) {
            const std::size_t i = indexOf(child);
            if (generations_[i] == 0 && !isForbidden_[i] && admits_(child) &&
                (!admitsFrom_ || admitsFrom_(parent, child))) {
                generations_[i] = std::uint32_t(extent_ + 1);
                next.push_back(child);
            }
        }
    }
    queue_ = std::move(next);
    return !queue_.empty();
}

} // namespace vs::reference
