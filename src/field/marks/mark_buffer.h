// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "gl/buffer.h"

#include <cstdint>
#include <map>
#include <vector>

namespace vs::field {

// Marks on the device, as field/shaders/marks.glsl reads them: a header, for each brick of the grid a word
// (where it lies, or 0), then the bricks. A brick has the first texels of the bricks behind it too, so that
// what lies between its texels and theirs is found in it; and is there where only these have any.
class MarkBuffer {
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
    gl::Buffer buffer_;
};

} // namespace vs::field
