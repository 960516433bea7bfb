// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/agreement.h"

#include "base/check.h"

#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace vs::segment {
namespace {

using Mask = std::span<const std::uint8_t>;
using BorderImage = itk::Image<std::uint8_t, 3>;
using DistanceImage = itk::Image<float, 3>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Overlap {
    std::size_t found = 0;
    std::size_t truth = 0;
    std::size_t both = 0;
    Box3 box; // of either
};

std::size_t placeOf(glm::ivec3 voxel, glm::ivec3 dims) {
    return (std::size_t(voxel.z) * std::size_t(dims.y) + std::size_t(voxel.y)) * std::size_t(dims.x) +
           std::size_t(voxel.x);
}

Overlap overlapOf(glm::ivec3 dims, Mask found, Mask truth) {
    Overlap overlap;
    glm::ivec3 lo(std::numeric_limits<int>::max());
    glm::ivec3 hi(0);
    forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 voxel, std::size_t i) {
        const bool isFound = found[i] != 0;
        const bool isTrue = truth[i] != 0;
        if (isFound || isTrue) {
            overlap.found += isFound ? 1 : 0;
            overlap.truth += isTrue ? 1 : 0;
            overlap.both += isFound && isTrue ? 1 : 0;
            lo = glm::min(lo, voxel);
            hi = glm::max(hi, voxel + 1);
        }
    });
    overlap.box = {lo, hi};
    return overlap;
}

// Voxels of the set with a face towards outside it or the grid.
std::vector<glm::ivec3> borderOf(glm::ivec3 dims, Mask mask, const Box3& box) {
    const auto isInside = [&](glm::ivec3 voxel) {
        return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) &&
               glm::all(glm::lessThan(voxel, dims)) && mask[placeOf(voxel, dims)] != 0;
    };
    std::vector<glm::ivec3> border;
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t) {
        if (mask[placeOf(voxel, dims)] == 0) {
            return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            if (!isInside(voxel + step) || !isInside(voxel - step)) {
                border.push_back(voxel);
                return;
            }
        }
    });
    return border;
}

// Exact distances in mm, everywhere in the box, to the nearest of the voxels.
DistanceImage::Pointer distancesTo(const std::vector<glm::ivec3>& voxels, const Box3& box,
                                   glm::dvec3 spacing) {
    const auto image = BorderImage::New();
    BorderImage::RegionType region;
    BorderImage::SpacingType mm;
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetIndex(axis, box.lo[int(axis)]);
        region.SetSize(axis, itk::SizeValueType(box.size()[int(axis)]));
        mm[axis] = spacing[int(axis)];
    }
    image->SetRegions(region);
    image->SetSpacing(mm);
    image->Allocate(true);
    for (const glm::ivec3 voxel : voxels) {
        image->SetPixel({voxel.x, voxel.y, voxel.z}, 1);
    }
    const auto filter = itk::SignedMaurerDistanceMapImageFilter<BorderImage, DistanceImage>::New();
    filter->SetInput(image);
    filter->SetUseImageSpacing(true);
    filter->SetSquaredDistance(false);
    filter->Update();
    return filter->GetOutput();
}

std::vector<double> distances(const std::vector<glm::ivec3>& from, const std::vector<glm::ivec3>& to,
                              const Box3& box, glm::dvec3 spacing) {
    const auto map = distancesTo(to, box, spacing);
    std::vector<double> result;
    result.reserve(from.size());
    for (const glm::ivec3 voxel : from) {
        result.push_back(std::abs(double(map->GetPixel({voxel.x, voxel.y, voxel.z}))));
    }
    return result;
}

// The smallest of the values that 95 % of them do not exceed.
double percentile95(std::vector<double> values) {
    const auto place = values.begin() + (std::ptrdiff_t(values.size()) * 95 + 99) / 100 - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void addDistances(Agreement& agreement, const volume::GridGeometry& geometry, Mask found, Mask truth,
                  const Box3& box) {
    const auto foundBorder = borderOf(geometry.dims, found, box);
    const auto trueBorder = borderOf(geometry.dims, truth, box);
    // One voxel more on each side, so that every border voxel has background beside it in ITK's image too.
    const auto there = distances(foundBorder, trueBorder, grow(box, 1), geometry.spacing());
    const auto back = distances(trueBorder, foundBorder, grow(box, 1), geometry.spacing());
    agreement.hausdorff95Mm = std::max(percentile95(there), percentile95(back));
    agreement.meanSurfaceMm =
        (std::accumulate(there.begin(), there.end(), 0.0) + std::accumulate(back.begin(), back.end(), 0.0)) /
        double(there.size() + back.size());
}

double diceOf(const Overlap& overlap) {
    const double all = double(overlap.found) + double(overlap.truth);
    return all > 0 ? 2 * double(overlap.both) / all : 1;
}

} // namespace

double dice(glm::ivec3 dims, Mask found, Mask truth) { return diceOf(overlapOf(dims, found, truth)); }

Agreement compare(const volume::GridGeometry& geometry, Mask found, Mask truth) {
    VS_CHECK_EQ(found.size(), geometry.voxelCount());
    VS_CHECK_EQ(truth.size(), geometry.voxelCount());
    const Overlap overlap = overlapOf(geometry.dims, found, truth);
    const auto a = double(overlap.found);
    const auto b = double(overlap.truth);
    const auto both = double(overlap.both);
    Agreement agreement;
    agreement.volumeDifferenceMl = (a - b) * geometry.voxelMm3() / 1000.0;
    agreement.dice = diceOf(overlap);
    if (a == 0 && b == 0) {
        agreement.jaccard = 1;
        return agreement;
    }
    agreement.jaccard = both / (a + b - both);
    agreement.volumeDifferencePercent = b > 0 ? 100 * (a - b) / b : kInfinite;
    if (a > 0 && b > 0) {
        addDistances(agreement, geometry, found, truth, overlap.box);
    } else {
        agreement.hausdorff95Mm = kInfinite;
        agreement.meanSurfaceMm = kInfinite;
    }
    return agreement;
}

} // namespace vs::segment
