// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/vessel_path.h"

#include "base/check.h"
#include "base/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vs::segment {
namespace {

// The 27 voxels around one, x fastest, the voxel itself in the middle.
constexpr int kAround = 27;
constexpr int kItself = 13;

glm::ivec3 neighbourAt(int around) { return {around % 3 - 1, around / 3 % 3 - 1, around / 9 - 1}; }

glm::dmat3 stepsOf(const volume::GridGeometry& geometry) { return glm::dmat3(geometry.worldFromVoxel); }

// Calls visit(around, isInside, number, place) for the neighbours from `first` to before `end`, whole rows of
// three; the number is of those inside.
template <typename Visit>
void forEachNeighbour(const ConnectedVoxels& piece, std::size_t place, int firstRow, int endRow,
                      const Visit& visit) {
    for (int row = firstRow; row < endRow; ++row) {
        const auto begin = std::size_t(std::ptrdiff_t(place) + piece.stepTo(neighbourAt(3 * row)));
        const unsigned three = piece.threeFrom(begin);
        std::uint32_t number = three != 0 ? piece.numberAt(begin) : 0;
        for (unsigned x = 0; x < 3; ++x) {
            const bool isInside = (three >> x & 1) != 0;
            visit(3 * row + int(x), isInside, number, begin + x);
            number += isInside ? 1U : 0U;
        }
    }
}

// From a voxel to the nearest one outside.
class NearestOutside {
public:
    NearestOutside(const ConnectedVoxels& piece, const volume::GridGeometry& geometry)
        : piece_(piece), metric_(glm::transpose(stepsOf(geometry)) * stepsOf(geometry)),
          offsets_(piece.count()), squaredMm2_(piece.count(), std::numeric_limits<float>::infinity()) {
        for (int around = 0; around < kAround; ++around) {
            const glm::vec3 step(neighbourAt(around));
            const glm::vec3 slope = 2.0F * (metric_ * step);
            steps_[std::size_t(around)] = {slope, glm::dot(step, metric_ * step)};
        }
    }

    void look() {
        piece_.forEachPlace([this](std::size_t place) { lookAround(place, true); });
        piece_.forEachPlaceBackwards([this](std::size_t place) { lookAround(place, false); });
    }
    [[nodiscard]] std::vector<float> distancesMm() && {
        for (float& value : squaredMm2_) {
            value = std::sqrt(value);
        }
        return std::move(squaredMm2_);
    }

private:
    using Offset = std::array<std::int16_t, 3>;

    // What one voxel more in some direction adds to an offset's squared length: slope . offset + own.
    struct Step {
        glm::vec3 slope{0};
        float own = 0;
    };

    // On the way there: all voxels outside that are neighbours, and what those before have found; on the way
    // back what those after have found.
    void lookAround(std::size_t place, bool isWayThere) {
        const std::uint32_t own = piece_.numberAt(place);
        float least = squaredMm2_[own];
        Offset best = offsets_[own];
        const auto offer = [&](int around, const Offset& from, float squared) {
            if (squared < least) {
                least = squared;
                const glm::ivec3 step = neighbourAt(around);
                best = {std::int16_t(from[0] + step.x), std::int16_t(from[1] + step.y),
                        std::int16_t(from[2] + step.z)};
            }
        };
        const auto visit = [&](int around, bool isInside, std::uint32_t number, std::size_t) {
            const Step& step = steps_[std::size_t(around)];
            if (!isInside) {
                offer(around, {}, step.own);
            } else if (isWayThere ? around < kItself : around > kItself) {
                const Offset& known = offsets_[number];
                const float along =
                    step.slope.x * known[0] + step.slope.y * known[1] + step.slope.z * known[2];
                offer(around, known, squaredMm2_[number] + along + step.own);
            }
        };
        forEachNeighbour(piece_, place, isWayThere ? 0 : 4, isWayThere && isDeep(place) ? 5 : 9, visit);
        squaredMm2_[own] = least;
        offsets_[own] = best;
    }
    // Whether all voxels that come after a voxel around it are in the piece.
    [[nodiscard]] bool isDeep(std::size_t place) const {
        for (int row = 5; row < 9; ++row) {
            if (piece_.threeFrom(std::size_t(std::ptrdiff_t(place) + piece_.stepTo(neighbourAt(3 * row)))) !=
                7) {
                return false;
            }
        }
        return true;
    }

    const ConnectedVoxels& piece_;
    glm::mat3 metric_; // of offsets in voxels: their squared length in mm^2
    std::array<Step, kAround> steps_{};
    std::vector<Offset> offsets_;
    std::vector<float> squaredMm2_;
};

// A voxel that the search has come to.
struct Reached {
    double cost;
    std::uint32_t number;
    std::size_t place;
};

// What the search has come to, in the order of the costs but for those that differ by less than a bucket's
// width. As many buckets as the dearest step fills go around: a heap takes several times as long.
class OpenVoxels {
public:
    explicit OpenVoxels(double dearestStep) : width_(dearestStep / (kBuckets - 2)), buckets_(kBuckets) {}

    void push(const Reached& reached) {
        buckets_[std::size_t(reached.cost / width_) % kBuckets].push_back(reached);
        ++count_;
    }
    [[nodiscard]] bool isEmpty() const { return count_ == 0; }
    // Takes one of the cheapest out; there must be one. No bucket before the one that it was in has any.
    Reached pop() {
        while (buckets_[at_ % kBuckets].empty()) {
            ++at_;
        }
        auto& bucket = buckets_[at_ % kBuckets];
        const Reached cheapest = bucket.back();
        bucket.pop_back();
        --count_;
        return cheapest;
    }

private:
    static constexpr std::size_t kBuckets = 8192;
    double width_;
    std::vector<std::vector<Reached>> buckets_;
    std::size_t at_ = 0;
    std::size_t count_ = 0;
};

std::array<double, kAround> lengthsMm(const volume::GridGeometry& geometry) {
    std::array<double, kAround> lengths{};
    for (int around = 0; around < kAround; ++around) {
        lengths[std::size_t(around)] = glm::length(stepsOf(geometry) * glm::dvec3(neighbourAt(around)));
    }
    return lengths;
}

// For each number which neighbour the cheapest way comes from, as far as the search went until it had
// reached `to`.
std::vector<std::uint8_t> cheapestWays(const ConnectedVoxels& piece, const std::vector<float>& clearances,
                                       const std::array<double, kAround>& lengths, std::size_t from,
                                       std::size_t to) {
    std::vector<std::uint8_t> cameFrom(piece.count(), kItself);
    std::vector<double> costs(piece.count(), std::numeric_limits<double>::infinity());
    std::vector<float> halfPerMm; // half of what a mm costs at each voxel
    halfPerMm.reserve(clearances.size());
    for (const float clearance : clearances) {
        halfPerMm.push_back(0.5F / (clearance * clearance));
    }
    const double least = *std::min_element(clearances.begin(), clearances.end());
    OpenVoxels open(*std::max_element(lengths.begin(), lengths.end()) / (least * least));
    costs[piece.numberAt(from)] = 0;
    open.push({0, piece.numberAt(from), from});
    while (!open.isEmpty()) {
        const Reached at = open.pop();
        if (at.place == to) {
            break;
        }
        if (at.cost > costs[at.number]) {
            continue; // a cheaper way was found since
        }
        const double own = halfPerMm[at.number];
        const auto visit = [&](int around, bool isInside, std::uint32_t number, std::size_t place) {
            if (!isInside || costs[number] <= at.cost) {
                return;
            }
            const double cost = at.cost + lengths[std::size_t(around)] * (own + halfPerMm[number]);
            if (cost < costs[number]) {
                costs[number] = cost;
                cameFrom[number] = std::uint8_t(kAround - 1 - around);
                open.push({cost, number, place});
            }
        };
        forEachNeighbour(piece, at.place, 0, 9, visit);
    }
    return cameFrom;
}

} // namespace

std::vector<float> clearancesMm(const ConnectedVoxels& piece, const volume::GridGeometry& geometry) {
    reportProgress();
    NearestOutside nearest(piece, geometry);
    nearest.look();
    return std::move(nearest).distancesMm();
}

VesselPath pathBetween(const ConnectedVoxels& piece, const volume::GridGeometry& geometry, glm::ivec3 from,
                       glm::ivec3 to) {
    const std::vector<float> clearances = clearancesMm(piece, geometry);
    reportProgress();
    const std::size_t start = piece.placeOf(from);
    const auto cameFrom = cheapestWays(piece, clearances, lengthsMm(geometry), start, piece.placeOf(to));
    VesselPath path;
    for (std::size_t place = piece.placeOf(to);;) {
        const std::uint32_t number = piece.numberAt(place);
        path.voxels.push_back(piece.voxelAt(place));
        path.clearanceMm.push_back(clearances[number]);
        if (place == start) {
            break;
        }
        VS_CHECK(cameFrom[number] != kItself); // the piece is connected
        place = std::size_t(std::ptrdiff_t(place) + piece.stepTo(neighbourAt(cameFrom[number])));
    }
    std::reverse(path.voxels.begin(), path.voxels.end());
    std::reverse(path.clearanceMm.begin(), path.clearanceMm.end());
    return path;
}

} // namespace vs::segment
