// SPDX-License-Identifier: Apache-2.0
#include "field/histogram.h"
#include "gpu/studio/test_tools.h"

namespace vs::studio {
namespace {

using VisibleHistogramTest = test::GlTest;
using Counts = std::vector<std::uint32_t>;

// What is counted when every voxel is looked at.
Counts countsOfAll(Document& document) {
    field::VisibleHistogram counting(document.field(), int(document.histogram().size()));
    counting.start(document.view().sculptureView);
    while (!counting.advance(document.sculpture().texels(), 0)) {
    }
    return counting.counts();
}

Counts counted(Document& document) {
    const Counts* counts = nullptr;
    while (counts == nullptr) {
        counts = document.visibleHistogram(0);
    }
    return *counts;
}

void look(Document& document, field::SculptureView at) {
    View view = document.view();
    view.sculptureView = at;
    document.showView(view);
}

TEST_F(VisibleHistogramTest, LooksOnlyWhereSomethingWasCutAndCountsAll) {
    Head head;
    EXPECT_EQ(counted(head), head.histogram()) << "nothing is cut";
    look(head, field::SculptureView::Probe);
    EXPECT_EQ(counted(head), Counts(head.histogram().size())) << "nothing is seen";
    const Operation drilled = penAt<Drill>(200, 140, 8);
    for (const Operation& operation : {drilled, Operation(Undo{}), Operation(Redo{}),
                                       Operation(scissorsAt(210, 150, 12)), Operation(UnCut{}), drilled}) {
        head.apply(operation);
        for (const auto view : {field::SculptureView::Cut, field::SculptureView::Probe}) {
            look(head, view);
            EXPECT_EQ(counted(head), countsOfAll(head)) << name(operation);
        }
    }
    look(head, field::SculptureView::Whole);
    EXPECT_EQ(counted(head), head.histogram());
}

} // namespace
} // namespace vs::studio
