// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/limits.h"

#include "base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace vs::sculpt {

namespace {

// Of memberships as textures of one or two channels hold them.
std::vector<float> mostOf(std::span<const std::byte> memberships, std::size_t channels, bool takesOnly) {
    std::vector<float> most(memberships.size() / channels);
    for (std::size_t i = 0; i < most.size(); ++i) {
        const auto membership = [&](std::size_t channel) {
            return channel < channels
                       ? float(std::to_integer<int>(memberships[channels * i + channel])) / 255.0F
                       : 0.0F;
        };
        most[i] = std::min(1 - membership(0), takesOnly ? membership(1) : 1.0F);
    }
    return most;
}

} // namespace

std::shared_ptr<const Limits::InBox> betweenVoxels(const gl::Texture& memberships,
                                                   const field::BrickGrid& finest) {
    struct Coarser {
        std::vector<std::byte> texels;
        std::size_t channels;
        glm::ivec3 size;
        [[nodiscard]] glm::vec2 at(glm::ivec3 v) const {
            v = glm::clamp(v, glm::ivec3(0), size - 1);
            const std::size_t i =
                (std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                std::size_t(v.x);
            const auto channel = [&](std::size_t n) {
                return n < channels ? float(std::to_integer<int>(texels[channels * i + n])) : 0.0F;
            };
            return {channel(0), channel(1)};
        }
        [[nodiscard]] glm::vec2 between(const glm::dvec3& place) const {
            const glm::ivec3 v(glm::floor(place));
            const glm::vec3 f(place - glm::dvec3(v));
            glm::vec2 sum(0);
            for (int n = 0; n < 8; ++n) {
                const glm::ivec3 corner(n & 1, n >> 1 & 1, n >> 2);
                const glm::vec3 w = glm::mix(1.0F - f, f, glm::vec3(corner));
                sum += w.x * w.y * w.z * at(v + corner);
            }
            return sum;
        }
    };
    const auto coarser = std::make_shared<const Coarser>(Coarser{
        memberships.downloadAll<std::byte>(), gl::bytesPerTexel(memberships.format()), memberships.size()});
    return std::make_shared<const Limits::InBox>([coarser, finest](const Box3& box) {
        const auto placeOf = [&](glm::ivec3 v) {
            return (glm::dvec3(v) - finest.origin) / finest.perSceneVoxel;
        };
        bool isAny = false;
        forEachVoxel(
            Box3{glm::ivec3(glm::floor(placeOf(box.lo))), glm::ivec3(glm::floor(placeOf(box.hi))) + 2},
            [&](glm::ivec3 v, std::size_t) { isAny = isAny || coarser->at(v) != glm::vec2(0); });
        std::vector<std::byte> bytes(isAny ? 2 * box.volume() : 0);
        inParallel(isAny ? box.size().z : 0, [&](int layer) {
            const glm::ivec3 size = box.size();
            const int z = box.lo.z + layer;
            std::size_t i = 2 * std::size_t(layer) * std::size_t(size.x) * std::size_t(size.y);
            forEachVoxel(Box3{{box.lo.x, box.lo.y, z}, {box.hi.x, box.hi.y, z + 1}},
                         [&](glm::ivec3 v, std::size_t) {
                             const glm::vec2 texel = coarser->between(placeOf(v)) + 0.5F;
                             bytes[i++] = std::byte(std::uint8_t(texel.x));
                             bytes[i++] = std::byte(std::uint8_t(texel.y));
                         });
        });
        return bytes;
    });
}

std::vector<float> mostEnergies(const Limits& limits, const Box3& box) {
    if (limits.memberships == nullptr) {
        return {};
    }
    const auto bytes = limits.memberships->download(box);
    return mostOf(bytes, gl::bytesPerTexel(limits.memberships->format()), limits.takesOnly);
}

Allowed allowedAtFinest(const Limits& limits, const Box3& box) {
    if (limits.finest == nullptr) {
        return Allowed::All;
    }
    const bool isNobodys = (*limits.finest)(box).empty();
    return !isNobodys ? Allowed::Some : limits.takesOnly ? Allowed::None : Allowed::All;
}

std::vector<float> mostEnergiesAtFinest(const Limits& limits, const Box3& box) {
    if (limits.finest == nullptr) {
        return {};
    }
    const std::vector<std::byte> bytes = (*limits.finest)(box);
    if (bytes.empty()) {
        return limits.takesOnly ? std::vector<float>(box.volume(), 0.0F) : std::vector<float>();
    }
    return mostOf(bytes, 2, limits.takesOnly);
}

} // namespace vs::sculpt
