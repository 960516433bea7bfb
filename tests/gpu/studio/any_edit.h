// SPDX-License-Identifier: Apache-2.0
// Edits of the head that tests work on, drawn at random: most make sense one after the other, some are
// refused.
#pragma once

#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

namespace vs::test {

using studio::Operation;

// A label map on that head's grid, which is there as long as the program runs.
inline const std::filesystem::path& labelFile() {
    static const LabelFile file;
    return file.path();
}

// What changes the document or goes through its history. Views and files are AnyOperation's
// (any_operation.h).
class AnyEdit {
public:
    // A number from 0 to n - 1: who draws it decides what comes.
    using Below = std::function<int(int n)>;
    explicit AnyEdit(Below below) : below_(std::move(below)) {}

    [[nodiscard]] Operation edit() const;
    [[nodiscard]] Operation cut() const;         // of the sculpture, or what puts some of it back
    [[nodiscard]] Operation part() const;        // on pasted parts
    [[nodiscard]] Operation mark() const;        // on the head, or away from it
    [[nodiscard]] Operation fill() const;        // with one of two materials, or what makes and removes them
    [[nodiscard]] Operation segmentWork() const; // on one of three segments

protected:
    [[nodiscard]] int below(int n) const { return below_(n); }

private:
    Below below_;
};

inline Operation AnyEdit::cut() const {
    const double x = 150 + 10 * below(11);
    const double y = 90 + 10 * below(12);
    switch (below(6)) {
    case 0: {
        studio::Clip clip;
        clip.planes = {{{35, 39, 20.0 + below(30)}, {0.2, 0.1, -1}}};
        return clip;
    }
    case 1: {
        studio::KeepConnected keep;
        keep.voxel = glm::ivec3(35, 39, 29);
        keep.canvas = testCanvas();
        return keep;
    }
    case 2:
        return studio::restoring(studio::toolsAt(x, y)[std::size_t(below(6))]);
    case 3:
        return below(4) == 0 ? Operation(studio::UnCut{})
                             : Operation(studio::CutSegment{below(3) == 0, double(below(3))});
    default:
        return studio::toolsAt(x, y)[std::size_t(below(6))];
    }
}

inline Operation AnyEdit::mark() const {
    studio::Mark mark;
    const glm::dvec2 at(150 + 10 * below(11), 90 + 10 * below(12));
    mark.kind = studio::Mark::Kind(below(4));
    mark.sketch = {studio::Shape::Polyline, {at, at + glm::dvec2(20, 5 * below(5)), at + glm::dvec2(25, 25)}};
    mark.colour = {0.1 * below(10), 0.5, 1};
    mark.opacity = 0.25 * (1 + below(4));
    mark.softMm = below(3);
    mark.erases = below(4) == 0;
    mark.text = mark.kind == studio::Mark::Kind::Text ? "R" : "";
    mark.canvas = testCanvas();
    return below(12) == 0 ? Operation(studio::RemoveMarks{}) : Operation(mark);
}

inline Operation AnyEdit::fill() const {
    const double x = 150 + 10 * below(11);
    const double y = 90 + 10 * below(12);
    const auto tool = studio::toolsAt(x, y)[std::size_t(below(4))];
    studio::SetMaterial material;
    material.number = 1 + below(2);
    material.value = 40.0 * below(6);
    material.isVisible = below(4) != 0;
    const auto with = [&tool](auto op) {
        std::visit(
            [&](const auto& drawn) {
                if constexpr (std::is_constructible_v<decltype(op.stroke), decltype(drawn)>) {
                    op.stroke = drawn;
                }
            },
            tool);
        return Operation(op);
    };
    switch (below(10)) {
    case 8:
    case 9:
        return studio::SegmentFill{1};
    case 0:
    case 1:
        return material;
    case 2:
        return with(studio::Unfill{});
    case 4: {
        // Where the head is all around it.
        studio::FillHole hole{1 + below(2), ellipseAt(185.0 + 5 * below(7), 120.0 + 5 * below(7), 12, 10)};
        hole.canvas = testCanvas();
        return hole;
    }
    case 3:
        return below(3) > 0    ? Operation(material)
               : below(2) == 0 ? Operation(studio::RemoveFill{1 + below(2)})
                               : Operation(studio::RemoveFill{});
    default:
        return with(studio::Fill{1 + below(2), {}});
    }
}

inline Operation AnyEdit::part() const {
    switch (below(4)) {
    case 0:
        return studio::MovePart{below(2), {{10.0 * below(9), 0, 5}}};
    case 1: {
        studio::ChangePart change{below(2)};
        change.isVisible = below(2) == 0;
        change.name = "part";
        return change;
    }
    case 2:
        return studio::DiscardPart{below(2)};
    default:
        return studio::Paste{{{10.0 * below(9), 0, 5}}};
    }
}

inline Operation AnyEdit::segmentWork() const {
    const std::string names[] = {"Segment 1", "B", "C"};
    const std::string& who = names[below(3)];
    const glm::ivec3 voxel(30 + below(12), 16 + below(6), 24 + below(12));
    switch (below(13)) {
    case 12:
        return studio::LoadLabels{labelFile()};
    case 0: {
        studio::UseSegment use{who};
        use.isLocked = below(4) == 0;
        use.treatment = studio::SegmentInfo::Treatment(below(3));
        return use;
    }
    case 1:
        return studio::UseSegment{who};
    case 2:
        return studio::Rewind{below(5)};
    case 3:
        return studio::ShowGeneration{below(12)};
    case 4: {
        studio::SetGrowthRules rules;
        rules.isLive = below(2) == 0;
        rules.range = below(2) == 0 ? Range{80, 120} : Range{30, 255};
        rules.gradient = Range{0, 30};
        return rules;
    }
    case 5: {
        studio::Absorb absorb;
        absorb.voxels = {voxel};
        absorb.expansions = 1 + below(4);
        absorb.canvas = testCanvas();
        return absorb;
    }
    case 6:
        return editOf(studio::EditSegment::Kind(below(13)), 0.5 + below(3), who);
    case 7:
        return below(2) == 0 ? Operation(studio::PullOut{who, {{10.0 * below(9), 0, 0}}})
                             : Operation(studio::RemoveSegment{who});
    case 8:
    case 9:
        return seedAt(voxel);
    default:
        return studio::Grow{1 + below(6)};
    }
}

inline Operation AnyEdit::edit() const {
    switch (below(14)) {
    case 12:
    case 13:
        return fill();
    case 0:
    case 1:
    case 2:
        return cut();
    case 3:
        return part();
    case 4:
        return below(2) == 0 ? mark()
                             : Operation(studio::Measure{studio::Measure::Kind::Distance,
                                                         {{10, 20, 30}, {10.5, 20, 30.0 + below(20)}}});
    case 5: {
        studio::CorrectGeometry correct;
        correct.spacing = glm::dvec3(1, 1.5, 1.0 + below(3));
        return below(4) == 0 ? Operation(correct) : Operation(studio::Note{"here"});
    }
    case 6:
        return below(2) == 0 ? Operation(studio::Undo{}) : Operation(studio::Redo{});
    default:
        return segmentWork();
    }
}

} // namespace vs::test
