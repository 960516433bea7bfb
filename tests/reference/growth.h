// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <vector>

namespace vs::reference {

// Region growing with a plain queue, one voxel after another: what growth on the device must equal,
// generation by generation. Suspended voxels are not kept in a list of their own: after a change of the rules
// every grown voxel is put into the queue again, so all refused neighbours are offered again.
class QueueGrowth {
public:
    using Admits = std::function<bool(glm::ivec3)>;
    using AdmitsFrom = std::function<bool(glm::ivec3 parent, glm::ivec3 child)>;

    explicit QueueGrowth(glm::ivec3 dims)
        : dims_(dims), generations_(count(), 0), isForbidden_(count(), false) {}

    // `admitsFrom`: rules that ask for the parent too; none when empty.
    void setRules(Admits admits, bool cornersTouch, AdmitsFrom admitsFrom = {});
    void setLive(bool isLive) { isLive_ = isLive; }
    void addSeeds(std::span<const glm::ivec3> seeds);
    // Expands by whole generations; returns how many there were.
    int advance(int generations);
    void takeBack(int generations) { playhead_ = std::max(0, playhead_ - generations); }
    void setPlayhead(int generation) { playhead_ = std::clamp(generation, 0, extent_); }
    // Targeted shrink; returns the expansions that found something.
    int absorb(std::span<const glm::ivec3> voxels, int expansions);
    // Makes the region another one (one byte a voxel of the grid).
    void replace(const std::vector<std::uint8_t>& inside);
    void reset();

    [[nodiscard]] int playhead() const { return playhead_; }
    [[nodiscard]] int extent() const { return extent_; }
    [[nodiscard]] const std::vector<std::uint32_t>& generations() const { return generations_; }

private:
    struct Seed {
        glm::ivec3 voxel{0};
        int generation = 0;
    };

    [[nodiscard]] std::size_t count() const {
        return std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z);
    }
    [[nodiscard]] std::size_t indexOf(glm::ivec3 v) const {
        return (std::size_t(v.z) * std::size_t(dims_.y) + std::size_t(v.y)) * std::size_t(dims_.x) +
               std::size_t(v.x);
    }
    [[nodiscard]] bool isInGrid(glm::ivec3 v) const;
    [[nodiscard]] std::vector<glm::ivec3> neighbours(glm::ivec3 voxel) const;
    void truncate();
    void requeueAll();
    void retract();
    void reinstateSeeds();
    void enter(const std::vector<glm::ivec3>& seeds);
    [[nodiscard]] bool expand();

    glm::ivec3 dims_;
    std::vector<std::uint32_t> generations_;
    std::vector<bool> isForbidden_;
    std::vector<glm::ivec3> queue_;
    std::vector<Seed> seeds_;
    Admits admits_;
    AdmitsFrom admitsFrom_;
    bool cornersTouch_ = false;
    bool isLive_ = false;
    int frozen_ = 0;
    int playhead_ = 0;
    int extent_ = 0;
};

} // namespace vs::reference
