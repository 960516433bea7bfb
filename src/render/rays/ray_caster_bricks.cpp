// SPDX-License-Identifier: Apache-2.0
// Pictures of finer levels than the scene's, from bricks that are read while rays ask for them.
#include "base/error.h"
#include "base/timer.h"
#include "render/rays/ray_caster.h"

#include <algorithm>

namespace vs::render {

namespace {

constexpr double kLookMs = 25; // between looks whether something has been read

} // namespace

// A pixel asks for voxels as large as itself where it is nearest to the volume.
void RayCaster::chooseLevel() {
    level_.reset();
    squaresAtOnce_ = 0;
    if (frame_.detail != nullptr && frame_.scene.smoothed == nullptr) {
        const auto& geometry = frame_.scene.data->geometry;
        level_ = frame_.detail->levelFor(leastPixelMm(frame_.rays, geometry) / geometry.stepMm());
    }
    if (!level_) {
        frame_.detail = nullptr;
        return;
    }
    frame_.detail->use(*level_);
    const glm::ivec2 size = frame_.rays.size;
    if (glm::ivec2(rounds_.size()) != size) {
        rounds_ = gl::Texture(size, gl::Format::R32UI, gl::Filter::Nearest, "rounds");
    }
    rounds_.clear();
}

// Steps between samples of the data: as many to a voxel of the level that is drawn as to one of the scene.
double RayCaster::sampleStep() const {
    return frame_.sampleStep * (frame_.detail != nullptr ? frame_.detail->step() : 1);
}

int RayCaster::castRound() const { return sample_ * int(stages()) + int(stage_) + 1; }

// Whether rays of the squares that were just cast have met missing bricks. Then some have come meanwhile, or
// so much time has passed.
bool RayCaster::awaitsBricks(const Part& part, int count, double milliseconds) {
    field::Detail& detail = *frame_.detail;
    const auto& geometry = part.scene.data->geometry;
    if (detail.endRound(glm::dvec3(geometry.voxelFromWorld() * glm::dvec4(part.rays.eye, 1))) == 0) {
        return false;
    }
    const Timer waiting;
    bool hasCome = detail.deliver(0);
    while (!hasCome && !detail.isFull() && waiting.milliseconds() < milliseconds) {
        hasCome = detail.deliver(std::min(milliseconds - waiting.milliseconds(), kLookMs));
    }
    if (detail.isFull() && !hasCome) {
        if (count == 1) {
            throw GlError("the bricks that rays of a few pixels go through do not fit into {} MiB; give "
                          "--device-memory more",
                          detail.deviceBytes() >> 20);
        }
        squaresAtOnce_ = std::max(count / 4, 1);
    }
    return true;
}

} // namespace vs::render
