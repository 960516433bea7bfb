// SPDX-License-Identifier: Apache-2.0
#include "gl/hazard_watch.h"

#include "gl/errors.h"
#include "gl/pass.h"

#include <epoxy/gl.h>

#include <fmt/format.h>

#include <array>

namespace vs::gl {

namespace {

thread_local bool isAtWork = false;

// From here to the end of the block the watcher is at work.
class AtWork {
public:
    AtWork() { isAtWork = true; }
    ~AtWork() { isAtWork = false; }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
};

// A path of a shader or a function of this folder, with the pass that it works for.
std::string nameWithPass(std::string_view who) {
    const std::string passes = Pass::openNames();
    return passes.empty() ? std::string(who) : fmt::format("{} (pass '{}')", who, passes);
}

unsigned int boundName(unsigned int query, unsigned int unit) {
    GLint name = 0;
    glGetIntegeri_v(query, unit, &name);
    return unsigned(name);
}

// The memory behind a texture: a buffer texture has that of its buffer.
Memory memoryOfTexture(unsigned int texture, bool isBufferTexture) {
    if (!isBufferTexture) {
        return {false, texture};
    }
    GLint buffer = 0;
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
    return {true, unsigned(buffer)};
}

void addAccess(std::vector<MemoryAccess>& out, const ProgramAccess& access) {
    const unsigned int name = boundName(access.query, access.unit);
    if (name == 0) {
        return;
    }
    MemoryAccess made{{true, name}, access.use, access.reads, access.writes};
    if (access.use == Use::Image || access.use == Use::Fetch) {
        made.memory = memoryOfTexture(name, access.isBufferTexture);
    }
    if (access.use == Use::Image) {
        const unsigned int bound = boundName(GL_IMAGE_BINDING_ACCESS, access.unit);
        made.reads = made.reads && bound != GL_WRITE_ONLY;
        made.writes = made.writes && bound != GL_READ_ONLY;
    }
    out.push_back(made);
}

void noteCommand(const char* who, const MemoryAccess& access, Does does) {
    const AtWork atWork;
    HazardChecker& checker = *hazards();
    const std::string name = nameWithPass(who);
    if (does == Does::Fill) {
        checker.addFill(name, access);
    } else if (does == Does::CopyFrom) {
        checker.addCopySource(name, access);
    } else {
        checker.addCommand(name, access);
    }
}

std::string labelOf(Memory memory) {
    std::array<char, 256> text{};
    glGetObjectLabel(memory.isBuffer ? GL_BUFFER : GL_TEXTURE, memory.name, GLsizei(text.size()), nullptr,
                     text.data());
    return text[0] != '\0' ? text.data() : fmt::format("number {}", memory.name);
}

} // namespace

HazardChecker* hazards() {
    const ContextRecord* record = currentRecord();
    return record != nullptr ? record->hazards.get() : nullptr;
}

bool isWatcherAtWork() { return isAtWork; }

std::shared_ptr<const ProgramAccesses> accessesIfWatched(unsigned int program, std::string_view source) {
    const AtWork atWork;
    return hazards() == nullptr ? nullptr
                                : std::make_shared<const ProgramAccesses>(readAccesses(program, source));
}

HazardChecker makeHazardChecker() { return HazardChecker(labelOf); }

void noteDispatch(const std::string& path, const ProgramAccesses& accesses, unsigned int arguments) {
    const AtWork atWork;
    std::vector<MemoryAccess> made;
    for (const ProgramAccess& access : accesses) {
        addAccess(made, access);
    }
    if (arguments != 0) {
        made.push_back({{true, arguments}, Use::Command, true, false});
    }
    hazards()->addDispatch(nameWithPass(path), made);
}

void noteBufferCommand(const char* who, unsigned int buffer, Does does) {
    if (hazards() != nullptr) {
        const bool reads = does == Does::Read || does == Does::CopyFrom;
        noteCommand(who, {{true, buffer}, Use::BufferUpdate, reads, !reads}, does);
    }
}

void noteTextureCommand(const char* who, unsigned int texture, Does does) {
    if (hazards() != nullptr) {
        const bool reads = does == Does::Read || does == Does::CopyFrom;
        noteCommand(who, {{false, texture}, Use::TextureUpdate, reads, !reads}, does);
    }
}

void noteDeleted(Memory memory) {
    if (hazards() != nullptr) {
        hazards()->forget(memory);
    }
}

void memoryBarrier(unsigned int bits) {
    glMemoryBarrier(bits);
    if (hazards() != nullptr) {
        hazards()->addBarrier(bits);
    }
}

} // namespace vs::gl
