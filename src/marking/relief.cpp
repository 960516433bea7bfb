// SPDX-License-Identifier: Apache-2.0
#include "marking/relief.h"

#include <cmath>
#include <limits>

namespace vs::marking {

std::pair<glm::ivec2, std::size_t> Relief::placeOf(glm::ivec2 pixel) {
    const glm::ivec2 chunk(glm::floor(glm::dvec2(pixel) / double(kChunk)));
    const glm::ivec2 inside = pixel - chunk * kChunk;
    return {chunk, std::size_t(inside.y) * kChunk + std::size_t(inside.x)};
}

void Relief::lookUnder(glm::ivec2 lo, glm::ivec2 hi, const PickSurface& pick) {
    std::vector<glm::dvec2> centres;
    std::vector<Pixel*> pixels;
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            const auto [chunk, i] = placeOf({x, y});
            Chunk& held = chunks_[{chunk.x, chunk.y}];
            held.resize(std::size_t(kChunk) * kChunk);
            if (!held[i].isKnown) {
                centres.emplace_back(x + 0.5, y + 0.5);
                pixels.push_back(&held[i]);
            }
        }
    }
    last_ = nullptr;
    if (centres.empty()) {
        return;
    }
    const auto points = pick(centres);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        *pixels[i] = {true, points[i].has_value(), points[i].value_or(ReliefPoint())};
    }
}

const ReliefPoint* Relief::at(glm::ivec2 pixel) const {
    const auto [chunk, i] = placeOf(pixel);
    if (last_ == nullptr || chunk != lastPlace_) {
        const auto found = chunks_.find({chunk.x, chunk.y});
        if (found == chunks_.end()) {
            return nullptr;
        }
        last_ = &found->second;
        lastPlace_ = chunk;
    }
    const Pixel& held = (*last_)[i];
    return held.isHit ? &held.point : nullptr;
}

const ReliefPoint* Relief::nearest(glm::dvec2 pixel, const glm::dvec3& world) const {
    const glm::ivec2 first(glm::floor(pixel - 0.5));
    const ReliefPoint* found = nullptr;
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 4; ++i) {
        const ReliefPoint* point = at(first + glm::ivec2(i & 1, i >> 1));
        const double apart =
            point != nullptr ? std::abs(glm::dot(world - point->world, point->normal)) : least;
        if (apart < least) {
            least = apart;
            found = point;
        }
    }
    return found;
}

} // namespace vs::marking
