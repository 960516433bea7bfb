// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/outline_image.h"

#include "base/error.h"
#include "sculpt/mask/mask_image.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace vs::sculpt {

namespace {

// The 0.5 level of a raster by marching squares: it crosses the edges between elements, and within a cell of
// four elements joins the crossings. Edges are numbered: 2 n from element n to the next along x, 2 n + 1
// along y.
class LevelTracer {
public:
    explicit LevelTracer(const MaskRaster& mask) : mask_(mask) {}

    std::vector<Outline> trace() {
        for (int j = 0; j + 1 < mask_.size.y; ++j) {
            for (int i = 0; i + 1 < mask_.size.x; ++i) {
                joinCell(i, j);
            }
        }
        std::vector<Outline> loops;
        while (!links_.empty()) {
            loops.push_back(takeLoop(links_.begin()->first));
        }
        // The largest first, so that the joined outline begins on it.
        std::stable_sort(loops.begin(), loops.end(),
                         [](const Outline& a, const Outline& b) { return a.size() > b.size(); });
        return loops;
    }

private:
    [[nodiscard]] int number(int i, int j) const { return j * mask_.size.x + i; }
    [[nodiscard]] bool isInside(int i, int j) const { return mask_.at(i, j) >= 0.5F; }

    void join(int a, int b) {
        links_[a].push_back(b);
        links_[b].push_back(a);
    }

    void joinCell(int i, int j) {
        const int bottom = 2 * number(i, j);
        const int left = bottom + 1;
        const int top = 2 * number(i, j + 1);
        const int right = 2 * number(i + 1, j) + 1;
        // Around the cell: an edge is crossed where its two elements differ.
        const std::array<bool, 4> inside{isInside(i, j), isInside(i + 1, j), isInside(i + 1, j + 1),
                                         isInside(i, j + 1)};
        const std::array<int, 4> edges{bottom, right, top, left};
        std::vector<int> crossed;
        for (std::size_t n = 0; n < 4; ++n) {
            if (inside[n] != inside[(n + 1) % 4]) {
                crossed.push_back(edges[n]);
            }
        }
        if (crossed.size() == 2) {
            join(crossed[0], crossed[1]);
        } else if (crossed.size() == 4) { // two corners inside, across: they are kept apart
            inside[0] ? join(bottom, left) : join(bottom, right);
            inside[0] ? join(right, top) : join(top, left);
        }
    }

    [[nodiscard]] glm::dvec2 crossing(int edge) const {
        const glm::ivec2 a(edge / 2 % mask_.size.x, edge / 2 / mask_.size.x);
        const glm::ivec2 b = edge % 2 == 0 ? a + glm::ivec2(1, 0) : a + glm::ivec2(0, 1);
        const double from = mask_.at(a.x, a.y);
        const double to = mask_.at(b.x, b.y);
        return mask_.origin +
               mask_.pitch * glm::mix(glm::dvec2(a), glm::dvec2(b), (0.5 - from) / (to - from));
    }

    // Every crossing has two links: the raster's rim is outside.
    Outline takeLoop(int first) {
        Outline loop;
        int before = -1;
        for (int edge = first; links_.contains(edge);) {
            loop.push_back(crossing(edge));
            const std::vector<int> ways = links_[edge];
            const int next = ways[0] != before ? ways[0] : ways[1];
            if (next != first) {
                before = edge;
            }
            links_.erase(edge);
            edge = next;
        }
        return loop;
    }

    const MaskRaster& mask_;
    std::unordered_map<int, std::vector<int>> links_;
};

} // namespace

Outline outlineFromImage(const image::Image& picture, double width) {
    const MaskRaster mask = maskFromImage(picture, width, width / kOutlineElements);
    Outline joined;
    for (const Outline& loop : LevelTracer(mask).trace()) {
        joined.insert(joined.end(), loop.begin(), loop.end());
        joined.push_back(loop.front());
        joined.push_back(joined.front()); // and back to where all begin
    }
    if (joined.empty()) {
        throw Error(
            "the picture shows nothing to cut out: a mask is bright, or opaque, on dark or transparent");
    }
    joined.pop_back();
    return joined;
}

} // namespace vs::sculpt
