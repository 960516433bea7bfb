// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "render/camera/placement.h"
#include "render/colours/segment_colours.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vs::studio {

// Where a segment is drawn once more, beside what it lies in.
struct PulledOut {
    render::Placement place;
    bool isVisible = true;
    glm::dvec3 middleVoxel{0}; // of the segment when it was pulled out, in its own place

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("place", &PulledOut::place), required("visible", &PulledOut::isVisible),
                          required("middle", &PulledOut::middleVoxel, {.unit = "voxels"})};
    }
    bool operator==(const PulledOut&) const = default;
};

// What a person says about a segment. Its voxels are in segment::Growth, under its label.
struct SegmentInfo {
    // What tools that cut and restore do with it: take it like all else, spare it, or take nothing but it
    // (and others of which that is said).
    enum class Treatment { Take, Spare, TakeOnly };
    static constexpr std::array<const char*, 3> kTreatments{"take", "spare", "take only"};

    std::uint8_t label = 1;
    std::string name;
    glm::dvec3 colour{0}; // sRGB, 0 to 1
    double opacity = 1;
    bool isVisible = true;
    bool isLocked = false; // no tool changes it, nor cuts it
    Treatment treatment = Treatment::Take;
    bool isClaimed = false; // it took the first segment's place: labels that are loaded do not
    std::optional<PulledOut> pulledOut = {};

    // Whether it is seen beside what it lies in.
    [[nodiscard]] bool isSeenPulledOut() const { return pulledOut && pulledOut->isVisible && isVisible; }
    [[nodiscard]] bool isSpared() const { return isLocked || treatment == Treatment::Spare; }

    // States of sessions keep it so.
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("label", &SegmentInfo::label, {.least = 1, .most = 255}),
                          required("name", &SegmentInfo::name, {.leastCount = 1, .mostCount = 300}),
                          required("colour", &SegmentInfo::colour, {.least = 0, .most = 1}),
                          required("opacity", &SegmentInfo::opacity, {.least = 0.01, .most = 1}),
                          required("visible", &SegmentInfo::isVisible),
                          required("locked", &SegmentInfo::isLocked),
                          required("tools", &SegmentInfo::treatment),
                          required("claimed", &SegmentInfo::isClaimed),
                          sparse("pulledOut", &SegmentInfo::pulledOut)};
    }
    bool operator==(const SegmentInfo&) const = default;
};
constexpr const auto& namesOf(SegmentInfo::Treatment) { return SegmentInfo::kTreatments; }

// The name of the segment that is there at first.
inline constexpr const char* kFirstSegment = "Segment 1";
// Whether it is a name that is given when nobody has chosen one: "Segment 2".
bool isNumbered(const std::string& segment);

// All segments in the order they were made, and which is at work. There is always one.
struct SegmentList {
    SegmentList();

    std::vector<SegmentInfo> segments;
    std::uint8_t atWork = 1; // a label

    // Null when there is none of that name.
    [[nodiscard]] SegmentInfo* find(const std::string& name);
    [[nodiscard]] const SegmentInfo* find(const std::string& name) const;
    [[nodiscard]] const SegmentInfo& working() const;
    // Only the first segment is there, and nobody has said anything about it.
    [[nodiscard]] bool isUntouched() const { return *this == SegmentList(); }
    // Adds one with the next free label and a colour of its own. Throws Error when there are 255 already.
    SegmentInfo& add(const std::string& name);
    // Forgets one; another goes to work when it was the one at work. The last one is replaced by a fresh one.
    void remove(std::uint8_t label);

    [[nodiscard]] render::SegmentColours colours() const;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("segments", &SegmentList::segments, {.leastCount = 1, .mostCount = 255}),
                          required("atWork", &SegmentList::atWork, {.least = 1, .most = 255})};
    }
    [[nodiscard]] Fault faultOf() const; // of one that was read
    bool operator==(const SegmentList&) const = default;
};

} // namespace vs::studio
