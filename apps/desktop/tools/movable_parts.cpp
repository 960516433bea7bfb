// SPDX-License-Identifier: Apache-2.0
#include "tools/movable_parts.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/part_queries.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <variant>

namespace vs::desktop {

std::vector<MovableParts::Movable> MovableParts::all() const {
    std::vector<Movable> found;
    const auto* geometry = studio_.host().geometry();
    if (geometry == nullptr) {
        return found;
    }
    const auto facts = studio_.host().facts();
    for (std::size_t k = 0; k < studio_.view().shown().pasted.size(); ++k) {
        const studio::PartInfo* part = k < facts->parts.size() ? &facts->parts[k] : nullptr;
        if (part == nullptr || part->isVisible) {
            found.push_back({k,
                             {},
                             part != nullptr ? part->name : std::string(),
                             part != nullptr ? part->middleVoxel : 0.5 * (glm::dvec3(geometry->dims) - 1.0)});
        }
    }
    for (const studio::SegmentInfo& info : facts->segments.segments) {
        if (info.isSeenPulledOut()) {
            found.push_back({0, info, info.name, info.pulledOut->middleVoxel});
        }
    }
    return found;
}

int MovableParts::count() const { return int(all().size()); }

std::optional<int> MovableParts::numberOf(const std::string& segment) const {
    const auto parts = all();
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Movable& part) {
        return part.segment && part.segment->name == segment;
    });
    return found != parts.end() ? std::optional(int(found - parts.begin())) : std::nullopt;
}

std::optional<int> MovableParts::numberOf(std::size_t pasted) const {
    const auto parts = all();
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Movable& part) {
        return !part.segment && part.pasted == pasted;
    });
    return found != parts.end() ? std::optional(int(found - parts.begin())) : std::nullopt;
}

std::optional<MovableParts::Identity> MovableParts::identityOf(int part) const {
    const auto parts = all();
    if (part < 0 || part >= int(parts.size())) {
        return std::nullopt;
    }
    const Movable& movable = parts[std::size_t(part)];
    return Identity{movable.segment.has_value(), movable.name};
}

int MovableParts::numberOf(const Identity& identity, int before) const {
    const int parts = count();
    for (int n = 0; n < parts; ++n) {
        const int part = (before + n) % parts; // the nearest after it
        if (identityOf(part) == identity) {
            return part;
        }
    }
    return std::clamp(before, 0, std::max(parts - 1, 0));
}

render::Placement MovableParts::put(int part) const {
    const studio::View& view = studio_.view().shown();
    const Movable movable = at(part);
    if (!movable.segment) {
        return view.pasted[movable.pasted];
    }
    const bool isHeld = view.held && view.held->label == movable.segment->label;
    return isHeld ? view.held->place : movable.segment->pulledOut->place;
}

render::Placement MovableParts::drawn(int part) const {
    return render::spreadOut(put(part), studio_.view().shown().spread, at(part).middleVoxel,
                             *studio_.host().geometry());
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
    std::vector<Box3> found; // the window may paint what there is meanwhile
    studio_.host().workLong([&] {
        std::optional<std::array<Box3, 256>> ofSegments;
        for (const Movable& part : all()) {
            if (part.segment && !ofSegments) {
                ofSegments = document.parts().segmentBoxes();
            }
            found.push_back(part.segment ? (*ofSegments)[part.segment->label]
                                         : document.parts().box(part.pasted));
        }
    });
    boxes_ = std::move(found);
    boxes_.resize(std::size_t(count()));
}

void MovableParts::draw(int part, const render::Placement& there) {
    const Movable movable = at(part);
    auto view = studio_.view().shown();
    const render::Placement put =
        render::broughtTogether(there, view.spread, movable.middleVoxel, *studio_.host().geometry());
    if (!movable.segment) {
        view.pasted[movable.pasted] = put;
    } else {
        view.held = studio::HeldSegment{movable.segment->label, put};
    }
    studio_.view().showView(view);
}

void MovableParts::letGo(int part, const render::Placement& putBefore) {
    auto view = studio_.view().shown();
    const Movable movable = at(part);
    if (!movable.segment) {
        view.pasted[movable.pasted] = putBefore;
    }
    view.held.reset();
    studio_.view().showView(view);
}

studio::Operation MovableParts::moved(int part, const render::Placement& put) const {
    const Movable movable = at(part);
    if (movable.segment) {
        return studio::PullOut{movable.segment->name, put};
    }
    return studio::MovePart{int(movable.pasted), put};
}

} // namespace vs::desktop
