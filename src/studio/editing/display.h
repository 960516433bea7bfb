// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/pipeline.h"

namespace vs::studio {

// Frames of a document's contents as they are now, for pictures and for picking. What a frame is made from is
// brought up to date first; it is valid until the contents change or another frame is made.
class Display {
public:
    // The contents must outlive it.
    explicit Display(const Contents& contents) : contents_(&contents), pipeline_(contents.scan.field) {}

    void showFiner(field::Detail& detail, field::CellRanges cells) {
        pipeline_.showFiner(detail, std::move(cells));
    }

    // `segmentsMs` is the time that bringing the segments' surfaces up to date may take.
    render::Frame frame(const View& from, glm::ivec2 size,
                        double segmentsMs = segment::Segmentation::kNoHurry);
    // What the last frame shows, and the voxels along whose rays that may differ from an earlier one: nothing
    // means everywhere.
    [[nodiscard]] const PictureContent& content() const { return pipeline_.content(); }
    [[nodiscard]] std::optional<Box3> changedSince(const PictureContent& before) const {
        return pipeline_.changedSince(state(), before);
    }
    // Takes the room that drawing segments needs, and gives it back.
    void prepareSegments() { pipeline_.prepareSegments(contents_->view); }
    void forgetSegments() { pipeline_.forgetSegments(); }
    render::SliceFrame slice(const render::SliceView& view, double segmentsMs);
    // The segments in the last frame or slice are not up to date: there was no time for it.
    [[nodiscard]] bool isBehind() const { return pipeline_.isBehind(); }

    // A transfer function with absolute positions on the volume.
    render::TransferFunction resolved(const render::TransferFunction& function) {
        return pipeline_.resolved(function);
    }
    // What of the sculpture is drawn at a place of the view, and the ranges (x fastest) of the macrocells of
    // the part that a paste would make now.
    PastedParts::Part partAt(std::size_t place) { return pipeline_.partAt(state(), place); }
    std::vector<glm::vec2> cellsOfNextPart(bool takesTrimmed) {
        return pipeline_.cellsOfNextPart(state(), takesTrimmed);
    }
    [[nodiscard]] const field::CellRanges& cellRanges() const { return pipeline_.cellRanges(); }

private:
    [[nodiscard]] Pipeline::State state() const {
        return stateOf(contents_->view, segment::Segmentation::kNoHurry);
    }
    [[nodiscard]] Pipeline::State stateOf(const View& from, double segmentsMs) const;

    const Contents* contents_;
    Pipeline pipeline_;
};

} // namespace vs::studio
