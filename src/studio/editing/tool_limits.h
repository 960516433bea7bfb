// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/sculpture.h"
#include "segment/membership/segmentation.h"
#include "studio/editing/contents.h"

#include <optional>

namespace vs::studio {

// Where the tools that cut may work: not in segments that are locked or spared, and, where there are segments
// that alone are taken, only in those (SegmentInfo). Keeps those segments' smooth volume, so that the next
// stroke costs what has changed in them.
class ToolLimits {
public:
    // What holds for a stroke that begins now; good until the next call. Throws Error when tools take only
    // segments that have no voxels.
    sculpt::Limits find(const Contents& contents);

private:
    std::optional<segment::Segmentation> memberships_; // made when first needed
    std::uint64_t serial_ = 0;                         // of the field that it was made for
};

} // namespace vs::studio
