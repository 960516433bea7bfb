// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/mask.h"

#include "base/error.h"
#include "sculpt/mask/polygon_coverage.h"

#include <algorithm>
#include <array>
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

// Cells [begin, end) of a row.
struct Run {
    int begin = 0;
    int end = 0;
};

// Which sub-sample cells of one row are inside, as runs. Cells that an edge passes through are tested at
// their (jittered) sample, the runs between them by one test each.
class RowSampler {
public:
    RowSampler(std::vector<Edge> edges, int width, const MaskFilter& filter)
        : edges_(std::move(edges)), width_(width), filter_(filter) {
        std::sort(edges_.begin(), edges_.end(),
                  [](const Edge& a, const Edge& b) { return a.top.y < b.top.y; });
    }

    // Rows must be asked for in ascending order.
    const std::vector<Run>& row(int y) {
        collectActive(y);
        collectTouched(y);
        inside_.clear();
        left_.clear();
        isLeftOfOdd_ = false;
        near_.clear();
        std::size_t next = 0;
        int x = 0;
        while (x < width_ && !active_.empty()) {
            for (; next < touched_.size() && touched_[next].cells.begin <= x; ++next) {
                near_.push_back(touched_[next]);
            }
            std::erase_if(near_, [&](const Touched& touched) { return passes(touched, x); });
            if (near_.empty()) { // up to the next edge one test serves all cells
                const int end = next < touched_.size() ? touched_[next].cells.begin : width_;
                addIf(isInside(x + 0.5, y + 0.5), {x, end});
                x = end;
            } else {
                addIf(isSampleInside(x, y), {x, x + 1});
                ++x;
            }
        }
        return inside_;
    }

private:
    // An edge and the cells of the row that it passes through, or the first or last one if it lies beyond.
    struct Touched {
        Run cells;
        const Edge* edge;
        bool isWhole; // it crosses every height in the row
    };

    void collectActive(int y) {
        std::erase_if(active_, [&](const Edge& edge) { return edge.bottom.y <= y; });
        while (next_ < edges_.size() && edges_[next_].top.y < y + 1.0) {
            if (edges_[next_].bottom.y > y) {
                active_.push_back(edges_[next_]);
            }
            ++next_;
        }
    }

    void collectTouched(int y) {
        touched_.clear();
        for (const Edge& edge : active_) {
            const double x0 = edge.xAt(y);
            const double x1 = edge.xAt(y + 1.0);
            const Run cells{std::clamp(int(std::floor(std::min(x0, x1) - 1e-9)), 0, width_ - 1),
                            std::clamp(int(std::floor(std::max(x0, x1) + 1e-9)), 0, width_ - 1) + 1};
            touched_.push_back({cells, &edge, edge.top.y <= y && edge.bottom.y >= y + 1.0});
        }
        std::sort(touched_.begin(), touched_.end(),
                  [](const Touched& a, const Touched& b) { return a.cells.begin < b.cells.begin; });
    }

    // Whether an edge lies to the left of cell x and all that follow, which is noted.
    bool passes(const Touched& touched, int x) {
        if (touched.cells.end > x) {
            return false;
        }
        if (touched.isWhole) {
            isLeftOfOdd_ = !isLeftOfOdd_;
        } else {
            left_.push_back(touched.edge);
        }
        return true;
    }

    [[nodiscard]] bool isInside(double x, double y) const {
        bool parity = isLeftOfOdd_;
        for (const Edge* edge : left_) {
            parity = parity != edge->crosses(y);
        }
        for (const Touched& touched : near_) {
            parity = parity != (touched.edge->crosses(y) && touched.edge->xAt(y) <= x);
        }
        return parity;
    }

    [[nodiscard]] bool isSampleInside(int x, int y) const {
        const bool jittered = filter_.sampling == Sampling::Jittered;
        const auto ux = std::uint32_t(x);
        const auto uy = std::uint32_t(y);
        return isInside(x + (jittered ? jitterAt(ux, uy, filter_.seed * 2) : 0.5),
                        y + (jittered ? jitterAt(ux, uy, filter_.seed * 2 + 1) : 0.5));
    }

    void addIf(bool isIn, Run run) {
        if (isIn && !inside_.empty() && inside_.back().end == run.begin) {
            inside_.back().end = run.end;
        } else if (isIn) {
            inside_.push_back(run);
        }
    }

    std::vector<Edge> edges_;
    std::vector<Edge> active_;
    std::size_t next_ = 0;
    int width_;
    MaskFilter filter_;
    std::vector<Touched> touched_; // in the row, from left to right
    std::vector<Run> inside_;
    // At the cell that is looked at: the edges that may pass through it, and those to its left, of which the
    // ones that cross the whole row are counted.
    std::vector<Touched> near_;
    std::vector<const Edge*> left_;
    bool isLeftOfOdd_ = false;
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

// Filters rows of sub-samples into elements: value i is the weighted sum of cells [first + i * kSub, +
// width).
class RowFilter {
public:
    RowFilter(const std::vector<float>& weights, int first)
        : width_(int(weights.size())), first_(first), upTo_(weights.size() + 1, 0.0F) {
        double sum = 0;
        for (std::size_t n = 0; n < weights.size(); ++n) {
            sum += weights[n];
            upTo_[n + 1] = float(sum);
        }
        upTo_.back() = 1;
    }

    // Returns the elements that are not zero.
    Run filter(const std::vector<Run>& inside, std::vector<float>& out) const {
        const int count = int(out.size());
        std::fill(out.begin(), out.end(), 0.0F);
        Run all{count, 0};
        for (const Run& run : inside) {
            const int lo = std::max((run.begin - first_ - width_) / kSub, 0);
            const int hi = std::min((run.end - 1 - first_) / kSub + 1, count);
            for (int i = lo; i < hi; ++i) {
                const int begin = first_ + i * kSub;
                const int from = std::clamp(run.begin - begin, 0, width_);
                const int to = std::clamp(run.end - begin, 0, width_);
                out[std::size_t(i)] += upTo_[std::size_t(to)] - upTo_[std::size_t(from)];
            }
            all = {std::min(all.begin, lo), std::max(all.end, hi)};
        }
        return all;
    }

private:
    int width_;
    int first_;
    std::vector<float> upTo_; // sum of the first n weights
};

// One test at each element's centre.
void fillBinary(const Outline& outline, MaskRaster& mask) {
    MaskFilter centres;
    centres.sampling = Sampling::Uniform;
    RowSampler sampler(edgesOf(outline, mask.origin - 0.5 * mask.pitch, mask.pitch), mask.size.x, centres);
    for (int j = 0; j < mask.size.y; ++j) {
        const auto row = mask.values.begin() + std::ptrdiff_t(j) * mask.size.x;
        for (const Run& run : sampler.row(j)) {
            std::fill(row + run.begin, row + run.end, 1.0F);
        }
    }
}

void fillFiltered(const Outline& outline, const MaskFilter& filter, MaskRaster& mask) {
    const auto weights = reconstructionWeights(filter.reconstruction, filter.width);
    const int width = int(weights.size());
    const int first = kSub / 2 - width / 2; // of element 0: its support is centred on its centre
    RowSampler sampler(edgesOf(outline, mask.origin - 0.5 * mask.pitch, mask.pitch / kSub),
                       mask.size.x * kSub, filter);
    const RowFilter rowFilter(weights, first);
    std::vector<float> row(std::size_t(mask.size.x));
    for (int y = 0; y < mask.size.y * kSub; ++y) {
        const Run run = rowFilter.filter(sampler.row(y), row);
        // This row of sub-samples is row (y - first - j * kSub) of the support of element row j.
        const int top = y - first;
        for (int j = std::max(0, (top - width + kSub) / kSub); j < mask.size.y && top - j * kSub >= 0; ++j) {
            const float weight = weights[std::size_t(top - j * kSub)];
            float* target = &mask.values[std::size_t(j) * std::size_t(mask.size.x)];
            for (int i = run.begin; i < run.end; ++i) {
                target[i] += weight * row[std::size_t(i)];
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

std::vector<std::uint16_t> flatness(const MaskRaster& mask) {
    // The chessboard distance to elements with a neighbour of another value, in two passes (Rosenfeld and
    // Pfaltz 1968, "Distance functions on digital pictures").
    constexpr int kMost = 0xFFFF;
    const glm::ivec2 size = mask.size;
    std::vector<std::uint16_t> flat(mask.values.size(), kMost);
    const auto isIn = [&](glm::ivec2 e) { return e.x >= 0 && e.y >= 0 && e.x < size.x && e.y < size.y; };
    const auto indexOf = [&](glm::ivec2 e) {
        return std::size_t(e.y) * std::size_t(size.x) + std::size_t(e.x);
    };
    constexpr std::array<glm::ivec2, 4> kBefore{glm::ivec2(-1, 0), {-1, -1}, {0, -1}, {1, -1}};
    const auto pass = [&](glm::ivec2 e, int sign) {
        std::uint16_t& own = flat[indexOf(e)];
        for (const glm::ivec2& step : kBefore) {
            const glm::ivec2 other = e + sign * step;
            const bool isSame = (isIn(other) ? mask.values[indexOf(other)] : 0.0F) == mask.values[indexOf(e)];
            const int reached = !isSame ? 0 : (isIn(other) ? flat[indexOf(other)] + 1 : kMost);
            own = std::uint16_t(std::min<int>(own, reached));
        }
    };
    for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i) {
            pass({i, j}, 1);
        }
    }
    for (int j = size.y - 1; j >= 0; --j) {
        for (int i = size.x - 1; i >= 0; --i) {
            pass({i, j}, -1);
        }
    }
    return flat;
}

double filterReach(const MaskFilter& filter) {
    // Elements farther from the outline than half the filter's support are zero; one more closes the raster
    // with zeros.
    const bool isFiltered = filter.sampling == Sampling::Uniform || filter.sampling == Sampling::Jittered;
    return 1 + (isFiltered ? 0.5 * filter.width / kSub : 0.5);
}

MaskRaster rasterize(const Outline& outline, double pitch, const MaskFilter& filter) {
    MaskRaster mask;
    mask.pitch = pitch;
    if (outline.size() < 3) {
        return mask;
    }
    const MaskWindow window = windowAround(outline);
    const double room = filterReach(filter);
    const glm::dvec2 first = glm::floor(window.lo / pitch - room);
    const glm::dvec2 count = glm::ceil(window.hi / pitch + room) + 1.0 - first;
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
