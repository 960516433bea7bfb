// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "growing_cases.h"
#include "segment/growth/frontier.h"

namespace vs {

// One region grown by us, by ITK and by a scanline fill, in turns. Times in milliseconds, one a run.
struct Comparison {
    std::string name;
    std::uint64_t voxels = 0;
    int generations = 0;
    double setUp = 0;           // once a volume: upload, seed map, compiling
    std::vector<double> ours;   // from seeds to the last generation, the device waited for
    std::vector<double> resets; // erasing what was grown, between runs
    std::vector<double> itk;
    std::vector<double> scanlines;
};

// A region grown afresh, and then on after its range was widened.
struct ChangeCost {
    std::string name;
    Range range;
    Range wider;
    std::uint64_t voxels = 0;
    std::uint64_t more = 0;
    std::vector<double> fresh;
    std::vector<double> change;
};

// Moving the playhead anywhere in what was grown and bringing the segmentation up to date without smoothing.
struct ScrubCost {
    std::string name;
    std::uint64_t voxels = 0;
    int generations = 0;
    std::vector<double> moves;
};

// Each needs a current context. One run that does not count comes first. Throws Error when the regions have
// different sizes.
Comparison compareWithOthers(const GrowingCase& task, segment::GrowthEngine engine, int runs);
// Without a wider range of its own, the case's is the wider one, and growth starts within one whose lower end
// is raised until the region loses 1 %.
ChangeCost measureChange(const GrowingCase& task, segment::GrowthEngine engine, int runs);
// Generations are picked at random, the same ones each time.
ScrubCost measureScrubbing(const GrowingCase& task, segment::GrowthEngine engine, int moves);

} // namespace vs
