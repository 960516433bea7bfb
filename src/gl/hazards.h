// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Finds barriers that are missing. Internal to this folder; others ask Context::watchHazards().
//
// What shaders write, OpenGL does not order by itself (OpenGL 4.5, section 7.12.2): without glMemoryBarrier
// their stores need not be "visible to subsequent operations", and may "overwrite data still to be read by
// previously requested operations". So a hazard is each of these, where no barrier with the bit for the kind
// of the *later* access lies between:
//   - a read, by a shader or a command, of memory that a shader has written;
//   - a write, by a shader or a command, to memory that a shader has written;
//   - a write by a shader to memory that an earlier dispatch or copy reads. The bits for images and for
//     storage promise that stores after the barrier wait for "all memory accesses initiated prior" to it.
// What commands write (uploads, clears, copies) OpenGL orders itself before and after everything that reads
// it; commands that give data to the program have read it when they return. Memory is a whole buffer or
// texture: works on two parts of it need a barrier here too, though OpenGL does not want one.
namespace vs::gl {

// The ways to memory that a barrier has a bit for.
enum class Use { Image, Fetch, Storage, Uniform, Counter, Command, BufferUpdate, TextureUpdate };
inline constexpr std::size_t kUses = 8;
unsigned int barrierBit(Use use); // OpenGL's bit for it

// A buffer, or a texture that has memory of its own.
struct Memory {
    bool isBuffer = true;
    unsigned int name = 0;
};
inline bool operator<(const Memory& a, const Memory& b) {
    return std::tie(a.isBuffer, a.name) < std::tie(b.isBuffer, b.name);
}

struct MemoryAccess {
    Memory memory;
    Use use = Use::Storage;
    bool reads = false;
    bool writes = false;
};

class HazardChecker {
public:
    // `labelOf` says what a buffer or texture is called.
    explicit HazardChecker(std::function<std::string(Memory)> labelOf) : labelOf_(std::move(labelOf)) {}

    // A dispatch, with all that it accesses. `who` names its shader and its pass.
    void addDispatch(const std::string& who, std::span<const MemoryAccess> accesses);
    // A command that uploads, clears, copies or reads back.
    void addCommand(const std::string& who, const MemoryAccess& access);
    // Memory that a command fills wholly: what shaders did there before is of no account any more.
    void addFill(const std::string& who, const MemoryAccess& access);
    // A copy that the device makes reads its source when it comes to it.
    void addCopySource(const std::string& who, const MemoryAccess& access);
    void addBarrier(unsigned int bits);
    // The name is free, or has been given to new memory.
    void forget(Memory memory) { histories_.erase(memory); }

    // From now on takes barriers as if they lacked these bits, for tests of the checker itself.
    void ignoreBarriers(unsigned int bits) { ignored_ = bits; }

    // Hazards found so far, each told once.
    [[nodiscard]] int count() const { return count_; }
    // The text of the first one; only if there is one.
    [[nodiscard]] const std::string& first() const { return found_.front(); }
    // Gives away the texts of what was found, and counts anew.
    std::vector<std::string> take();

private:
    struct Step {
        std::string who; // nothing: none yet
        Use use = Use::Storage;
        std::uint64_t when = 0;
    };
    // The newest write and read suffice: a barrier that orders them orders all before.
    struct History {
        Step write; // by a shader
        Step read;  // by a shader or a command on the device
    };
    [[nodiscard]] bool isOrdered(const Step& earlier, Use later) const;
    void compare(const std::string& who, const MemoryAccess& access, bool isShader);
    void tell(const Step& earlier, bool hasWritten, const std::string& who, const MemoryAccess& access);

    std::function<std::string(Memory)> labelOf_;
    std::map<Memory, History> histories_;
    std::array<std::uint64_t, kUses> barriers_{}; // when the last one for a use was issued
    std::uint64_t now_ = 1;
    unsigned int ignored_ = 0;
    int count_ = 0;
    std::set<std::string> told_;
    std::vector<std::string> found_;
};

} // namespace vs::gl
