// SPDX-License-Identifier: Apache-2.0
#include "studio/document/visible_histogram.h"

#include "base/check.h"

namespace vs::studio {

const std::vector<std::uint32_t>* VisibleHistogram::count(const Contents& contents, double budgetMs) {
    VS_CHECK(contents.inHand != InHand::Stroke);
    const auto view = contents.view.sculptureView;
    if (view == field::SculptureView::Whole ||
        (view == field::SculptureView::Cut && contents.sculpture.isEmpty())) {
        return &contents.scan.histogram;
    }
    if (!counting_) {
        counting_.emplace(contents.scan.field, int(contents.scan.histogram.size()));
    }
    const std::pair from(contents.sculpture.contentVersion(), view);
    if (countingFrom_ != from) {
        counting_->start(view);
        countingFrom_ = from;
        isDone_ = false;
    }
    if (!isDone_ && counting_->advance(contents.sculpture.texels(), budgetMs)) {
        counts_ = counting_->counts();
        isDone_ = true;
    }
    return isDone_ ? &counts_ : nullptr;
}

} // namespace vs::studio
