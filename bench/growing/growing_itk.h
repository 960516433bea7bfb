// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "growing_cases.h"

namespace vs {

// What another way of growing took.
struct PeerRun {
    double milliseconds = 0;
    std::uint64_t voxels = 0;
};

// One run of a new itk::ConnectedThresholdImageFilter over the case's own values, in their own type and
// place: no copy, no cast. Timed is Update(), which allocates the labels (uint8).
PeerRun growWithItk(const GrowingCase& task);

} // namespace vs
