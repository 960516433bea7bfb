// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/hazards.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Tells the hazard checker of the current context, where there is one, what is done in OpenGL. Internal to
// this folder.
namespace vs::gl {

// A place of a program that memory can be bound to.
struct ProgramAccess {
    Use use = Use::Storage;
    unsigned int unit = 0;        // or binding
    unsigned int query = 0;       // what tells the name that is bound there
    bool isBufferTexture = false; // an image or texture whose texels lie in a buffer
    bool reads = true;
    bool writes = false;
};
using ProgramAccesses = std::vector<ProgramAccess>;

// What a program accesses, by what the driver tells of it and its source declares. Throws GlError for a kind
// of texture that is not known here.
ProgramAccesses readAccesses(unsigned int program, std::string_view source);

// What readAccesses() tells, for programs to keep; nothing while hazards are not watched.
std::shared_ptr<const ProgramAccesses> accessesIfWatched(unsigned int program, std::string_view source);

// Whether the checker is at work on this thread. The memory that it takes then is not the program's: tests
// that refuse the program memory leave it alone.
bool isWatcherAtWork();

// The checker of the context that is current on this thread; null while hazards are not watched.
HazardChecker* hazards();

// A checker that knows buffers and textures by their labels.
HazardChecker makeHazardChecker();

// A dispatch that is about to be made with what is bound now, named by the path of its shader; `arguments` is
// the buffer that it takes its size from, or 0. Only while hazards are watched.
void noteDispatch(const std::string& path, const ProgramAccesses& accesses, unsigned int arguments);

// Commands on a buffer or texture, named by the function that gives them. They cost next to nothing while
// hazards are not watched.
enum class Does { Read, Write, Fill, CopyFrom };
void noteBufferCommand(const char* who, unsigned int buffer, Does does);
void noteTextureCommand(const char* who, unsigned int texture, Does does);
void noteDeleted(Memory memory);

// glMemoryBarrier, which the checker is told of.
void memoryBarrier(unsigned int bits);

} // namespace vs::gl
