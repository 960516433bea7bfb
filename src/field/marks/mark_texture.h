// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "field/sparse/brick_words.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"

namespace vs::field {

// Where marks lie on the device; mirrors MarksBlock in field/shaders/marks.glsl (std140).
struct MarksBlock {
    glm::ivec4 markBricks{0};  // xyz along each axis, w in which word the bricks begin
    glm::vec4 markPerVoxel{1}; // xyz texels along each axis of a voxel, w of a step
};
inline constexpr gl::BlockMember kMarksBlockMembers[] = {VS_BLOCK_MEMBER(MarksBlock, markBricks),
                                                         VS_BLOCK_MEMBER(MarksBlock, markPerVoxel)};
inline constexpr gl::BlockLayout kMarksBlockLayout{"MarksBlock", sizeof(MarksBlock), kMarksBlockMembers};
static_assert(isWhole(kMarksBlockLayout));

// Marks on the device, as field/shaders/marks.glsl reads them: words, for each brick of the grid one (where
// it lies, or 0), and then the bricks. A brick has the first texels of the bricks behind it too, so that what
// lies between its texels and theirs is found in it; and is there where only these have any.
class MarkTexture {
public:
    MarkTexture();
    // Whether marks have room on the device.
    static bool hasRoomFor(const Marks& marks);
    // Brings what has changed since the last time to the device. Of more marks than that has room for nothing
    // is shown, and a notice says so.
    void show(const SharedMarks& marks);
    [[nodiscard]] bool isEmpty() const { return shown_->isEmpty(); }
    // For a scan whose voxels lie there.
    void bind(const volume::GridGeometry& geometry) const;

private:
    void forget();
    // The bricks that differ from those of `before`, as the device has them.
    [[nodiscard]] BrickWords::Changes changes(const Marks& before, const Marks& marks) const;

    SharedMarks shown_ = std::make_shared<const Marks>();
    MarkGrid grid_;
    BrickWords words_;
    mutable gl::Buffer block_;
    bool hasComplained_ = false;
};

} // namespace vs::field
