// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/segment_list.h"

#include "base/error.h"
#include "render/colours/colour.h"
#include "render/colours/segment_palette.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vs::studio {

namespace {

constexpr int kMostLabels = 255;

} // namespace

bool isNumbered(const std::string& segment) {
    const std::string_view begin = "Segment ";
    return segment.starts_with(begin) && segment.size() > begin.size() &&
           segment.find_first_not_of("0123456789", begin.size()) == std::string::npos;
}

SegmentList::SegmentList() { add(kFirstSegment); }

SegmentInfo* SegmentList::find(const std::string& name) {
    const auto found = std::find_if(segments.begin(), segments.end(),
                                    [&](const SegmentInfo& segment) { return segment.name == name; });
    return found == segments.end() ? nullptr : &*found;
}

const SegmentInfo* SegmentList::find(const std::string& name) const {
    return const_cast<SegmentList*>(this)->find(name);
}

const SegmentInfo& SegmentList::working() const {
    return *std::find_if(segments.begin(), segments.end(),
                         [&](const SegmentInfo& segment) { return segment.label == atWork; });
}

SegmentInfo& SegmentList::add(const std::string& name) {
    const auto isTaken = [&](int label) {
        return std::any_of(segments.begin(), segments.end(),
                           [&](const SegmentInfo& segment) { return segment.label == label; });
    };
    int label = 1;
    while (label <= kMostLabels && isTaken(label)) {
        ++label;
    }
    if (label > kMostLabels) {
        throw Error("there are {} segments already; remove one first", kMostLabels);
    }
    segments.push_back({std::uint8_t(label), name, render::segmentColour(label)});
    return segments.back();
}

void SegmentList::remove(std::uint8_t label) {
    std::erase_if(segments, [&](const SegmentInfo& segment) { return segment.label == label; });
    if (segments.empty()) {
        add(kFirstSegment);
    }
    if (atWork == label) {
        atWork = segments.front().label;
    }
}

Fault SegmentList::faultOf() const {
    std::array<bool, kMostLabels + 1> isTaken{};
    for (const SegmentInfo& segment : segments) {
        if (std::exchange(isTaken[segment.label], true)) {
            return {"segments", "must have labels of their own"};
        }
    }
    return {isTaken[atWork] ? Fault() : Fault{"atWork", "must be the label of one of the segments"}};
}

render::SegmentColours SegmentList::colours() const {
    render::SegmentColours colours;
    for (const SegmentInfo& segment : segments) {
        const glm::vec3 linear(render::linearFromColour(render::Colour(glm::round(segment.colour * 255.0))));
        colours.entries[segment.label] = glm::vec4(linear, segment.isVisible ? float(segment.opacity) : 0.0F);
    }
    return colours;
}

} // namespace vs::studio
