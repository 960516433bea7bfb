// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace vs::gl {

// A member of a uniform block, as C++ lays it out; in bytes.
struct BlockMember {
    std::string_view name;
    std::size_t offset = 0;
    std::size_t size = 0;
};

// A member of the struct that is written into a block. It is called the same in GLSL.
#define VS_BLOCK_MEMBER(Struct, member)                                                                      \
    vs::gl::BlockMember { #member, offsetof(Struct, member), sizeof(Struct::member) }

// What is written into a uniform block (std140): the block's name and its members. It is declared beside the
// struct. tests/gpu/gl/block_layout_test.cpp compares it with what the driver says of every shader.
struct BlockLayout {
    std::string_view name;
    std::size_t size = 0;
    std::span<const BlockMember> members;
};

// Whether the members fill the struct from its beginning to its end, in order and without gaps: then no
// member of it has been left out of the list.
constexpr bool isWhole(const BlockLayout& layout) {
    std::size_t end = 0;
    for (const BlockMember& member : layout.members) {
        if (member.offset != end) {
            return false;
        }
        end += member.size;
    }
    return end == layout.size;
}

} // namespace vs::gl
