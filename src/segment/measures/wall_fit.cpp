// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/wall_fit.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

constexpr std::size_t kMostNumbers = WallShape::kNumbers;
constexpr std::size_t kFull = WallShape::kFull;
constexpr std::size_t kLevel = WallShape::kLevel;
constexpr std::size_t kSlope = WallShape::kSlope;
constexpr std::size_t kBend = WallShape::kBend;
constexpr std::size_t cosineAt(std::size_t harmonic) { return kBend + 2 * harmonic - 1; }
constexpr std::size_t sineAt(std::size_t harmonic) { return kBend + 2 * harmonic; }
constexpr std::size_t kMostWitnesses = 700;
using Numbers = std::array<double, kMostNumbers>;
using Square = std::array<Numbers, kMostNumbers>; // lower triangle

// A voxel as the fit sees it.
struct Witness {
    Numbers factors; // of the wall's numbers
    double radius;
    double side; // 1 inside, -1 outside
    double weight;
    double share;    // as WallVoxel has it
    WallParts parts; // for shares
};

// What a witness has against a wall: a value, and its first and second derivative by a quantity that changes
// with the wall's radius and with what a full share is.
struct Objection {
    double value = 0, slope = 0, stiffness = 0;
    double byRadius = 1, byFull = 0;
};

// A voxel in or out of the mask: the wall should pass it on its side, clearly for how soft the problem is.
Objection objectionOfSide(const Witness& w, double wall, double soft) {
    const double margin = w.side * (wall - w.radius) / soft;
    if (margin > 8) {
        return {}; // well on its side
    }
    const double wrong = 1 / (1 + std::exp(margin)); // how likely it is to be on the other side
    return {w.weight * (margin < -30 ? -margin : std::log1p(std::exp(-margin))),
            -w.weight * w.side * wrong / soft, w.weight * wrong * (1 - wrong) / (soft * soft)};
}

// A voxel with a share: the wall should leave as much of it inside. Shares that are quite wrong, by what lies
// beside the vessel, pull no stronger than those that are a little wrong.
Objection objectionOfShare(const Witness& w, double wall, double full, double noise) {
    constexpr double kQuite = 0.35;
    const auto [part, rise] = w.parts.inside(wall);
    const double wrong = full * part - w.share;
    const double change = full * rise;
    const double less = std::min(1.0, kQuite / std::max(std::abs(wrong), 1e-9));
    const double weight = w.weight * less / (noise * noise);
    return {weight * wrong * wrong * (1 - 0.5 * less), weight * wrong, weight, change, part};
}

// The wall as the solution of a convex problem: the sum over the voxels of weight log(1 + e^(-margin /
// soft)), the margin being how far the voxel is on its right side, and over the numbers of their square by
// twice their variance.
class Likelihood {
public:
    Likelihood(std::vector<Witness> witnesses, std::size_t size, const WallFit& fit)
        : witnesses_(std::move(witnesses)), size_(size), fit_(fit) {
        precision_[kFull] = 1 / square(0.3);
        precision_[kLevel] = 1e-6;
        precision_[kSlope] = 1 / square(0.5);
        precision_[kBend] = 1 / square(0.4 / fit.expectedMm);
        for (std::size_t m = 1; m <= fit.harmonics; ++m) {
            const double spread = m == 1 ? 1.0 : 0.06 / double(m * m);
            precision_[cosineAt(m)] = precision_[sineAt(m)] = 1 / square(spread * fit.expectedMm);
        }
    }

    [[nodiscard]] double of(const Numbers& numbers, double soft) const {
        double sum = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            sum += 0.5 * precision_[k] * square(numbers[k] - centre(k));
        }
        for (const Witness& w : witnesses_) {
            sum += objection(w, numbers, soft).value;
        }
        return sum;
    }
    // What Newton's method adds to the numbers.
    [[nodiscard]] Numbers newtonStep(const Numbers& numbers, double soft) const {
        Numbers gradient{};
        Square hessian{};
        for (std::size_t k = 0; k < size_; ++k) {
            gradient[k] = precision_[k] * (numbers[k] - centre(k));
            hessian[k][k] = precision_[k];
        }
        for (const Witness& w : witnesses_) {
            const Objection found = objection(w, numbers, soft);
            if (found.stiffness <= 0) {
                continue;
            }
            Numbers row = w.factors;
            for (std::size_t k = 0; k < size_; ++k) {
                row[k] *= found.byRadius;
            }
            row[kFull] = found.byFull;
            for (std::size_t k = 0; k < size_; ++k) {
                gradient[k] += found.slope * row[k];
                const double scaled = found.stiffness * row[k];
                for (std::size_t l = 0; l <= k; ++l) {
                    hessian[k][l] += scaled * row[l];
                }
            }
        }
        return solved(hessian, gradient);
    }

    // How far voxels lie on the wrong side, in the mean of those within a step of the wall.
    [[nodiscard]] double wrongMm(const Numbers& numbers, double stepMm) const {
        double sum = 0;
        double weights = 1e-9;
        for (const Witness& w : witnesses_) {
            const double margin = w.side * (radiusAt(numbers, w) - w.radius);
            sum += std::abs(margin) < stepMm ? w.weight * std::max(0.0, -margin) : 0;
            weights += std::abs(margin) < stepMm ? w.weight : 0;
        }
        return sum / weights;
    }

private:
    [[nodiscard]] Objection objection(const Witness& w, const Numbers& numbers, double soft) const {
        const double wall = radiusAt(numbers, w);
        return std::isnan(w.share) ? objectionOfSide(w, wall, soft)
                                   : objectionOfShare(w, wall, numbers[kFull], fit_.shareNoise);
    }
    static double square(double x) { return x * x; }
    [[nodiscard]] double centre(std::size_t k) const {
        return k == kFull ? 1 : k == kLevel ? fit_.expectedMm : 0;
    }
    [[nodiscard]] double radiusAt(const Numbers& numbers, const Witness& w) const {
        double radius = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            radius += numbers[k] * w.factors[k];
        }
        return radius;
    }
    // The solution of hessian x = -gradient, by Cholesky's method.
    [[nodiscard]] Numbers solved(Square& a, const Numbers& gradient) const {
        Numbers x{};
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = a[i][j];
                for (std::size_t k = 0; k < j; ++k) {
                    sum -= a[i][k] * a[j][k];
                }
                a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / a[j][j];
            }
            double right = -gradient[i];
            for (std::size_t k = 0; k < i; ++k) {
                right -= a[i][k] * x[k];
            }
            x[i] = right / a[i][i];
        }
        for (std::size_t i = size_; i-- > 0;) {
            for (std::size_t k = i + 1; k < size_; ++k) {
                x[i] -= a[k][i] * x[k];
            }
            x[i] /= a[i][i];
        }
        return x;
    }

    std::vector<Witness> witnesses_;
    std::size_t size_;
    const WallFit& fit_;
    Numbers precision_{};
};

std::vector<Witness> witnessesOf(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit) {
    std::vector<Witness> witnesses;
    std::size_t seen = 0;
    for (const auto& group : groups) {
        seen += group.size();
    }
    // Wide vessels have more voxels than are needed.
    const std::size_t every = seen / kMostWitnesses + 1;
    std::size_t next = 0;
    for (const auto& group : groups) {
        for (const WallVoxel& voxel : group) {
            const double s = voxel.alongMm - fit.alongMm;
            const double sigmas = s / fit.sigmaMm;
            if (std::abs(sigmas) > 2.5 || next++ % every != 0) {
                continue;
            }
            Witness w{{0, 1, s, s * s},
                      voxel.radiusMm,
                      voxel.isInside ? 1.0 : -1.0,
                      std::exp(-0.5 * sigmas * sigmas),
                      voxel.share,
                      std::isnan(voxel.share) ? WallParts() : WallParts(fit.footprint, voxel)};
            double cosine = voxel.cosine;
            double sine = voxel.sine;
            for (std::size_t m = 1; m <= fit.harmonics; ++m) {
                w.factors[cosineAt(m)] = cosine;
                w.factors[sineAt(m)] = sine;
                const double after = cosine * voxel.cosine - sine * voxel.sine;
                sine = sine * voxel.cosine + cosine * voxel.sine;
                cosine = after;
            }
            witnesses.push_back(w);
        }
    }
    return witnesses;
}

double largestOf(const Numbers& numbers) {
    double largest = 0;
    for (const double number : numbers) {
        largest = std::max(largest, std::abs(number));
    }
    return largest;
}

Numbers moved(Numbers numbers, const Numbers& step, double part) {
    for (std::size_t k = 0; k < kMostNumbers; ++k) {
        numbers[k] += part * step[k];
    }
    return numbers;
}

// Newton's method. Steps that are long for how soft the problem is are halved until they lead downhill.
void descend(const Likelihood& likelihood, double soft, int mostSteps, Numbers& numbers) {
    for (int i = 0; i < mostSteps; ++i) {
        const Numbers step = likelihood.newtonStep(numbers, soft);
        const double length = largestOf(step);
        double part = 1;
        if (length > soft) {
            const double value = likelihood.of(numbers, soft);
            while (part > 0.02 && likelihood.of(moved(numbers, step, part), soft) > value) {
                part /= 2;
            }
        }
        numbers = moved(numbers, step, part);
        if (length * part < 0.05 * soft) {
            return;
        }
    }
}

} // namespace

double WallShape::radiusMm(double angle) const {
    double radius = level();
    for (std::size_t m = 1; m <= kHarmonics; ++m) {
        radius += numbers[cosineAt(m)] * std::cos(double(m) * angle) +
                  numbers[sineAt(m)] * std::sin(double(m) * angle);
    }
    return radius;
}

double WallShape::radiusAtMm(const WallVoxel& voxel, double alongMm) const {
    const double s = voxel.alongMm - alongMm;
    return radiusMm(std::atan2(voxel.sine, voxel.cosine)) + s * (numbers[kSlope] + s * numbers[kBend]);
}

WallShape fittedWall(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit) {
    const Likelihood likelihood(witnessesOf(groups, fit), cosineAt(fit.harmonics + 1), fit);
    WallShape wall;
    wall.numbers[kFull] = 1;
    wall.numbers[kLevel] = fit.expectedMm;
    // At first softly, so that voxels that lie far on the wrong side know which way to go; then as sharply as
    // they agree: a clean mask tells more by its few voxels nearest to the wall than by all others, a ragged
    // one only by its mean.
    descend(likelihood, 0.3 * fit.stepMm, 4, wall.numbers);
    const double wrong = likelihood.wrongMm(wall.numbers, fit.stepMm);
    descend(likelihood, std::clamp(4 * wrong, 0.1 * fit.stepMm, 0.4 * fit.stepMm), 8, wall.numbers);
    return wall;
}

WallShape wallByShares(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit, WallShape wall) {
    const Likelihood likelihood(witnessesOf(groups, fit), cosineAt(fit.harmonics + 1), fit);
    descend(likelihood, 0.2 * fit.stepMm, 12, wall.numbers);
    return wall;
}

} // namespace vs::segment
