// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"
#include "studio/state/region.h"
#include "studio/strokes/cut_stroke.h"

#include <vector>

namespace vs::studio {

// Removes what is not connected to what is under a pixel, at the level that segments grow at.
class KeepConnectedStroke : public CutStroke {
public:
    // `operation` has its canvas set. Throws Error when nothing in range is under the pixel, or in probe view
    // of something cut, where there is nothing left to cut.
    KeepConnectedStroke(Cutter& cutter, const MakeFrame& makeFrame, Region& region,
                        const KeepConnected& operation);
    void replay() override;

private:
    [[nodiscard]] field::SurfacePoints underPixel();
    void cutAtScene(const segment::Constraints& constraints);
    void cutAtFinest(const segment::Constraints& constraints);
    // Where it begins at the finest level; what was found is written into the operation.
    std::vector<glm::ivec3> seedsIn(FinestRegion& finest, const segment::Constraints& constraints);
    // Cuts what else of the finest level is seen.
    void cutAllBut(const segment::FineSet& kept, const FinestRegion& finest, const Range& range);

    render::Frame frame_;
    Region* region_;
};

} // namespace vs::studio
