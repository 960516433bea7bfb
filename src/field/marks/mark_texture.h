// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"
#include "gl/texel_buffer.h"

#include <cstdint>
#include <map>
#include <vector>

namespace vs::field {

// Where marks lie on the device; mirrors MarksBlock in field/shaders/marks.glsl (std140).
struct MarksBlock {
    glm::ivec4 markBricks{0};  // xyz along each axis, w in which word the bricks begin
    glm::vec4 markPerVoxel{1}; // xyz texels along each axis of a voxel
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
    // So many bricks have room on every device: with each may come another, for the texels before it.
    static std::size_t mostBricks(const MarkGrid& grid);
    // Brings what has changed since the last time to the device. Throws Error where there are more marks than
    // the device holds.
    void show(const SharedMarks& marks);
    [[nodiscard]] bool isEmpty() const { return shown_ == nullptr || shown_->isEmpty(); }
    void bind() const;

private:
    void begin(const MarkGrid& grid);
    void makeRoom(std::size_t slots);
    void place(const Marks& marks, std::uint32_t place);
    void setPage(std::uint32_t place, std::uint32_t page);

    SharedMarks shown_;
    MarkGrid grid_;
    std::vector<std::uint32_t> pages_;
    std::map<std::uint32_t, std::uint32_t> slots_; // by place
    std::vector<std::uint32_t> free_;
    std::uint32_t used_ = 0;   // slots, free ones among them
    std::size_t capacity_ = 0; // slots
    gl::TexelBuffer words_;
    gl::Buffer block_;
};

} // namespace vs::field
