// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/bench_measure.h"
#include "bench/bench_scenarios.h"

#include "studio/document/document.h"

#include <vector>

namespace vs::cli {

// A ball of 54 voxels' radius in the middle of a cube of `side` voxels: the same work for a stroke in
// whatever volume.
volume::Volume ballIn(int side);

// Live strokes where the surface is met near the picture's middle, from pen-down on, surfaces included: drill
// stamps of 100 x 100 mask elements, one peel layer of 300 x 300, and a peel drawn down from 0.1 to 20 layers
// under a circle of 300 pixels and back. Every stroke is taken back. Returns false if no surface is met.
bool benchStrokes(const BenchSettings& settings, studio::Document& document,
                  std::vector<Measurement>& results);

} // namespace vs::cli
