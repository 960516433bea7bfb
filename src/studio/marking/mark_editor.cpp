// SPDX-License-Identifier: Apache-2.0
#include "studio/marking/mark_editor.h"

#include "base/error.h"
#include "field/marks/mark_texture.h"

#include <utility>

namespace vs::studio {

namespace {

// Voxels in which something of the marks has changed.
std::size_t changedVoxels(const field::Marks& before, const field::Marks& after) {
    const field::MarkGrid& grid = after.isEmpty() ? before.grid() : after.grid();
    const glm::ivec3 n = grid.perVoxel;
    std::size_t texels = 0;
    const field::MarkBrick none;
    for (const std::uint32_t place : field::changedBricks(before, after)) {
        const field::MarkBrick* one = before.find(place);
        const field::MarkBrick* other = after.find(place);
        for (std::size_t i = 0; i < std::size_t(field::kMarkTexels); ++i) {
            texels +=
                (one != nullptr ? *one : none).at(i) == (other != nullptr ? *other : none).at(i) ? 0 : 1;
        }
    }
    const auto perVoxel = std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
    return (texels + perVoxel - 1) / perVoxel;
}

} // namespace

void MarkEditor::remember(const Operation& operation, const field::SharedMarks& before,
                          const field::SharedMarks& after) {
    Edit edit{shared(operation), {}, {}};
    edit.marksBefore = before;
    edit.marksAfter = after;
    contents_.remember(std::move(edit));
    contents_.marks = after;
}

void MarkEditor::begin(const Mark& op) {
    if (const Fault fault = op.faultOf(); !fault.wanted.empty()) {
        throw Error("{}: {}", fault.place, fault.wanted);
    }
    const Canvas canvas = *op.canvas;
    stroke_ = std::make_unique<MarkStroke>(
        cutter_, [this, canvas] { return display_.frame(canvas.view, canvas.viewport); }, contents_.marks,
        op);
}

void MarkEditor::drawAt(const sculpt::PenPoint& pen) {
    stroke_->drawAt(pen);
    contents_.marks = stroke_->marks();
    ++contents_.version;
}

Outcome MarkEditor::finish() {
    const field::SharedMarks before = stroke_->before();
    const field::SharedMarks after = stroke_->marks();
    Outcome outcome;
    try {
        if (!after->isEmpty() && !field::MarkTexture::hasRoomFor(*after)) {
            throw Error(
                "with this mark there would be marks in {} bricks, more than this device has room for: "
                "mark less, or erase some",
                after->bricks().size());
        }
        outcome.voxelsTouched = changedVoxels(*before, *after);
        if (outcome.voxelsTouched > 0) {
            remember(stroke_->operation(), before, after);
        }
    } catch (...) {
        discard();
        throw;
    }
    if (outcome.voxelsTouched == 0) {
        outcome.message = stroke_->operation().erases
                              ? say(VS_TEXT("library", "nothing was erased: nothing is marked there"))
                              : say(VS_TEXT("library", "nothing was marked: nothing visible lies there"));
        contents_.marks = before;
    }
    stroke_.reset();
    return outcome;
}

void MarkEditor::discard() {
    contents_.marks = stroke_->before();
    stroke_.reset();
    ++contents_.version;
}

Outcome MarkEditor::run(Mark& op) {
    contents_.fillIn(op.canvas);
    begin(op);
    try {
        stroke_->replay();
    } catch (...) {
        discard();
        throw;
    }
    return finish();
}

Outcome MarkEditor::run(const RemoveMarks& op) {
    if (contents_.marks->isEmpty()) {
        throw Error("there is no mark to remove");
    }
    const field::SharedMarks before = contents_.marks;
    const auto after = std::make_shared<const field::Marks>();
    Outcome outcome;
    outcome.voxelsTouched = changedVoxels(*before, *after);
    remember(op, before, after);
    return outcome;
}

} // namespace vs::studio
