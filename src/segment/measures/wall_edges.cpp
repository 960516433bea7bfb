// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/wall_edges.h"

#include "base/parallel.h"
#include "base/statistics.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vs::segment {
namespace {

constexpr double kNoShare = std::numeric_limits<double>::quiet_NaN();

WallFit fitAt(const Lumen& lumen, const Station& station, double radiusMm, const ScanEdges* edges) {
    // A wall is told by the voxels of some layers across the axis.
    WallFit fit;
    fit.alongMm = station.alongMm;
    fit.sigmaMm = 1.5 * std::max(lumen.stepMm, lumen.apartMm(station.tangent));
    fit.stepMm = lumen.stepMm;
    fit.expectedMm = radiusMm;
    if (edges != nullptr) {
        // The more noise there is, the more voxels are needed.
        fit.sigmaMm *= std::clamp(edges->noise / 0.07, 0.7, 2.0);
        fit.shareNoise = std::max(0.1, edges->noise);
        fit.footprint = footprintAt(lumen, station, edges->sight);
    }
    return fit;
}

std::span<const std::vector<WallVoxel>> voxelsAround(const WallVoxels& voxels, const Curve& curve,
                                                     const WallFit& fit) {
    const auto isBefore = [](const Station& s, double along) { return s.alongMm < along; };
    const auto first =
        std::lower_bound(curve.begin(), curve.end(), fit.alongMm - 2.5 * fit.sigmaMm, isBefore);
    const auto last = std::lower_bound(first, curve.end(), fit.alongMm + 2.5 * fit.sigmaMm, isBefore);
    const auto begin = std::size_t(std::max<std::ptrdiff_t>(0, first - curve.begin() - 1));
    const std::size_t end = std::min(curve.size() - 1, std::size_t(last - curve.begin()));
    return std::span(voxels).subspan(begin, end - begin);
}

// Gives the voxels at each station their shares.
void addShares(const ScanValues& values, const std::vector<Plateaus>& plateaus, WallVoxels& voxels) {
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        for (WallVoxel& voxel : voxels[i]) {
            const double outside = plateaus[i].outside[voxel.ray];
            voxel.share = (values.at(voxel.voxel) - outside) / (plateaus[i].inside - outside);
        }
    }
}

// The share that a wall gives a voxel.
double shareBy(const WallShape& wall, const WallFit& fit, const WallVoxel& voxel) {
    const double radius = wall.radiusAtMm(voxel, fit.alongMm);
    return wall.full() * WallParts(fit.footprint, voxel).inside(radius).part;
}

// Tells in which directions the shares change as at an edge, by how wrong they are for a wall that was found
// by them.
class EdgeCheck {
public:
    EdgeCheck(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit, const WallShape& wall) {
        for (const auto& group : groups) {
            for (const WallVoxel& voxel : group) {
                const double sigmas = (voxel.alongMm - fit.alongMm) / fit.sigmaMm;
                if (std::abs(sigmas) > 2.5 || std::isnan(voxel.share)) {
                    continue;
                }
                const double wrong = shareBy(wall, fit, voxel) - voxel.share;
                const double weight = std::exp(-0.5 * sigmas * sigmas);
                for (const std::size_t turn : {kRays - 1, std::size_t{0}, std::size_t{1}}) {
                    squares_[(voxel.ray + turn) % kRays] += weight * wrong * wrong;
                    weights_[(voxel.ray + turn) % kRays] += weight;
                }
            }
        }
    }
    [[nodiscard]] bool isEdge(std::size_t ray) const {
        // Noise of 0.15 is common, and walls are not quite as they are thought to be.
        constexpr double kMostWrong = 0.3;
        return weights_[ray] > 0 && squares_[ray] < kMostWrong * kMostWrong * weights_[ray];
    }

private:
    std::array<double, kRays> squares_{}, weights_{};
};

// In which directions a wall found by the shares is one that the mask means too.
using RayFlags = std::array<bool, kRays>;
RayFlags wallEdges(const Lumen& lumen, const Station& station, const EdgeCheck& check,
                   const WallShape& byShares, const WallShape& byMask) {
    // In voxels. A mask that was grown or shrunk by one is off by as much in directions between the axes, and
    // more in most.
    constexpr double kFarthest = 0.6;
    RayFlags edges{};
    for (std::size_t ray = 0; ray < kRays; ++ray) {
        const double angle = glm::two_pi<double>() * double(ray) / double(kRays);
        const double off = std::abs(byShares.radiusMm(angle) - byMask.radiusMm(angle));
        edges[ray] = check.isEdge(ray) && off < kFarthest * lumen.apartMm(rayOf(station, ray));
    }
    return edges;
}

// Takes the shares of voxels where there is no edge; returns whether there were any.
bool dropShares(const std::vector<RayFlags>& isEdge, WallVoxels& voxels) {
    bool isDropped = false;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        for (WallVoxel& voxel : voxels[i]) {
            if (!std::isnan(voxel.share) && !isEdge[i][voxel.ray]) {
                voxel.share = kNoShare;
                isDropped = true;
            }
        }
    }
    return isDropped;
}

// How wrong the shares are for a wall, or, where that has no radius, for the mask: the sum of their squares.
// Those beyond all measure belong to something else.
double wrongOf(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit, const WallShape& wall) {
    double sum = 0;
    for (const auto& group : groups) {
        for (const WallVoxel& voxel : group) {
            const double sigmas = (voxel.alongMm - fit.alongMm) / fit.sigmaMm;
            if (std::abs(sigmas) > 2.5 || std::isnan(voxel.share)) {
                continue;
            }
            const double share = wall.level() > 0 ? shareBy(wall, fit, voxel) : double(voxel.isInside);
            const double wrong = share - voxel.share;
            sum += std::exp(-0.5 * sigmas * sigmas) * std::min(wrong * wrong, 0.5);
        }
    }
    return sum;
}

// Where a function that has one lowest place is least, and what it is there.
struct Least {
    double at = 0, value = 0;
};
// Among places in rising order, and between them by the parabola through the lowest and its neighbours.
Least leastAmong(const std::vector<double>& places, const std::function<double(double)>& function) {
    std::vector<double> values;
    std::size_t best = 0;
    for (const double place : places) {
        values.push_back(function(place));
        best = values.back() < values[best] ? values.size() - 1 : best;
        if (values.size() > best + 2) {
            break;
        }
    }
    Least least{places[best], values[best]};
    if (best > 0 && best + 1 < values.size()) {
        const double before = places[best] - places[best - 1];
        const double after = places[best + 1] - places[best];
        const double down = (values[best - 1] - values[best]) / before;
        const double up = (values[best + 1] - values[best]) / after;
        if (down + up > 0) {
            least.at += 0.5 * (down * after - up * before) / (down + up);
        }
    }
    return least;
}

// The sight that is least wrong, and how wrong it is.
struct LeastWrong {
    Sight sight;
    double wrong = 0;
};
LeastWrong leastWrong(const Lumen& lumen, const std::function<double(const Sight&)>& wrongWith) {
    LeastWrong found;
    const auto findBlur = [&](double thickness) {
        // In steps squared: variances add up, so wrongness is nearly a parabola in them.
        const Least blur = leastAmong({0, 0.15, 0.35, 0.65, 1, 1.6, 2.5}, [&](double variance) {
            return wrongWith({std::sqrt(variance) * lumen.stepMm, thickness});
        });
        found = {{std::sqrt(blur.at) * lumen.stepMm, thickness}, blur.value};
        return blur.value;
    };
    constexpr double kThick = 1.4; // slices that are not this much thicker than a step tell nothing of it
    const bool areThick = lumen.coarseMm > kThick * lumen.stepMm;
    const Least squared =
        areThick ? leastAmong({0, 0.25, 0.6, 1},
                              [&](double thicknessSquared) { return findBlur(std::sqrt(thicknessSquared)); })
                 : Least{1, 0};
    findBlur(std::sqrt(squared.at));
    return found;
}

// The noise in parts of the contrast, in the middle of the stations.
double noiseOf(const std::vector<Plateaus>& plateaus) {
    std::vector<double> parts;
    for (const Plateaus& at : plateaus) {
        for (const double outside : at.outside) {
            if (!std::isnan(outside)) {
                parts.push_back(at.noise / std::abs(at.inside - outside));
            }
        }
    }
    return median(parts);
}

} // namespace

std::optional<ScanEdges> scanEdgesAlong(const ScanValues& values, const Lumen& lumen,
                                        const Centreline& line) {
    constexpr std::size_t kStations = 12;
    const Curve& curve = line.curve;
    const auto outlines = outlinesAlong(lumen, curve, line.radiiMm);
    WallVoxels voxels = wallVoxels(lumen, curve, outlines);
    std::vector<WallShape> walls(curve.size());
    const std::size_t every = std::max<std::size_t>(1, curve.size() / kStations);
    // Calls work(fit, voxels, wall) at some stations, and adds up what it returns.
    const auto sumOf = [&](const ScanEdges& edges, const auto& work) {
        double sum = 0;
        for (std::size_t i = every / 2; i < curve.size(); i += every) {
            const WallFit fit = fitAt(lumen, curve[i], line.radiiMm[i], &edges);
            sum += work(fit, voxelsAround(voxels, curve, fit), walls[i]);
        }
        return sum;
    };
    sumOf({values}, [](const WallFit& fit, auto groups, WallShape& wall) {
        wall = fittedWall(groups, fit);
        return 0.0;
    });
    const std::vector<Plateaus> plateaus = plateausAlong(values, lumen, curve, outlines);
    addShares(values, plateaus, voxels);
    const double byMask = sumOf(
        {values}, [](const WallFit& fit, auto groups, const WallShape&) { return wrongOf(groups, fit, {}); });
    const auto wrongWith = [&](const Sight& sight) {
        return sumOf({values, sight}, [](const WallFit& fit, auto groups, WallShape& wall) {
            wall = wallByShares(groups, fit, wall);
            return wrongOf(groups, fit, wall);
        });
    };
    const LeastWrong least = leastWrong(lumen, wrongWith);
    if (!(least.wrong < byMask)) {
        return {};
    }
    return ScanEdges{values, least.sight, noiseOf(plateaus)};
}

std::vector<WallShape> wallsAlong(const Lumen& lumen, const Centreline& line, const ScanEdges* edges) {
    const Curve& curve = line.curve;
    const auto outlines = outlinesAlong(lumen, curve, line.radiiMm);
    WallVoxels voxels = wallVoxels(lumen, curve, outlines);
    std::vector<WallShape> walls(curve.size());
    const auto forEachFit = [&](const ScanEdges* told, const auto& work) {
        inParallel(int(curve.size()), [&](int station) {
            const auto i = std::size_t(station);
            const WallFit fit = fitAt(lumen, curve[i], line.radiiMm[i], told);
            work(i, fit, voxelsAround(voxels, curve, fit));
        });
    };
    forEachFit(nullptr,
               [&](std::size_t i, const WallFit& fit, auto groups) { walls[i] = fittedWall(groups, fit); });
    if (edges == nullptr) {
        return walls;
    }
    addShares(edges->values, plateausAlong(edges->values, lumen, curve, outlines), voxels);
    std::vector<WallShape> byShares(curve.size());
    std::vector<RayFlags> isEdge(curve.size());
    forEachFit(edges, [&](std::size_t i, const WallFit& fit, auto groups) {
        byShares[i] = wallByShares(groups, fit, walls[i]);
        isEdge[i] = wallEdges(lumen, curve[i], EdgeCheck(groups, fit, byShares[i]), byShares[i], walls[i]);
    });
    const bool isDropped = dropShares(isEdge, voxels);
    forEachFit(edges, [&](std::size_t i, const WallFit& fit, auto groups) {
        const auto told = std::count(isEdge[i].begin(), isEdge[i].end(), true);
        if (std::size_t(told) >= kRays / 2) {
            walls[i] = isDropped ? wallByShares(groups, fit, byShares[i]) : byShares[i];
        }
    });
    return walls;
}

} // namespace vs::segment
