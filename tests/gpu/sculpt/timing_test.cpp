// SPDX-License-Identifier: Apache-2.0
#include "base/timer.h"
#include "gl/pass.h"
#include "tool_fixture.h"

#include <fmt/format.h>

namespace vs::sculpt {
namespace {

using ToolTiming = test::GlTest;

// How long one stamp takes and where the time goes, printed; the times are not asserted.
void timeStamp(const char* name, test::Workpiece& piece, const std::vector<field::SurfacePoint>& surface,
               const MaskRaster& mask, const ToolCut& how) {
    piece.cut(surface, mask, how); // compiles what is compiled when first needed
    const Timer whole;
    constexpr int kTimes = 5;
    for (int n = 0; n < kTimes; ++n) {
        piece.cut(surface, mask, how);
        gl::Context::finish();
    }
    const double each = whole.milliseconds() / kTimes;
    const Timer sweepTimer;
    const auto patches = sweepSurface(surface, mask, piece.geometry, how.sweep);
    fmt::print("{}: {:.1f} ms ({} x {} elements, {} patches, {} points; sweeping on the CPU {:.1f} ms)\n",
               name, each, mask.size.x, mask.size.y, patches.patches().size(), patches.pointCount(),
               sweepTimer.milliseconds());
    gl::Pass::enableTiming(true);
    gl::Pass::resetTimes();
    piece.cut(surface, mask, how);
    for (const auto& [pass, time] : gl::Pass::times()) {
        fmt::print("    {:24} {:6.2f} ms\n", pass, time.milliseconds);
    }
    gl::Pass::enableTiming(false);
    EXPECT_GT(patches.pointCount(), 0U);
}

TEST_F(ToolTiming, DrillStamp) {
    test::Workpiece piece({160, 160, 96});
    const auto mask = rasterize(circleOutline({80, 80}, 24), 0.5); // 100 x 100 elements
    timeStamp("drill, depth 10", piece, test::slabUnder(mask, 30), mask, test::drill(10));
    const auto coarse = rasterize(circleOutline({80, 80}, 33), 0.7);
    timeStamp("drill, depth 10", piece, test::slabUnder(coarse, 30), coarse, test::drill(10));
}

TEST_F(ToolTiming, PeelLayer) {
    test::Workpiece piece({256, 256, 128});
    const auto mask = rasterize(circleOutline({128, 128}, 74), 0.5); // 300 x 300 elements
    timeStamp("peel, 1 layer", piece, test::sphereUnder(mask, {128, 128, 130}, 120), mask, test::peel(1));
}

TEST_F(ToolTiming, Mask) {
    const auto outline = ellipseOutline({200, 200}, {195, 190});
    const Timer timer;
    const auto mask = rasterize(outline, 1);
    fmt::print("mask of {} x {}: {:.1f} ms\n", mask.size.x, mask.size.y, timer.milliseconds());
    EXPECT_GT(mask.size.x, 390);
}

} // namespace
} // namespace vs::sculpt
