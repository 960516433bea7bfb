// SPDX-License-Identifier: Apache-2.0
#include "gl/dispatch_pace.h"

#include "property.h"

#include <algorithm>
#include <limits>

namespace vs::gl {
namespace {

constexpr std::size_t kPerLayer = std::size_t(512) * 512;

TEST(DispatchPaceTest, AllAtOnceWhereNothingIsTooLong) {
    const DispatchPace pace(std::numeric_limits<double>::infinity());
    EXPECT_EQ(pace.layers(512, kPerLayer), 512);
}

TEST(DispatchPaceTest, ALayerAtATimeWhereAllIsTooLong) {
    EXPECT_EQ(DispatchPace(0).layers(512, 1), 1);
    DispatchPace pace(100);
    EXPECT_EQ(pace.layers(512, 1), 512) << "so few are always soon done";
    pace.note(1000, 1000);
    EXPECT_EQ(pace.layers(512, kPerLayer), 1);
}

// Whatever a device takes for an invocation, and whatever it was busy with at first: no submission after the
// first two lasts longer than it may but one of a single layer, all are done, and what is soon done is
// submitted at once in the end.
TEST(DispatchPaceTest, SubmissionsAreAsLongAsTheyMayBe) {
    test::checkProperty(200, [] {
        const double longestMs = 100;
        DispatchPace pace(longestMs);
        const double nanos = *test::between(0.001, 50);
        const double busyMs = *test::between(0, 40);
        const int layers = 1 + *test::below(1000);
        const auto perLayer = std::size_t(1 + *test::below(300000));
        for (int dispatch = 0; dispatch < 30; ++dispatch) {
            int submissions = 0;
            for (int done = 0; done < layers; ++submissions) {
                const int now = pace.layers(layers - done, perLayer);
                RC_ASSERT(now >= 1);
                RC_ASSERT(now <= layers - done);
                const double ms = nanos * 1e-6 * double(now) * double(perLayer);
                RC_ASSERT((now == 1 || ms <= 1.01 * longestMs || (dispatch == 0 && submissions == 0)));
                pace.note(std::size_t(now) * perLayer, ms + (dispatch + submissions == 0 ? busyMs : 0));
                done += now;
            }
            const double allMs = nanos * 1e-6 * double(layers) * double(perLayer);
            RC_ASSERT((dispatch < 29 || submissions <= std::max(1.0, 2.1 * allMs / longestMs + 1)));
        }
    });
}

} // namespace
} // namespace vs::gl
