// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/tool_limits.h"

#include "base/error.h"
#include "segment/finer/fine_growth.h"
#include "segment/membership/set_membership.h"

#include <algorithm>
#include <array>
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

// The voxels of the finest level that have a look, wherever they are asked for.
segment::MaskIn maskOf(segment::Look look, const segment::Looks& looks, const segment::FineGrowth& growth) {
    return [look, looks, labels = growth.labelReader(), isEmpty = growth.emptyBoxes()](const Box3& box) {
        std::vector<std::uint8_t> mask;
        if (isEmpty(box)) {
            return mask;
        }
        mask = labels(box);
        bool isAny = false;
        for (std::uint8_t& voxel : mask) {
            voxel = looks[voxel] == look ? 1 : 0;
            isAny = isAny || voxel != 0;
        }
        return isAny ? mask : std::vector<std::uint8_t>();
    };
}

// What tools keep to that work on the finest level: what has grown there, or what the scene knows.
std::shared_ptr<const sculpt::Limits::InBox>
finestLimits(const Contents& contents, const segment::Looks& looks, const gl::Texture& memberships) {
    const sculpt::FineSculpture* finer = contents.sculpture.finer();
    const segment::FineGrowth* growth = contents.region.finest();
    if (finer == nullptr || growth == nullptr) {
        return finer == nullptr ? nullptr : sculpt::betweenVoxels(memberships, finer->grid());
    }
    const std::array<segment::MaskIn, 2> masks{maskOf(segment::Look::Opaque, looks, *growth),
                                               maskOf(segment::Look::Translucent, looks, *growth)};
    const glm::dvec3 spacing = contents.region.geometry().spacing();
    return std::make_shared<const sculpt::Limits::InBox>(
        [masks, dims = finer->dims(), spacing](const Box3& box) {
            std::vector<std::byte> bytes;
            for (std::size_t channel = 0; channel < masks.size(); ++channel) {
                const auto values = segment::membershipOf(masks[channel], dims, box, spacing);
                bytes.resize(std::max(bytes.size(), masks.size() * values.size()));
                for (std::size_t i = 0; i < values.size(); ++i) {
                    bytes[masks.size() * i + channel] = std::byte(values[i]);
                }
            }
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
