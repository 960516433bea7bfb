// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/polygon_coverage.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vs::sculpt {

namespace {

struct Side {
    glm::dvec2 low; // smaller y
    glm::dvec2 high;

    [[nodiscard]] double xAt(double y) const {
        return low.x + (high.x - low.x) * std::clamp((y - low.y) / (high.y - low.y), 0.0, 1.0);
    }
};

std::vector<Side> sidesOf(std::span<const glm::dvec2> polygon) {
    std::vector<Side> sides;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const glm::dvec2 a = polygon[n];
        const glm::dvec2 b = polygon[(n + 1) % polygon.size()];
        if (a.y != b.y) {
            sides.push_back(a.y < b.y ? Side{a, b} : Side{b, a});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low.y < b.low.y; });
    return sides;
}

// The y at which two sides cross, if they do within [lo, hi].
std::optional<double> crossing(const Side& a, const Side& b, double lo, double hi) {
    const double before = a.xAt(lo) - b.xAt(lo);
    const double after = a.xAt(hi) - b.xAt(hi);
    if (before * after >= 0) {
        return std::nullopt;
    }
    return lo + (hi - lo) * before / (before - after);
}

// Integral of clamp(s, 0, 1) up to s.
double rampIntegral(double s) { return s <= 0 ? 0 : (s < 1 ? 0.5 * s * s : s - 0.5); }

// Adds `height` times the part of each element that lies to the right of a side going from x0 to x1.
void addRightOf(double x0, double x1, double height, std::vector<double>& row) {
    const double lo = std::min(x0, x1);
    const double hi = std::max(x0, x1);
    const int first = std::clamp(int(std::floor(lo)), 0, int(row.size()));
    for (int i = first; i < int(row.size()); ++i) {
        const double s = hi - lo < 1e-12 ? std::clamp(i + 1 - lo, 0.0, 1.0)
                                         : (rampIntegral(i + 1 - lo) - rampIntegral(i + 1 - hi)) / (hi - lo);
        row[std::size_t(i)] += height * s;
    }
}

// One row of elements, y to y + 1: bands between corners and crossings hold trapezoids only.
class RowCoverage {
public:
    explicit RowCoverage(std::vector<Side> active) : active_(std::move(active)) {}

    void add(double y, std::vector<double>& row) {
        const auto cuts = cutsWithin(y, y + 1);
        for (std::size_t n = 1; n < cuts.size(); ++n) {
            if (cuts[n] > cuts[n - 1]) {
                addBand(cuts[n - 1], cuts[n], row);
            }
        }
    }

private:
    [[nodiscard]] std::vector<double> cutsWithin(double lo, double hi) const {
        std::vector<double> cuts{lo, hi};
        for (const Side& side : active_) {
            cuts.push_back(std::clamp(side.low.y, lo, hi));
            cuts.push_back(std::clamp(side.high.y, lo, hi));
        }
        for (std::size_t a = 0; a < active_.size(); ++a) {
            for (std::size_t b = a + 1; b < active_.size(); ++b) {
                const double from = std::max({lo, active_[a].low.y, active_[b].low.y});
                const double to = std::min({hi, active_[a].high.y, active_[b].high.y});
                if (const auto y = from < to ? crossing(active_[a], active_[b], from, to) : std::nullopt) {
                    cuts.push_back(*y);
                }
            }
        }
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    void addBand(double lo, double hi, std::vector<double>& row) {
        const double middle = 0.5 * (lo + hi);
        crossed_.clear();
        for (const Side& side : active_) {
            if (side.low.y <= middle && side.high.y > middle) {
                crossed_.push_back(&side);
            }
        }
        std::sort(crossed_.begin(), crossed_.end(),
                  [&](const Side* a, const Side* b) { return a->xAt(middle) < b->xAt(middle); });
        double sign = hi - lo;
        for (const Side* side : crossed_) {
            addRightOf(side->xAt(lo), side->xAt(hi), sign, row);
            sign = -sign;
        }
    }

    std::vector<Side> active_;
    std::vector<const Side*> crossed_;
};

} // namespace

std::vector<float> polygonCoverage(std::span<const glm::dvec2> polygon, glm::ivec2 size) {
    const auto sides = sidesOf(polygon);
    std::vector<float> coverage(std::size_t(size.x) * std::size_t(size.y));
    std::vector<double> row(std::size_t(size.x));
    std::vector<Side> active;
    std::size_t next = 0;
    for (int j = 0; j < size.y; ++j) {
        std::erase_if(active, [&](const Side& side) { return side.high.y <= j; });
        for (; next < sides.size() && sides[next].low.y < j + 1.0; ++next) {
            if (sides[next].high.y > j) {
                active.push_back(sides[next]);
            }
        }
        std::fill(row.begin(), row.end(), 0.0);
        RowCoverage(active).add(j, row);
        std::transform(row.begin(), row.end(), coverage.begin() + std::ptrdiff_t(j) * size.x,
                       [](double c) { return float(std::clamp(c, 0.0, 1.0)); });
    }
    return coverage;
}

} // namespace vs::sculpt
