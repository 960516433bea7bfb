// SPDX-License-Identifier: Apache-2.0
#include "growing_measure.h"

#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "growing_itk.h"
#include "growing_scanline.h"
#include "phantom/noise.h"
#include "segment/growth/growth.h"
#include "segment/membership/segmentation.h"

#include <limits>

namespace vs {

namespace {

constexpr int kToTheEnd = std::numeric_limits<int>::max();

// The time until the device has done `work`.
template <typename Work>
double timed(const Work& work) {
    gl::Context::finish();
    const Timer timer;
    work();
    gl::Context::finish();
    return timer.milliseconds();
}

// A case on the device.
class Grower {
public:
    Grower(const GrowingCase& task, segment::GrowthEngine engine)
        : task_(task), field_(field::uploadVolume(task.volume)), growth_(field_, engine) {
        field_.onHost = &task.volume;
        restrict(task.range);
    }
    double restrict(const Range& range) {
        segment::Constraints constraints;
        constraints.range = range;
        return timed([&] { growth_.setConstraints(constraints); });
    }
    double grow() {
        return timed([&] {
            growth_.addSeeds(task_.seeds);
            growth_.advance(kToTheEnd);
        });
    }
    double reset() {
        return timed([&] { growth_.reset(); });
    }
    // The size of the region within another range. Leaves nothing grown and the case's own range.
    std::uint64_t sizeWithin(const Range& range) {
        reset();
        restrict(range);
        grow();
        const std::uint64_t voxels = growth_.voxelCount();
        reset();
        restrict(task_.range);
        return voxels;
    }
    // Grows on within another range.
    double widen(const Range& range) {
        return restrict(range) + timed([&] { growth_.advance(kToTheEnd); });
    }
    segment::Growth& growth() { return growth_; }

private:
    const GrowingCase& task_;
    field::Field field_;
    segment::Growth growth_;
};

// The case's range with its lower end raised, by whole values, to where the region loses 1 %.
Range onePercentNarrower(Grower& grower, const Range& range) {
    const auto wanted = std::uint64_t(double(grower.sizeWithin(range)) / 1.01);
    double wide = range.lo;
    double narrow = range.hi;
    while (narrow - wide > 1) {
        const double middle = std::floor(0.5 * (wide + narrow));
        (grower.sizeWithin({middle, range.hi}) > wanted ? wide : narrow) = middle;
    }
    return {narrow, range.hi};
}

} // namespace

Comparison compareWithOthers(const GrowingCase& task, segment::GrowthEngine engine, int runs) {
    Comparison result;
    result.name = task.name;
    const Timer timer;
    Grower grower(task, engine);
    grower.growth().addSeeds(task.seeds);
    grower.growth().advance(1);
    gl::Context::finish();
    result.setUp = timer.milliseconds();
    for (int run = 0; run <= runs; ++run) {
        const double reset = grower.reset();
        const double ours = grower.grow();
        const PeerRun itk = growWithItk(task);
        const PeerRun scanlines = growByScanlines(task);
        result.voxels = grower.growth().voxelCount();
        result.generations = grower.growth().extent();
        if (itk.voxels != result.voxels || scanlines.voxels != result.voxels) {
            throw Error("{}: {} voxels grown here, {} by ITK and {} by scanlines; they should be the same",
                        task.name, result.voxels, itk.voxels, scanlines.voxels);
        }
        if (run > 0) {
            result.resets.push_back(reset);
            result.ours.push_back(ours);
            result.itk.push_back(itk.milliseconds);
            result.scanlines.push_back(scanlines.milliseconds);
        }
    }
    return result;
}

ChangeCost measureChange(const GrowingCase& task, segment::GrowthEngine engine, int runs) {
    Grower grower(task, engine);
    ChangeCost result;
    result.name = task.name;
    result.range = task.wider ? task.range : onePercentNarrower(grower, task.range);
    result.wider = task.wider ? *task.wider : task.range;
    for (int run = 0; run <= runs; ++run) {
        grower.reset();
        grower.restrict(result.range);
        const double fresh = grower.grow();
        result.voxels = grower.growth().voxelCount();
        const double change = grower.widen(result.wider);
        result.more = grower.growth().voxelCount() - result.voxels;
        if (run > 0) {
            result.fresh.push_back(fresh);
            result.change.push_back(change);
        }
    }
    return result;
}

ScrubCost measureScrubbing(const GrowingCase& task, segment::GrowthEngine engine, int moves) {
    Grower grower(task, engine);
    grower.grow();
    segment::Segmentation segmentation(task.volume.geometry);
    ScrubCost result;
    result.name = task.name;
    result.voxels = grower.growth().voxelCount();
    result.generations = grower.growth().extent();
    const auto generationCount = std::uint64_t(result.generations);
    for (int move = 0; move <= moves; ++move) {
        const int generation = 1 + int(phantom::randomBits(std::uint64_t(move)) % generationCount);
        const double milliseconds = timed([&] {
            grower.growth().setPlayhead(generation);
            segmentation.update(grower.growth(), segment::Smoothing::Plain);
        });
        if (move > 0) { // the first one writes everything and compiles
            result.moves.push_back(milliseconds);
        }
    }
    return result;
}

} // namespace vs
