// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/statistics.h"
#include "volume/grid/brick_source.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vs::studio {

class Document;

// What the figures of a document's segments are taken of, as it is now: threads may measure while the
// document goes on, as long as it lives. Where segments grew at a finer level than the one that is worked on,
// each is measured there, in a box around it.
class SegmentMeasures {
public:
    explicit SegmentMeasures(const Document& document);

    // Figures of all segments, in the order of their labels. Throws ReadError. A segment whose box at the
    // finest level takes more than `mostBytes` is measured at the level that is worked on, but for its
    // volume.
    [[nodiscard]] std::vector<segment::SegmentStatistics> all(std::size_t mostBytes = std::size_t(1)
                                                                                      << 30) const;
    // The labels of the level that is worked on, x fastest.
    [[nodiscard]] const std::vector<std::uint8_t>& labels() const { return labels_; }

private:
    struct Finest {
        std::shared_ptr<const volume::BrickSource> source;
        volume::GridGeometry geometry;
        std::function<std::vector<std::uint8_t>(const Box3&)> labels;
        struct Segment {
            std::uint8_t label = 0;
            Box3 box; // of bricks
            std::size_t voxels = 0;
        };
        std::vector<Segment> segments; // that have voxels
    };
    [[nodiscard]] std::optional<segment::SegmentStatistics> measured(const Finest::Segment& segment,
                                                                     std::size_t mostBytes) const;

    const volume::Volume& volume_;
    volume::GridGeometry geometry_;
    std::vector<std::uint8_t> labels_;
    std::optional<Finest> finest_;
};

} // namespace vs::studio
