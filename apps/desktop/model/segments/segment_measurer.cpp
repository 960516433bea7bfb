// SPDX-License-Identifier: Apache-2.0
#include "model/segments/segment_measurer.h"

#include "base/progress.h"
#include "model/document/document_host.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "studio/document/document_facts.h"
#include "studio/exports/segment_measures.h"
#include "studio/state/region.h"

#include <algorithm>
#include <exception>
#include <stop_token>

namespace vs::desktop {

namespace {

// Of the voxels with a label, in equal bins over the volume's usual values.
std::vector<std::uint32_t> histogramOf(const volume::Volume& volume, const std::vector<std::uint8_t>& labels,
                                       std::uint8_t label, std::size_t bins) {
    std::vector<std::uint32_t> counts(bins);
    const Range range = volume.usual;
    if (range.width() <= 0 || bins == 0) {
        return counts;
    }
    volume::visit(volume, [&](const auto* values) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const auto value = double(values[i]);
            if (labels[i] == label && range.contains(value)) {
                const auto bin = std::size_t((value - range.lo) / range.width() * double(bins));
                ++counts[std::min(bin, bins - 1)];
            }
        }
    });
    return counts;
}

std::vector<segment::MeasuredSegment> measureAll(const studio::SegmentMeasures& measures,
                                                 const std::vector<studio::SegmentInfo>& infos) {
    std::vector<segment::MeasuredSegment> segments;
    for (const auto& statistics : measures.all()) {
        const auto info = std::find_if(infos.begin(), infos.end(), [&](const studio::SegmentInfo& one) {
            return one.label == statistics.label;
        });
        if (info != infos.end()) {
            segments.push_back(
                {info->label, info->name, glm::u8vec3(glm::round(info->colour * 255.0)), statistics});
        }
    }
    return segments;
}

} // namespace

SegmentMeasurer::SegmentMeasurer(DocumentHost& host, SegmentController& list, GrowthController& growth)
    : host_(host), list_(list), growth_(growth) {
    constexpr int kCalmMs = 300;
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, &SegmentMeasurer::poll);
    connect(&host_, &DocumentHost::changed, this, [this] {
        if (!wanting_.empty() && !(now() == key_)) {
            if (!found_.segments.empty()) {
                found_ = {}; // no longer true
                emit changed();
            }
            calm_.start();
        }
    });
}

SegmentMeasurer::~SegmentMeasurer() = default;

SegmentMeasurer::Key SegmentMeasurer::now() const {
    const auto facts = host_.facts();
    return host_.document() == nullptr
               ? Key{}
               : Key{facts->segmentsRevision, facts->segments.atWork, facts->geometry};
}

void SegmentMeasurer::want(const QObject* who, bool wants) {
    if (wants) {
        wanting_.insert(who);
        poll();
    } else {
        wanting_.erase(who);
    }
}

void SegmentMeasurer::stop() {
    calm_.stop();
    if (worker_.joinable()) {
        worker_.request_stop();
        worker_.join();
    }
    isMeasuring_ = false;
    key_ = {};
    found_ = {};
    emit changed();
}

const segment::MeasuredSegment* SegmentMeasurer::working() const {
    const int label = list_.list().atWork;
    const auto found = std::find_if(found_.segments.begin(), found_.segments.end(),
                                    [label](const auto& segment) { return segment.label == label; });
    return found != found_.segments.end() ? &*found : nullptr;
}

// Begins when nothing is under way any more.
void SegmentMeasurer::poll() {
    if (wanting_.empty() || host_.document() == nullptr || now() == key_) {
        return;
    }
    if (isMeasuring_ || host_.isLoading() || growth_.isBusy() || host_.facts()->isStrokeOpen()) {
        calm_.start();
        return;
    }
    begin(now());
}

void SegmentMeasurer::begin(const Key& key) {
    const auto& document = *host_.document();
    std::shared_ptr<const studio::SegmentMeasures> measures;
    if (!host_.workLong([&] { measures = std::make_shared<studio::SegmentMeasures>(document); })) {
        key_ = key; // once is enough to be told
        return;
    }
    isMeasuring_ = true;
    emit changed();
    // The volume stays as long as the document, and that goes only after stop().
    worker_ = std::jthread([this, key, &volume = document.volume(), bins = document.histogram().size(),
                            infos = document.segments().segments, measures](const std::stop_token& stop) {
        const ProgressListener listener([&stop](std::optional<double>) { return !stop.stop_requested(); });
        Found found;
        try {
            found.segments = measureAll(*measures, infos);
            found.histogram = histogramOf(volume, measures->labels(), key.atWork, bins);
        } catch (const std::exception&) { // no memory, or nobody wants it any more: nothing is known then
            found = {};
        }
        QMetaObject::invokeMethod(
            this,
            [this, key, found = std::move(found)] { host_.whenHere([=, this] { finish(key, found); }); },
            Qt::QueuedConnection);
    });
}

void SegmentMeasurer::finish(const Key& key, Found found) {
    if (!isMeasuring_) {
        return; // stopped meanwhile
    }
    isMeasuring_ = false;
    key_ = key;
    found_ = std::move(found);
    if (!(now() == key_)) {
        found_ = {};
        calm_.start();
    }
    emit changed();
}

} // namespace vs::desktop
