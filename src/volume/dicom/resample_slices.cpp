// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace vs::volume {
namespace {

// How the slices lie: offsets along the normal and shifts within the plane (mm), both against the first
// slice.
struct Layout {
    std::vector<double> offsets;
    std::vector<glm::dvec2> shifts;
    double meanStep = 0;
    double smallestStep = 0;
    double largestStep = 0;
    double medianStep = 0;
    bool even = true;     // equal steps
    bool straight = true; // the first pixels lie on one line
    double slant = 0;     // tangent of the angle between the line of positions and the normal
};

Layout describe(const SliceStack& stack) {
    constexpr double evenTolerance =
        0.02; // of a step: header values are rounded, and this stays far below half
    constexpr double straightTolerance = 0.1; // of a pixel
    const glm::dvec3 normal = glm::cross(stack.alongColumns, stack.alongRows);
    Layout layout;
    for (const auto& position : stack.positions) {
        const glm::dvec3 moved = position - stack.positions.front();
        layout.offsets.push_back(glm::dot(moved, normal));
        layout.shifts.emplace_back(glm::dot(moved, stack.alongColumns), glm::dot(moved, stack.alongRows));
    }
    const double gaps = double(stack.positions.size() - 1);
    layout.meanStep = layout.offsets.back() / gaps;
    const glm::dvec2 shiftPerMm = layout.shifts.back() / layout.offsets.back();
    std::vector<double> steps;
    for (std::size_t i = 1; i < layout.offsets.size(); ++i) {
        steps.push_back(layout.offsets[i] - layout.offsets[i - 1]);
        const double k = double(i);
        layout.even = layout.even &&
                      std::abs(layout.offsets[i] - k * layout.meanStep) <= evenTolerance * layout.meanStep;
        const glm::dvec2 bend =
            glm::abs(layout.shifts[i] - layout.offsets[i] * shiftPerMm) / stack.pixelSpacing;
        layout.straight = layout.straight && std::max(bend.x, bend.y) <= straightTolerance;
    }
    layout.slant = glm::length(shiftPerMm);
    std::sort(steps.begin(), steps.end());
    layout.smallestStep = steps.front();
    layout.largestStep = steps.back();
    layout.medianStep = steps[steps.size() / 2];
    return layout;
}

// How many times the voxels of its slices a regular grid may have.
constexpr double kMostTimes = 8;

// Slices of the regular grid. A step that meets all positions if there is one near the smallest (missing
// slices, mixed multiples), else the smallest itself, so that no detail falls between two slices. First and
// last slice are always met.
int countSlices(const Layout& layout) {
    const double total = layout.offsets.back();
    if (layout.even) {
        return int(layout.offsets.size());
    }
    // Steps far below the usual one would blow up the volume for one misplaced slice.
    const double base = std::max(layout.smallestStep, layout.medianStep / 8);
    for (int divisor = 1; divisor <= 4; ++divisor) {
        const double step = total / std::round(total / (base / divisor));
        const bool meetsAll = std::all_of(layout.offsets.begin(), layout.offsets.end(), [&](double offset) {
            return std::abs(offset / step - std::round(offset / step)) < 0.05;
        });
        // A step that is much finer than most slices lie apart meets them all, and makes up nearly all
        // others.
        const double slices = std::round(total / step) + 1;
        if (meetsAll && slices <= kMostTimes * double(layout.offsets.size())) {
            return int(slices);
        }
    }
    return int(std::min(std::ceil(total / base - 1e-6), 1e9)) + 1;
}

// One slice whose position is far off must not make a volume that is nearly all made up.
void requireProportion(const std::filesystem::path& path, const glm::dvec3& from, const glm::dvec3& to) {
    const double times = to.x * to.y * to.z / (from.x * from.y * from.z);
    if (times > kMostTimes) {
        refuse(path,
               fmt::format("its slices lie so far apart that a regular grid would hold {:.0f} times as many "
                           "voxels ({} x {} x {})",
                           times, to.x, to.y, to.z),
               "look for a slice whose ImagePositionPatient is wrong");
    }
}

// One source slice on the grid's plane: values, and which part of the plane it covers.
struct Plane {
    std::vector<double> values;
    glm::ivec2 lo{0};
    glm::ivec2 hi{0}; // exclusive
    [[nodiscard]] bool covers(int x, int y) const { return x >= lo.x && x < hi.x && y >= lo.y && y < hi.y; }
};

// Bilinear samples at x + shift.x, y + shift.y pixels of the source slice.
template <typename T>
void samplePlane(const T* source, glm::ivec2 size, glm::dvec2 shift, glm::ivec2 planeSize, Plane& plane) {
    // Half a pixel around the outermost centres still belongs to the slice.
    plane.lo = glm::max(glm::ivec2(glm::ceil(-0.5 - shift)), glm::ivec2(0));
    plane.hi = glm::min(glm::ivec2(glm::floor(glm::dvec2(size) - 0.5 - shift)) + 1, planeSize);
    plane.values.resize(std::size_t(planeSize.x) * std::size_t(planeSize.y));
    const auto split = [](double at, int count, int& index, double& fraction) {
        at = std::clamp(at, 0.0, double(count - 1));
        index = std::min(int(at), std::max(count - 2, 0));
        fraction = at - index;
        fraction = fraction < 1e-6 ? 0 : fraction > 1 - 1e-6 ? 1 : fraction;
    };
    // A weight of zero must not touch the value: it may be NaN.
    const auto mix = [](double a, double b, double t) { return t == 0 ? a : t == 1 ? b : a + t * (b - a); };
    for (int y = plane.lo.y; y < plane.hi.y; ++y) {
        int y0 = 0;
        double fy = 0;
        split(y + shift.y, size.y, y0, fy);
        const T* row0 = source + std::ptrdiff_t(y0) * size.x;
        const T* row1 = size.y > 1 ? row0 + size.x : row0;
        for (int x = plane.lo.x; x < plane.hi.x; ++x) {
            int x0 = 0;
            double fx = 0;
            split(x + shift.x, size.x, x0, fx);
            const int x1 = size.x > 1 ? x0 + 1 : x0;
            plane.values[std::size_t(y) * std::size_t(planeSize.x) + std::size_t(x)] = mix(
                mix(double(row0[x0]), double(row0[x1]), fx), mix(double(row1[x0]), double(row1[x1]), fx), fy);
        }
    }
}

template <typename T>
T roundTo(double value) {
    if constexpr (std::is_integral_v<T>) {
        return T(std::llround(value));
    } else {
        return T(value);
    }
}

// Blends the planes below and above one slice of the grid.
template <typename T>
void writeSlice(const Plane& below, const Plane& above, double t, glm::ivec2 size, T padding, T* out) {
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x, ++out) {
            const std::size_t i = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
            const bool hasBelow = below.covers(x, y);
            const bool hasAbove = above.covers(x, y);
            if (hasBelow && (t == 0 || (!hasAbove && t < 0.5))) {
                *out = roundTo<T>(below.values[i]);
            } else if (hasAbove && (t == 1 || (!hasBelow && t >= 0.5))) {
                *out = roundTo<T>(above.values[i]);
            } else if (hasBelow && hasAbove) {
                *out = roundTo<T>(below.values[i] + t * (above.values[i] - below.values[i]));
            } else {
                *out = padding;
            }
        }
    }
}

// `low` is the grid's first column and row, in mm against the first slice's.
template <typename T>
void resample(const T* source, const SliceStack& stack, const Layout& layout, glm::dvec2 low,
              Volume& target) {
    const glm::ivec2 from(stack.volume.geometry.dims);
    const glm::ivec3 to = target.geometry.dims;
    const std::size_t fromPixels = std::size_t(from.x) * std::size_t(from.y);
    T* out = reinterpret_cast<T*>(target.bytes.data());
    Plane below;
    Plane above;
    const auto load = [&](std::size_t slice, Plane& plane) {
        samplePlane(source + slice * fromPixels, from, (low - layout.shifts[slice]) / stack.pixelSpacing,
                    glm::ivec2(to), plane);
    };
    const T padding = roundTo<T>(stack.volume.usual.lo);
    std::size_t lower = 0;
    load(0, below);
    load(1, above);
    for (int z = 0; z < to.z; ++z) {
        const double offset = layout.offsets.back() * z / (to.z - 1);
        while (lower + 2 < layout.offsets.size() && offset > layout.offsets[lower + 1]) {
            ++lower;
            std::swap(below, above);
            load(lower + 1, above);
        }
        double t = (offset - layout.offsets[lower]) / (layout.offsets[lower + 1] - layout.offsets[lower]);
        // Where the grid meets a slice but for rounding, that slice is taken as it is.
        t = t < 1e-3 ? 0 : t > 1 - 1e-3 ? 1 : t;
        if (t > 0 && t < 1) {
            target.details.interpolated.push_back(z);
        }
        writeSlice(below, above, t, glm::ivec2(to), padding, out);
        out += std::size_t(to.x) * std::size_t(to.y);
    }
}

std::string explain(const std::filesystem::path& path, const Layout& layout, bool slanted,
                    const GridGeometry& grid) {
    std::vector<std::string> causes;
    if (slanted) {
        causes.push_back(layout.straight
                             ? fmt::format("the slices are tilted by {:.1f} degrees against their stack",
                                           glm::degrees(std::atan(layout.slant)))
                             : std::string("the slices are shifted within their planes"));
    }
    if (!layout.even) {
        int missing = 0;
        bool multiples = true;
        for (std::size_t i = 1; i < layout.offsets.size(); ++i) {
            const double ratio = (layout.offsets[i] - layout.offsets[i - 1]) / layout.smallestStep;
            multiples = multiples && std::abs(ratio - std::round(ratio)) < 0.05;
            missing += int(std::lround(ratio)) - 1;
        }
        const bool gaps = multiples && layout.medianStep < 1.5 * layout.smallestStep;
        causes.push_back(gaps
                             ? fmt::format("{} {} missing", missing, missing == 1 ? "slice is" : "slices are")
                             : fmt::format("the distances between slices are uneven ({:.3g} to {:.3g} mm)",
                                           layout.smallestStep, layout.largestStep));
    }
    return fmt::format(
        "{}: {}; {} slices were resampled linearly to a regular grid of {} x {} x {}, {:.4g} mm apart",
        path.string(), fmt::join(causes, " and "), layout.offsets.size(), grid.dims.x, grid.dims.y,
        grid.dims.z, grid.spacing().z);
}

} // namespace

void makeRegular(const std::filesystem::path& path, SliceStack& stack, std::vector<std::string>& notices) {
    constexpr double slantTolerance =
        2e-3; // a tenth of a degree: kept exactly, as a slightly oblique third axis
    const glm::dvec3 normal = glm::cross(stack.alongColumns, stack.alongRows);
    GridGeometry& grid = stack.volume.geometry;
    grid.worldFromVoxel[0] = glm::dvec4(stack.alongColumns * stack.pixelSpacing.x, 0);
    grid.worldFromVoxel[1] = glm::dvec4(stack.alongRows * stack.pixelSpacing.y, 0);
    grid.worldFromVoxel[2] = glm::dvec4(normal * stack.sliceSpacing, 0);
    grid.worldFromVoxel[3] = glm::dvec4(stack.positions.front(), 1);
    if (stack.positions.size() == 1) {
        return;
    }
    const Layout layout = describe(stack);
    const bool slanted = !layout.straight || layout.slant > slantTolerance;
    if (layout.even && !slanted) {
        const double gaps = double(stack.positions.size() - 1);
        grid.worldFromVoxel[2] = glm::dvec4((stack.positions.back() - stack.positions.front()) / gaps, 0);
        return;
    }
    glm::dvec2 low(0);
    glm::dvec2 high(0);
    for (const auto& shift : layout.shifts) {
        low = glm::min(low, shift);
        high = glm::max(high, shift);
    }
    Volume target;
    target.type = stack.volume.type;
    target.geometry = grid;
    constexpr double mostExtra = 1e6; // beyond what integers hold lies a position that is none
    const glm::ivec2 extra(glm::min(glm::ceil((high - low) / stack.pixelSpacing - 0.05), mostExtra));
    target.geometry.dims = {grid.dims.x + extra.x, grid.dims.y + extra.y, countSlices(layout)};
    target.geometry.worldFromVoxel[2] =
        glm::dvec4(normal * (layout.offsets.back() / (target.geometry.dims.z - 1)), 0);
    target.geometry.worldFromVoxel[3] += glm::dvec4(stack.alongColumns * low.x + stack.alongRows * low.y, 0);
    const auto dims = target.geometry.dims;
    requireProportion(path, glm::dvec3(grid.dims), glm::dvec3(dims));
    target.bytes.resize(checkedBytes(path, {dims.x, dims.y, dims.z}, sizeOf(target.type)));
    computeRange(stack.volume);
    visit(stack.volume, [&](const auto* values) { resample(values, stack, layout, low, target); });
    notices.push_back(explain(path, layout, slanted, target.geometry));
    stack.volume = std::move(target);
}

} // namespace vs::volume
