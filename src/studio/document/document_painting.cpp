// SPDX-License-Identifier: Apache-2.0
// Round brushes in the volume: what lies under them, and segments painted with them.
#include "studio/document/document_change.h"

namespace vs::studio {

segment::VoxelSet Document::Impl::voxelsUnder(const Trail& trail, const std::optional<Range>& range) const {
    segment::VoxelSet set = voxelsAlong(trail, volume.geometry);
    for (std::size_t i = 0; range && i < set.inside.size(); ++i) {
        if (set.inside[i] != 0 && !range->contains(volume.at(set.voxelAt(i)))) {
            set.inside[i] = 0;
        }
    }
    return set;
}

void Document::Impl::perform(const PaintSegment& op, Region::Records& records) {
    workUnlocked(records);
    region.paint(voxelsUnder(op.trail, op.range), op.isToAdd, records);
}

Outcome Document::Impl::run(PaintSegment& op, const std::filesystem::path&) {
    if (voxelsUnder(op.trail, op.range).count() == 0) {
        return {{}, 0, 0, say(VS_TEXT("library", "nothing changed: no voxel lies under the brush"))};
    }
    const std::size_t before = grownVoxels();
    change(op);
    const std::size_t now = grownVoxels();
    const std::size_t changed = now > before ? now - before : before - now;
    return {{},
            0,
            changed,
            changed == 0 ? say(VS_TEXT("library",
                                       "nothing changed: no voxel under the brush could be added or removed"))
                         : describeChange(before, now)};
}

} // namespace vs::studio
