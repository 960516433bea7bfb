// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/tool_limits.h"

#include "base/error.h"
#include "base/progress.h"

#include <algorithm>

namespace vs::studio {

namespace {

constexpr double kPortionMs = 100; // between asking whether to go on

using Treatment = SegmentInfo::Treatment;

// What is spared shows in the first channel of the smooth volume, what alone is taken in the second.
segment::Looks looksFor(const SegmentList& list) {
    segment::Looks looks{};
    for (const SegmentInfo& segment : list.segments) {
        looks[segment.label] = segment.isSpared()                         ? segment::Look::Opaque
                               : segment.treatment == Treatment::TakeOnly ? segment::Look::Translucent
                                                                          : segment::Look::Hidden;
    }
    return looks;
}

void requireSomethingToTake(const Contents& contents, const segment::Looks& looks) {
    const SegmentInfo* empty = nullptr;
    for (const SegmentInfo& segment : contents.segments.segments) {
        if (looks[segment.label] == segment::Look::Translucent) {
            if (contents.region.voxelCount(segment.label) > 0) {
                return;
            }
            empty = &segment;
        }
    }
    if (empty != nullptr) {
        throw Error("tools take only '{}', which is empty: there is nothing to cut; let them take all, or "
                    "fill it first",
                    empty->name);
    }
}

} // namespace

void updateWholly(segment::Segmentation& segmentation, const segment::Growth& growth,
                  const segment::Looks& looks) {
    do {
        segmentation.update(growth, segment::Smoothing::Smooth, looks, kPortionMs);
        reportProgress();
    } while (segmentation.isBehind());
}

sculpt::Limits ToolLimits::find(const Contents& contents) {
    const segment::Looks looks = looksFor(contents.segments);
    requireSomethingToTake(contents, looks);
    const auto has = [&looks](segment::Look look) {
        return std::find(looks.begin(), looks.end(), look) != looks.end();
    };
    const bool takesOnly = has(segment::Look::Translucent);
    if ((!takesOnly && !has(segment::Look::Opaque)) || !contents.region.exists()) {
        return {};
    }
    if (!memberships_ || serial_ != contents.scan.field.serial) {
        memberships_.emplace(contents.scan.volume.geometry);
        serial_ = contents.scan.field.serial;
    }
    updateWholly(*memberships_, *contents.region.growth(), looks);
    return {&memberships_->texels(), takesOnly};
}

} // namespace vs::studio
