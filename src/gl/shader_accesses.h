// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace vs::gl {

// What a shader text says of an image or a block of memory that it declares. OpenGL does not tell this of a
// program: it has neither the qualifiers, nor whether a std430 block is used at all.
struct DeclaredAccess {
    bool reads = true;   // not writeonly
    bool writes = false; // an image or storage block that main() reaches an assignment to
    bool isUsed = false; // main() reaches a function that names it, or a member of it
};

// The images, samplers, storage and uniform blocks that an expanded shader text declares, by the names that
// OpenGL has for them: a block's own name, not that of its instance. What is used is taken rather too widely
// than too narrowly: macros count as used, functions of one name count as one, and what a function may change
// counts as written.
std::map<std::string, DeclaredAccess, std::less<>> declaredAccesses(std::string_view source);

// Bytes of shared memory that an expanded shader text declares. Throws GlError for a type or a length that is
// not known here.
std::size_t sharedBytes(std::string_view source);

} // namespace vs::gl
