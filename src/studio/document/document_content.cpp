// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_content.h"

#include "studio/document/document.h"
#include "studio/document/document_facts.h"
#include "studio/state/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

// Without what tells one document's sculpture from another's, and without what growing again may find out:
// that nothing more grows.
segment::GrowthState comparable(segment::GrowthState run) {
    run.constraints.sculpture = nullptr;
    run.constraints.sculptureVersion = 0;
    run.isFinished = false;
    return run;
}

} // namespace

DocumentContent contentOf(const Document& document) {
    const auto facts = document.facts();
    DocumentContent content;
    content.view = document.view();
    content.geometry = document.volume().geometry;
    content.precision = document.sculpture().precision();
    content.sculpture = document.sculpture().download({glm::ivec3(0), document.sculpture().dims()});
    if (document.region().exists()) {
        content.labels = document.region().labelMap();
        content.generations = document.region().growth()->generations(false);
        for (const SegmentInfo& segment : document.segments().segments) {
            content.runs[segment.label] = comparable(document.region().growth()->state(segment.label));
        }
    }
    if (!document.trimmed().isEmpty()) {
        content.trimmed =
            document.trimmed().leftForTools().download({glm::ivec3(0), document.sculpture().dims()});
    }
    content.segments = document.segments();
    content.measurements = *facts->measurements;
    content.marks = document.marks();
    content.filled = document.filled();
    for (const PartInfo& part : facts->parts) {
        content.parts.push_back(part.name);
    }
    content.stepsDone = document.history().done().size();
    content.stepsUndone = document.history().undone().size();
    return content;
}

namespace {

using Sentences = std::vector<std::string>;

void compareSculptures(const DocumentContent& one, const DocumentContent& other, Sentences& found) {
    if (one.sculpture == other.sculpture) {
        return;
    }
    const auto a = sculpt::valuesOf(one.sculpture, one.precision);
    const auto b = sculpt::valuesOf(other.sculpture, other.precision);
    std::size_t differing = 0;
    std::size_t crossing = 0;
    float most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        const float difference = std::abs(a[i] - b[i]);
        differing += difference > 0 ? 1 : 0;
        crossing += (a[i] < 0.5F) != (b[i] < 0.5F) ? 1 : 0;
        most = std::max(most, difference);
    }
    found.push_back(fmt::format("what is cut away: {} of {} voxels differ, by at most {:.4f}; {} of them are "
                                "cut in one and not in the other",
                                differing, a.size(), most, crossing));
}

// A segment is the same in both where both have its label.
void compareSegment(const SegmentInfo& segment, const DocumentContent& one, const DocumentContent& other,
                    const std::string& first, const std::string& second, Sentences& found) {
    std::size_t onlyOne = 0;
    std::size_t onlyOther = 0;
    const std::size_t count = std::max(one.labels.size(), other.labels.size());
    const auto isIn = [&](const std::vector<std::uint8_t>& labels, std::size_t i) {
        return i < labels.size() && labels[i] == segment.label;
    };
    for (std::size_t i = 0; i < count; ++i) {
        onlyOne += isIn(one.labels, i) && !isIn(other.labels, i) ? 1 : 0;
        onlyOther += !isIn(one.labels, i) && isIn(other.labels, i) ? 1 : 0;
    }
    if (onlyOne + onlyOther > 0) {
        found.push_back(fmt::format("segment {}: {} voxels are only in {}, {} only in {}", segment.name,
                                    onlyOne, first, onlyOther, second));
    }
}

void compareGenerations(const DocumentContent& one, const DocumentContent& other, Sentences& found) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < std::min(one.generations.size(), other.generations.size()); ++i) {
        differing += one.generations[i] != other.generations[i] ? 1 : 0;
    }
    if (differing > 0) {
        found.push_back(fmt::format("segment {}: {} voxels have another generation",
                                    one.segments.working().name, differing));
    }
}

// Seeds are compared by what they are, not by where they lie in memory.
bool areAlike(const std::map<std::uint8_t, segment::GrowthState>& one,
              const std::map<std::uint8_t, segment::GrowthState>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
        segment::GrowthState run = b.second;
        const bool areSeedsAlike = *a.second.seeds == *run.seeds;
        run.seeds = a.second.seeds;
        run.consistentFrom = a.second.consistentFrom; // what is known about it, and nothing of its own
        return a.first == b.first && areSeedsAlike && a.second == run;
    });
}

} // namespace

std::vector<std::string> differences(const DocumentContent& one, const DocumentContent& other,
                                     const std::string& first, const std::string& second) {
    Sentences found;
    const auto expectEqual = [&found](bool isEqual, const std::string& what) {
        if (!isEqual) {
            found.push_back(what);
        }
    };
    expectEqual(one.geometry == other.geometry, "where the scan's voxels lie differs");
    compareSculptures(one, other, found);
    if (one.labels != other.labels) {
        for (const SegmentInfo& segment : one.segments.segments) {
            compareSegment(segment, one, other, first, second, found);
        }
    }
    compareGenerations(one, other, found);
    expectEqual(one.trimmed == other.trimmed, "what is trimmed differs");
    expectEqual(areAlike(one.runs, other.runs), "how far segments have grown, or by which rules, differs");
    expectEqual(one.segments == other.segments, "the list of segments, or how they look, differs");
    expectEqual(one.measurements == other.measurements, "the measurements differ");
    expectEqual(one.filled.isAlike(other.filled), "what is filled, or with which materials, differs");
    expectEqual(*one.marks == *other.marks, "the marks differ");
    expectEqual(one.parts == other.parts, "the pasted parts differ");
    expectEqual(one.view == other.view, "the view differs");
    expectEqual(one.stepsDone == other.stepsDone && one.stepsUndone == other.stepsUndone,
                fmt::format("undo goes back {} steps and forth {} in {}, {} and {} in {}", one.stepsDone,
                            one.stepsUndone, first, other.stepsDone, other.stepsUndone, second));
    return found;
}

} // namespace vs::studio
