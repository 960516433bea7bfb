// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/tool_limits.h"

#include "base/error.h"
#include "segment/finer/fine_growth.h"
#include "segment/membership/set_membership.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace vs::studio {

namespace {

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

// The voxels of the finest level that have a look, together.
segment::FineSet finestWith(segment::Look look, const segment::Looks& looks,
                            const segment::FineGrowth& growth, glm::ivec3 dims) {
    segment::FineSet all(dims);
    for (std::size_t label = 1; label < looks.size(); ++label) {
        if (looks[label] == look) {
            all = unite(all, growth.voxels(std::uint8_t(label)));
        }
    }
    return all;
}

// What tools keep to that work on the finest level: what has grown there, or what the scene knows.
std::shared_ptr<const sculpt::Limits::InBox>
finestLimits(const Contents& contents, const segment::Looks& looks, const gl::Texture& memberships) {
    const sculpt::FineSculpture* finer = contents.sculpture.finer();
    const segment::FineGrowth* growth = contents.region.finest();
    if (finer == nullptr || growth == nullptr) {
        return finer == nullptr ? nullptr : sculpt::betweenVoxels(memberships, finer->grid());
    }
    const auto spared = finestWith(segment::Look::Opaque, looks, *growth, finer->dims());
    const auto taken = finestWith(segment::Look::Translucent, looks, *growth, finer->dims());
    const glm::dvec3 spacing = contents.region.geometry().spacing();
    return std::make_shared<const sculpt::Limits::InBox>([spared, taken, spacing](const Box3& box) {
        std::vector<std::byte> bytes;
        const auto put = [&](const segment::FineSet& set, std::size_t channel) {
            const std::vector<std::uint8_t> values = segment::membershipOf(set, box, spacing);
            bytes.resize(std::max(bytes.size(), 2 * values.size()));
            for (std::size_t i = 0; i < values.size(); ++i) {
                bytes[2 * i + channel] = std::byte(values[i]);
            }
        };
        put(spared, 0);
        put(taken, 1);
        return bytes;
    });
}

} // namespace

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
    return {&memberships_->texels(), takesOnly, finestLimits(contents, looks, memberships_->texels())};
}

} // namespace vs::studio
