// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/measured_segment.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <set>
#include <thread>
#include <vector>

namespace vs::desktop {

class DocumentHost;
class GrowthController;
class SegmentController;

// Measures all segments on a thread of its own when they have come to rest, as long as somebody wants to
// know. What is shown meanwhile is what was measured last, or nothing if that is no longer true.
class SegmentMeasurer : public QObject {
    Q_OBJECT

public:
    SegmentMeasurer(DocumentHost& host, SegmentController& list, GrowthController& growth);
    ~SegmentMeasurer() override;

    // Whether `who` looks at the numbers.
    void want(const QObject* who, bool wants);
    // Before the document goes: waits for what is under way, and forgets what was found.
    void stop();

    // All segments that have voxels, in the order of their labels; empty while nothing is known.
    [[nodiscard]] const std::vector<segment::MeasuredSegment>& segments() const { return found_.segments; }
    // The segment at work; null: not known, or it is empty.
    [[nodiscard]] const segment::MeasuredSegment* working() const;
    // The values of the segment at work, in the bins of the document's histogram; empty when not known.
    [[nodiscard]] const std::vector<std::uint32_t>& histogram() const { return found_.histogram; }
    [[nodiscard]] bool isMeasuring() const { return isMeasuring_; }

signals:
    void changed();

private:
    struct Key { // what was measured
        std::uint64_t revision = 0;
        std::uint8_t atWork = 0;
        volume::GridGeometry geometry; // where the voxels lie
        bool operator==(const Key&) const = default;
    };
    struct Found {
        std::vector<segment::MeasuredSegment> segments;
        std::vector<std::uint32_t> histogram;
    };

    void poll();
    void begin(const Key& key);
    void finish(const Key& key, Found found);
    [[nodiscard]] Key now() const;

    DocumentHost& host_;
    SegmentController& list_;
    GrowthController& growth_;
    std::set<const QObject*> wanting_;
    QTimer calm_;
    Key key_;
    Found found_;
    bool isMeasuring_ = false;
    std::jthread worker_;
};

} // namespace vs::desktop
