// SPDX-License-Identifier: Apache-2.0
#include "studio/document/visible_histogram.h"

#include "base/check.h"

#include <algorithm>
#include <functional>

namespace vs::studio {

namespace {

using Counts = std::vector<std::uint32_t>;

Box3 touchedBox(const sculpt::Sculpture& sculpture) {
    Box3 touched;
    for (const Box3& brick : sculpture.touchedBricks()) {
        touched = unite(touched, brick);
    }
    return touched;
}

Counts combined(Counts a, const Counts& b,
                const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& how) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), how);
    return a;
}

} // namespace

const std::vector<std::uint32_t>* VisibleHistogram::count(const Contents& contents, double budgetMs) {
    VS_CHECK(contents.inHand != InHand::Stroke);
    const auto view = contents.view.sculptureView;
    if (view == field::SculptureView::Whole ||
        (view == field::SculptureView::Cut && contents.sculpture.isEmpty())) {
        return &contents.scan.histogram;
    }
    const std::pair from(contents.sculpture.contentVersion(), view);
    if (countingFrom_ != from) {
        start(contents);
        countingFrom_ = from;
    }
    if (!isDone_ && counting_->advance(contents.sculpture.texels(), budgetMs)) {
        counts_ = combined(counting_->counts(), elsewhere_, std::plus<>());
        isDone_ = true;
    }
    return isDone_ ? &counts_ : nullptr;
}

void VisibleHistogram::start(const Contents& contents) {
    const auto& whole = contents.scan.histogram;
    const int bins = int(whole.size());
    const Box3 touched = touchedBox(contents.sculpture);
    const bool isCut = contents.view.sculptureView == field::SculptureView::Cut;
    elsewhere_ = isCut ? whole : Counts(whole.size());
    if (isCut && !touched.isEmpty()) {
        elsewhere_ = combined(std::move(elsewhere_),
                              field::intensityHistogram(contents.scan.field, touched, bins), std::minus<>());
    }
    if (!counting_) {
        counting_.emplace(contents.scan.field, bins);
    }
    counting_->start(contents.view.sculptureView, touched);
    isDone_ = false;
}

} // namespace vs::studio
