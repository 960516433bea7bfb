// SPDX-License-Identifier: Apache-2.0
#include "tools/movable_parts.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/part_queries.h"

#include <algorithm>
#include <iterator>
#include <variant>

namespace vs::desktop {

int MovableParts::pasted() const { return int(studio_.view().shown().pasted.size()); }

std::vector<studio::SegmentInfo> MovableParts::pulledOut() const {
    std::vector<studio::SegmentInfo> found;
    if (studio_.host().geometry() != nullptr) {
        const auto facts = studio_.host().facts();
        std::copy_if(facts->segments.segments.begin(), facts->segments.segments.end(),
                     std::back_inserter(found),
                     [](const studio::SegmentInfo& info) { return info.pulledOut && info.isVisible; });
    }
    return found;
}

int MovableParts::count() const { return pasted() + int(pulledOut().size()); }

std::optional<int> MovableParts::numberOf(const std::string& segment) const {
    const auto all = pulledOut();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& info) { return info.name == segment; });
    return found != all.end() ? std::optional(pasted() + int(found - all.begin())) : std::nullopt;
}

std::optional<std::string> MovableParts::segment(int part) const {
    return part < pasted() ? std::nullopt : std::optional(pulledOut()[std::size_t(part - pasted())].name);
}

render::Placement MovableParts::place(int part) const {
    const auto& view = studio_.view().shown();
    if (part < pasted()) {
        return view.pasted[std::size_t(part)];
    }
    const studio::SegmentInfo info = pulledOut()[std::size_t(part - pasted())];
    return view.held && view.held->label == info.label ? view.held->place : *info.pulledOut;
}

Box3 MovableParts::box(int part) const {
    return std::size_t(part) < boxes_.size() ? boxes_[std::size_t(part)] : Box3();
}

// The boxes change with every edit but moves.
void MovableParts::find() {
    auto& document = *studio_.host().document();
    const auto moves = [](const studio::Operation& operation) {
        return std::holds_alternative<studio::MovePart>(operation) ||
               std::holds_alternative<studio::PullOut>(operation);
    };
    const auto& log = document.log();
    const bool isOneMove = log.size() == seenEdits_ + 1 && !log.empty() && moves(log.back());
    const bool isNew = log.size() != seenEdits_ && !isOneMove;
    seenEdits_ = log.size();
    if (!isNew && int(boxes_.size()) == count()) {
        return;
    }
    boxes_.clear();
    studio_.host().workLong([&] {
        for (int part = 0; part < pasted(); ++part) {
            boxes_.push_back(document.parts().box(std::size_t(part)));
        }
        for (const studio::SegmentInfo& info : pulledOut()) {
            boxes_.push_back(document.parts().segmentBox(info.label));
        }
    });
    boxes_.resize(std::size_t(count()));
}

void MovableParts::show(int part, const render::Placement& place) {
    auto view = studio_.view().shown();
    if (part < pasted()) {
        view.pasted[std::size_t(part)] = place;
    } else {
        const studio::SegmentInfo info = pulledOut()[std::size_t(part - pasted())];
        view.held = studio::HeldSegment{info.label, place};
        if (place == *info.pulledOut) {
            view.held.reset();
        }
    }
    studio_.view().showView(view);
}

studio::Operation MovableParts::moved(int part, const render::Placement& place) const {
    if (const auto name = segment(part)) {
        return studio::PullOut{*name, place};
    }
    return studio::MovePart{part, place};
}

} // namespace vs::desktop
