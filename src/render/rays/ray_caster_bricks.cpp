// SPDX-License-Identifier: Apache-2.0
// Pictures of finer levels than the scene's, from bricks that are read while rays ask for them.
#include "base/timer.h"
#include "render/rays/ray_caster.h"

#include <fmt/format.h>

#include <algorithm>

namespace vs::render {

namespace {

constexpr double kLookMs = 25;      // between looks whether something has been read
constexpr double kTogetherMs = 100; // bricks that come one after the other are waited for
constexpr int kSquaresOfGroup = 1024;

} // namespace

// A pixel asks for voxels as large as itself where it is nearest to the volume.
void RayCaster::chooseLevel() {
    level_.reset();
    if (frame_.detail != nullptr && frame_.scene.smoothed == nullptr) {
        const auto& geometry = frame_.scene.data->geometry;
        level_ = frame_.detail->levelFor(leastPixelMm(frame_.rays, geometry) / geometry.stepMm());
    }
    takeLevel();
}

void RayCaster::takeLevel() {
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

// Asks for the bricks that rays of the squares that were just cast have missed, if there are any.
bool RayCaster::missesBricks(const Part& part, int count) {
    const auto& geometry = part.scene.data->geometry;
    const glm::dvec3 viewer(geometry.voxelFromWorld() * glm::dvec4(part.rays.eye, 1));
    if (frame_.detail->endRound(viewer) == 0) {
        awaited_ = 0;
        squaresAtOnce_ = std::min(2 * squaresAtOnce_, kAllSquares);
        return false;
    }
    awaited_ = count;
    haveSomeCome_ = false;
    awaiting_ = Timer();
    return true;
}

// Waits until all have come, or for some time until some have: squares are not cast again for each of them.
bool RayCaster::haveBricksCome(double milliseconds) {
    field::Detail& detail = *frame_.detail;
    const Timer waiting;
    const auto isEnough = [&] {
        return detail.coming() == 0 || detail.isFull() ||
               (haveSomeCome_ && awaiting_.milliseconds() > kTogetherMs);
    };
    do {
        const double left = milliseconds - waiting.milliseconds();
        haveSomeCome_ = detail.deliver(std::clamp(left, 0.0, kLookMs)) || haveSomeCome_;
    } while (!isEnough() && waiting.milliseconds() < milliseconds);
    if (detail.isFull() && !haveSomeCome_) {
        return makeDo();
    }
    return isEnough();
}

// There is no room for the bricks of all squares at once, or of a single one. Whether to cast them again.
bool RayCaster::makeDo() {
    if (awaited_ > 1) {
        squaresAtOnce_ = std::max(awaited_ / 4, 1);
        return true;
    }
    frame_.detail->tell(
        fmt::format("bricks for {} MiB are too few for what rays meet: pictures are coarser than "
                    "their pixels ask for; give --device-memory more",
                    frame_.detail->deviceBytes() >> 20));
    level_ = frame_.detail->coarserThan(*level_);
    takeLevel();
    arrangeParts();
    begin();
    return false;
}

// Where a picture needs more bricks than there is room for, each sample of all of it would read all of them
// again. So, once it is known which squares need more than two samples, some squares take all of theirs
// before the next do; the first two samples go forth and back, so that the second begins with bricks that are
// there.
void RayCaster::beginGroups() {
    for (; sample_ < frame_.samples; ++sample_) {
        if (hasFilm()) {
            fillFilm();
        }
    }
    groupBegin_ = 0;
    groupEnd_ = std::min(kSquaresOfGroup, squares_.active());
    sample_ = isInGroups() ? kSettling : frame_.samples;
    hasBegunSample_ = true;
}

void RayCaster::endSampleOfGroup() {
    ++sample_;
    if (sample_ == frame_.samples && groupEnd_ == squares_.active()) {
        groupEnd_ = 0;
        square_ = 0;
        return;
    }
    if (sample_ == frame_.samples) {
        sample_ = kSettling;
        groupBegin_ = groupEnd_;
        groupEnd_ = std::min(groupBegin_ + kSquaresOfGroup, squares_.active());
    }
    square_ = groupBegin_;
}

bool RayCaster::goesBackwards() const { return frame_.detail != nullptr && !hasParts() && sample_ == 1; }

} // namespace vs::render
