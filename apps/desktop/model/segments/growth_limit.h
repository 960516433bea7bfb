// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document_facts.h"

#include <cstdint>
#include <optional>

namespace vs::desktop {

// How large a segment may become by its first stroke before the person is asked whether it shall go on: a
// part of the voxels that are displayed, so that a stroke that takes more than was meant stops early.
class GrowthLimit {
public:
    // A part of the voxels that are displayed when the stroke is made; 0: no limit.
    void setPercent(int percent) { percent_ = percent; }
    [[nodiscard]] int percent() const { return percent_; }

    // From here on it holds for that segment, until it is reached or let go of.
    void hold(std::uint8_t label, double displayedVoxels);
    void letGo() { held_.reset(); }
    void forget() {
        held_.reset();
        stopped_.reset();
    }
    // What that segment may have; without a limit any number.
    [[nodiscard]] std::uint64_t mostVoxels(std::uint8_t label) const;

    // It was reached, and growth stopped.
    void stop(const studio::DocumentFacts& facts);
    // Nothing has become of the segment at work since it stopped.
    [[nodiscard]] bool hasStopped(const studio::DocumentFacts& facts) const;

private:
    struct Of {
        std::uint8_t label = 0;
        std::uint64_t voxels = 0;

        bool operator==(const Of&) const = default;
    };

    int percent_ = 0;
    std::optional<Of> held_;
    std::optional<Of> stopped_;
};

} // namespace vs::desktop
