// SPDX-License-Identifier: Apache-2.0
#include "gl/hazards.h"

#include "base/log.h"

#include <epoxy/gl.h>

#include <string_view>
#include <utility>

namespace vs::gl {

namespace {

struct UseNames {
    unsigned int bit;
    std::string_view bitName;
    std::string_view way;
};

constexpr std::array<UseNames, kUses> kNames{{
    {GL_SHADER_IMAGE_ACCESS_BARRIER_BIT, "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT", "as an image"},
    {GL_TEXTURE_FETCH_BARRIER_BIT, "GL_TEXTURE_FETCH_BARRIER_BIT", "as a texture"},
    {GL_SHADER_STORAGE_BARRIER_BIT, "GL_SHADER_STORAGE_BARRIER_BIT", "as storage"},
    {GL_UNIFORM_BARRIER_BIT, "GL_UNIFORM_BARRIER_BIT", "as uniforms"},
    {GL_ATOMIC_COUNTER_BARRIER_BIT, "GL_ATOMIC_COUNTER_BARRIER_BIT", "as counters"},
    {GL_COMMAND_BARRIER_BIT, "GL_COMMAND_BARRIER_BIT", "as arguments"},
    {GL_BUFFER_UPDATE_BARRIER_BIT, "GL_BUFFER_UPDATE_BARRIER_BIT", "from the program"},
    {GL_TEXTURE_UPDATE_BARRIER_BIT, "GL_TEXTURE_UPDATE_BARRIER_BIT", "from the program"},
}};

const UseNames& namesOf(Use use) { return kNames.at(std::size_t(use)); }

constexpr int kHazardsLogged = 8;

} // namespace

unsigned int barrierBit(Use use) { return namesOf(use).bit; }

void HazardChecker::addDispatch(const std::string& who, std::span<const MemoryAccess> accesses) {
    for (const MemoryAccess& access : accesses) {
        compare(who, access, true);
    }
    for (const MemoryAccess& access : accesses) {
        History& history = histories_[access.memory];
        if (access.writes) {
            history.write = {who, access.use, now_};
        }
        if (access.reads) {
            history.read = {who, access.use, now_};
        }
    }
    ++now_;
}

void HazardChecker::addCommand(const std::string& who, const MemoryAccess& access) {
    compare(who, access, false);
}

void HazardChecker::addFill(const std::string& who, const MemoryAccess& access) {
    compare(who, access, false);
    forget(access.memory);
}

void HazardChecker::addCopySource(const std::string& who, const MemoryAccess& access) {
    compare(who, access, false);
    histories_[access.memory].read = {who, access.use, now_};
    ++now_;
}

void HazardChecker::addBarrier(unsigned int bits) {
    for (std::size_t use = 0; use < kUses; ++use) {
        if ((bits & ~ignored_ & kNames.at(use).bit) != 0) {
            barriers_.at(use) = now_;
        }
    }
    ++now_;
}

std::vector<std::string> HazardChecker::take() {
    count_ = 0;
    told_.clear();
    return std::exchange(found_, {});
}

bool HazardChecker::isOrdered(const Step& earlier, Use later) const {
    return earlier.who.empty() || barriers_.at(std::size_t(later)) > earlier.when;
}

void HazardChecker::compare(const std::string& who, const MemoryAccess& access, bool isShader) {
    const auto found = histories_.find(access.memory);
    if (found == histories_.end()) {
        return;
    }
    const auto& [write, read] = found->second;
    if (!isOrdered(write, access.use)) {
        tell(write, true, who, access);
    } else if (isShader && access.writes && !isOrdered(read, access.use)) {
        tell(read, false, who, access);
    }
}

void HazardChecker::tell(const Step& earlier, bool hasWritten, const std::string& who,
                         const MemoryAccess& access) {
    const std::string text =
        fmt::format("{} '{}': {} {} it {}, then {} {} it {}; between them a barrier with {} is missing",
                    access.memory.isBuffer ? "buffer" : "texture", labelOf_(access.memory), earlier.who,
                    hasWritten ? "writes" : "reads", namesOf(earlier.use).way, who,
                    access.reads && access.writes ? "reads and writes"
                    : access.writes               ? "writes"
                                                  : "reads",
                    namesOf(access.use).way, namesOf(access.use).bitName);
    if (!told_.insert(text).second) {
        return;
    }
    found_.push_back(text);
    if (++count_ <= kHazardsLogged) {
        logNotice("hazard: " + text);
    }
}

} // namespace vs::gl
