// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/surface_skirt.h"

#include <array>

namespace vs::sculpt {

namespace {

constexpr std::array<glm::ivec2, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

bool contains(glm::ivec2 size, glm::ivec2 e) { return e.x >= 0 && e.y >= 0 && e.x < size.x && e.y < size.y; }

// An element of the skirt on its way: which hit it continues.
struct Growing {
    glm::ivec2 element;
    glm::ivec2 from;
};

} // namespace

std::vector<SkirtElement> surfaceSkirt(const SkirtInput& input) {
    const auto at = [&](glm::ivec2 e) {
        return std::size_t(e.y) * std::size_t(input.size.x) + std::size_t(e.x);
    };
    // Nothing there, or something behind the place.
    const auto isOpen = [&](glm::ivec2 e, const glm::vec3& place) {
        return !input.isHit(e.x, e.y) ||
               (input.coversOthers && glm::dot(input.place(e.x, e.y) - place, input.direction) > input.gap);
    };
    std::vector<SkirtElement> skirt;
    std::vector<Growing> rim;
    for (int y = 0; y < input.size.y; ++y) {
        for (int x = 0; x < input.size.x; ++x) {
            const glm::ivec2 e(x, y);
            for (const glm::ivec2 step : kNeighbours) {
                if (input.isHit(x, y) && contains(input.size, e + step) && !input.isJoined(e, e + step) &&
                    isOpen(e + step, input.place(x, y))) {
                    rim.push_back({e, e});
                    break;
                }
            }
        }
    }
    if (rim.empty()) {
        return skirt;
    }
    skirt.resize(std::size_t(input.size.x) * std::size_t(input.size.y));
    for (int ring = 0; ring < input.reach; ++ring) {
        std::vector<Growing> next;
        for (const Growing& growing : rim) {
            for (const glm::ivec2 step : kNeighbours) {
                const glm::ivec2 e = growing.element + step;
                const glm::ivec2 offset = e - growing.from;
                if (!contains(input.size, e) || skirt[at(e)].exists() ||
                    offset.x * offset.x + offset.y * offset.y > input.reach * input.reach) {
                    continue;
                }
                const glm::vec3 place = input.place(growing.from.x, growing.from.y) +
                                        float(offset.x) * input.alongX + float(offset.y) * input.alongY;
                if (isOpen(e, place)) {
                    skirt[at(e)] = {growing.from, place};
                    next.push_back({e, growing.from});
                }
            }
        }
        rim = std::move(next);
    }
    return skirt;
}

} // namespace vs::sculpt
