// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask.h"

#include "base/error.h"
#include "sculpt/polygon_coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::sculpt {

namespace {

constexpr int kSub = MaskFilter::kSubSamples;

// A number in [0, 1) from place and seed (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering": pcg).
double jitterAt(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t state = (x * 1664525U + y * 22695477U + seed * 747796405U) + 2891336453U;
    state = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    state = (state >> 22U) ^ state;
    return state * (1.0 / 4294967296.0);
}

// Edges in sub-sample cells: cell c spans [c, c + 1).
struct Edge {
    glm::dvec2 top; // smaller y
    glm::dvec2 bottom;

    [[nodiscard]] double xAt(double y) const {
        return top.x + (bottom.x - top.x) * std::clamp((y - top.y) / (bottom.y - top.y), 0.0, 1.0);
    }
    [[nodiscard]] bool crosses(double y) const { return y >= top.y && y < bottom.y; }
};

// Which sub-sample cells of one row are inside. Cells that an edge passes through are tested at their
// (jittered) sample, the runs between them by one test each.
class RowSampler {
public:
    RowSampler(std::vector<Edge> edges, int width, const MaskFilter& filter)
        : edges_(std::move(edges)), filter_(filter), isEdge_(std::size_t(width)),
          inside_(std::size_t(width)) {
        std::sort(edges_.begin(), edges_.end(),
                  [](const Edge& a, const Edge& b) { return a.top.y < b.top.y; });
    }

    // Rows must be asked for in ascending order.
    const std::vector<std::uint8_t>& row(int y) {
        collectActive(y);
        const int width = int(inside_.size());
        std::fill(isEdge_.begin(), isEdge_.end(), std::uint8_t(0));
        for (const Edge& edge : active_) {
            const double x0 = edge.xAt(y);
            const double x1 = edge.xAt(y + 1.0);
            const int first = std::clamp(int(std::floor(std::min(x0, x1) - 1e-9)), 0, width - 1);
            const int last = std::clamp(int(std::floor(std::max(x0, x1) + 1e-9)), 0, width - 1);
            std::fill(isEdge_.begin() + first, isEdge_.begin() + last + 1, std::uint8_t(1));
        }
        for (int x = 0; x < width;) {
            if (isEdge_[std::size_t(x)] != 0) {
                const bool jittered = filter_.sampling == Sampling::Jittered;
                const auto ux = std::uint32_t(x);
                const auto uy = std::uint32_t(y);
                const double dx = jittered ? jitterAt(ux, uy, filter_.seed * 2) : 0.5;
                const double dy = jittered ? jitterAt(ux, uy, filter_.seed * 2 + 1) : 0.5;
                inside_[std::size_t(x)] = isInside(x + dx, y + dy);
                ++x;
            } else {
                int end = x;
                while (end < width && isEdge_[std::size_t(end)] == 0) {
                    ++end;
                }
                const std::uint8_t value = isInside(x + 0.5, y + 0.5);
                std::fill(inside_.begin() + x, inside_.begin() + end, value);
                x = end;
            }
        }
        return inside_;
    }

private:
    void collectActive(int y) {
        std::erase_if(active_, [&](const Edge& edge) { return edge.bottom.y <= y; });
        while (next_ < edges_.size() && edges_[next_].top.y < y + 1.0) {
            if (edges_[next_].bottom.y > y) {
                active_.push_back(edges_[next_]);
            }
            ++next_;
        }
    }

    [[nodiscard]] std::uint8_t isInside(double x, double y) const {
        std::uint8_t parity = 0;
        for (const Edge& edge : active_) {
            parity ^= std::uint8_t(edge.crosses(y) && edge.xAt(y) <= x);
        }
        return parity;
    }

    std::vector<Edge> edges_;
    std::vector<Edge> active_;
    std::size_t next_ = 0;
    MaskFilter filter_;
    std::vector<std::uint8_t> isEdge_;
    std::vector<std::uint8_t> inside_;
};

std::vector<Edge> edgesOf(const Outline& outline, glm::dvec2 corner, double cell) {
    std::vector<Edge> edges;
    for (std::size_t n = 0; n < outline.size(); ++n) {
        const glm::dvec2 a = (outline[n] - corner) / cell;
        const glm::dvec2 b = (outline[(n + 1) % outline.size()] - corner) / cell;
        if (a.y != b.y) {
            edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
        }
    }
    return edges;
}

// Filters one row of sub-samples into elements: value i is the weighted sum of cells [first + i * kSub, +
// width).
void filterRow(const std::vector<std::uint8_t>& inside, const std::vector<float>& weights, int first,
               std::vector<int>& prefix, std::vector<float>& out) {
    prefix.resize(inside.size() + 1);
    prefix[0] = 0;
    for (std::size_t x = 0; x < inside.size(); ++x) {
        prefix[x + 1] = prefix[x] + inside[x];
    }
    const int width = int(weights.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const int begin = first + int(i) * kSub;
        const int lo = std::max(begin, 0);
        const int hi = std::min(begin + width, int(inside.size()));
        const int filled = hi > lo ? prefix[std::size_t(hi)] - prefix[std::size_t(lo)] : 0;
        if (filled == 0 || filled == width) { // away from edges
            out[i] = filled == 0 ? 0.0F : 1.0F;
            continue;
        }
        float sum = 0;
        for (int x = lo; x < hi; ++x) {
            sum += weights[std::size_t(x - begin)] * float(inside[std::size_t(x)]);
        }
        out[i] = sum;
    }
}

// One test at each element's centre.
void fillBinary(const Outline& outline, MaskRaster& mask) {
    MaskFilter centres;
    centres.sampling = Sampling::Uniform;
    RowSampler sampler(edgesOf(outline, mask.origin - 0.5 * mask.pitch, mask.pitch), mask.size.x, centres);
    for (int j = 0; j < mask.size.y; ++j) {
        const auto& inside = sampler.row(j);
        std::copy(inside.begin(), inside.end(), mask.values.begin() + std::ptrdiff_t(j) * mask.size.x);
    }
}

void fillFiltered(const Outline& outline, const MaskFilter& filter, MaskRaster& mask) {
    const auto weights = reconstructionWeights(filter.reconstruction, filter.width);
    const int width = int(weights.size());
    const int first = kSub / 2 - width / 2; // of element 0: its support is centred on its centre
    RowSampler sampler(edgesOf(outline, mask.origin - 0.5 * mask.pitch, mask.pitch / kSub),
                       mask.size.x * kSub, filter);
    std::vector<int> prefix;
    std::vector<float> row(std::size_t(mask.size.x));
    for (int y = 0; y < mask.size.y * kSub; ++y) {
        filterRow(sampler.row(y), weights, first, prefix, row);
        // This row of sub-samples is row (y - first - j * kSub) of the support of element row j.
        const int top = y - first;
        for (int j = std::max(0, (top - width + kSub) / kSub); j < mask.size.y && top - j * kSub >= 0; ++j) {
            const float weight = weights[std::size_t(top - j * kSub)];
            float* target = &mask.values[std::size_t(j) * std::size_t(mask.size.x)];
            for (std::size_t i = 0; i < row.size(); ++i) {
                target[i] += weight * row[i];
            }
        }
    }
    for (float& value : mask.values) {
        value = std::clamp(value, 0.0F, 1.0F);
    }
}

// Each element's square, exactly.
void fillCoverage(const Outline& outline, MaskRaster& mask) {
    Outline inElements;
    for (const glm::dvec2& point : outline) {
        inElements.push_back((point - mask.origin) / mask.pitch + 0.5);
    }
    mask.values = polygonCoverage(inElements, mask.size);
}

} // namespace

MaskRaster rasterize(const Outline& outline, double pitch, const MaskFilter& filter) {
    MaskRaster mask;
    mask.pitch = pitch;
    if (outline.size() < 3) {
        return mask;
    }
    glm::dvec2 lo = outline.front();
    glm::dvec2 hi = outline.front();
    for (const glm::dvec2& point : outline) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    // Elements farther from the outline than half the filter's support are zero; one more closes the raster
    // with zeros.
    const bool isFiltered = filter.sampling == Sampling::Uniform || filter.sampling == Sampling::Jittered;
    const double reach = isFiltered ? 0.5 * filter.width / kSub : 0.5;
    const glm::dvec2 first = glm::floor(lo / pitch - reach) - 1.0;
    const glm::dvec2 count = glm::ceil(hi / pitch + reach) + 2.0 - first;
    if (!(count.x * count.y <= 64e6)) {
        throw Error("a mask of {:.0f} x {:.0f} elements is more than 64 million; draw it smaller or coarser",
                    count.x, count.y);
    }
    mask.origin = first * pitch;
    mask.size = glm::ivec2(count);
    mask.values.assign(std::size_t(mask.size.x) * std::size_t(mask.size.y), 0.0F);
    if (filter.sampling == Sampling::None) {
        fillBinary(outline, mask);
    } else if (filter.sampling == Sampling::PolygonSmooth) {
        fillCoverage(outline, mask);
    } else {
        fillFiltered(outline, filter, mask);
    }
    return mask;
}

} // namespace vs::sculpt
