// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/islands.h"

#include "base/progress.h"

#include <itkConnectedComponentImageFilter.h>
#include <itkImportImageFilter.h>

#include <algorithm>
#include <optional>

namespace vs::segment {
namespace {

using Label = std::uint32_t;

// The islands of a set, each voxel labelled: 0 outside, island i of `islands` labelled i + 1.
struct Labelling {
    using Image = itk::Image<Label, 3>;
    Image::Pointer image;
    std::vector<Island> islands; // in the order of their labels

    [[nodiscard]] const Label* labels() const { return image->GetBufferPointer(); }
};

Labelling label(const VoxelSet& set, Connectivity connectivity) {
    reportProgress();
    using Mask = itk::ImportImageFilter<std::uint8_t, 3>;
    const auto mask = Mask::New();
    Mask::SizeType size;
    for (unsigned i = 0; i < 3; ++i) {
        size[i] = itk::SizeValueType(set.box.size()[int(i)]);
    }
    mask->SetRegion(Mask::RegionType(size));
    // The filter only reads it.
    mask->SetImportPointer(const_cast<std::uint8_t*>(set.inside.data()), set.inside.size(), false);
    const auto filter = itk::ConnectedComponentImageFilter<Mask::OutputImageType, Labelling::Image>::New();
    filter->SetInput(mask->GetOutput());
    filter->SetFullyConnected(connectivity == Connectivity::TwentySix);
    filter->Update();
    reportProgress();

    Labelling result{filter->GetOutput(), std::vector<Island>(filter->GetObjectCount())};
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        if (const Label l = result.labels()[i]; l != 0) {
            Island& island = result.islands[l - 1];
            if (island.voxels++ == 0) {
                island.first = set.voxelAt(i);
            }
        }
    }
    return result;
}

bool isLarger(const Island& a, const Island& b) { return a.voxels > b.voxels; }

// The voxels of those islands that `wanted` (one for each label but 0) names.
VoxelSet pick(const VoxelSet& set, const Labelling& labelling, const std::vector<bool>& wanted) {
    VoxelSet result = emptySet(set.box);
    std::transform(labelling.labels(), labelling.labels() + set.inside.size(), result.inside.begin(),
                   [&](Label l) { return std::uint8_t(l != 0 && wanted[l - 1] ? 1 : 0); });
    return result.tight();
}

// All islands that `wants` accepts.
template <typename Wants>
VoxelSet filterIslands(const VoxelSet& set, Connectivity connectivity, Wants wants) {
    if (set.box.isEmpty()) {
        return {};
    }
    const Labelling labelling = label(set, connectivity);
    std::vector<bool> wanted;
    std::transform(labelling.islands.begin(), labelling.islands.end(), std::back_inserter(wanted), wants);
    return pick(set, labelling, wanted);
}

// The voxel of the set nearest to `place` within kIslandReach.
glm::ivec3 nearestVoxel(const VoxelSet& set, glm::ivec3 place) {
    std::optional<glm::ivec3> nearest;
    int smallest = kIslandReach * kIslandReach;
    const int r = kIslandReach;
    for (int z = -r; z <= r; ++z) {
        for (int y = -r; y <= r; ++y) {
            for (int x = -r; x <= r; ++x) {
                const int squared = x * x + y * y + z * z;
                const glm::ivec3 voxel = place + glm::ivec3(x, y, z);
                if (squared <= smallest && (!nearest || squared < smallest) && set.contains(voxel)) {
                    nearest = voxel;
                    smallest = squared;
                }
            }
        }
    }
    if (!nearest) {
        throw Error("voxel {},{},{} is more than {} voxels away from the segment; take one on it", place.x,
                    place.y, place.z, kIslandReach);
    }
    return *nearest;
}

VoxelSet keepOrDrop(const VoxelSet& set, glm::ivec3 place, Connectivity connectivity, bool keep) {
    const auto voxel = nearestVoxel(set, place);
    const Labelling labelling = label(set, connectivity);
    std::vector<bool> wanted(labelling.islands.size(), !keep);
    wanted[labelling.labels()[set.indexOf(voxel)] - 1] = keep;
    return pick(set, labelling, wanted);
}

double millilitres(const Island& island, const volume::GridGeometry& geometry) {
    return double(island.voxels) * geometry.voxelMm3() / 1000;
}

} // namespace

std::vector<Island> islands(const VoxelSet& set, Connectivity connectivity) {
    if (set.box.isEmpty()) {
        return {};
    }
    auto found = label(set, connectivity).islands;
    std::sort(found.begin(), found.end(), [&](const Island& a, const Island& b) {
        return a.voxels != b.voxels ? isLarger(a, b) : set.indexOf(a.first) < set.indexOf(b.first);
    });
    return found;
}

VoxelSet keepIsland(const VoxelSet& set, glm::ivec3 voxel, Connectivity connectivity) {
    return keepOrDrop(set, voxel, connectivity, true);
}

VoxelSet dropIsland(const VoxelSet& set, glm::ivec3 voxel, Connectivity connectivity) {
    return keepOrDrop(set, voxel, connectivity, false);
}

VoxelSet keepLargestIsland(const VoxelSet& set, Connectivity connectivity) {
    const auto all = islands(set, connectivity);
    return all.empty() ? VoxelSet{} : keepIsland(set, all.front().first, connectivity);
}

VoxelSet dropSmallIslands(const VoxelSet& set, const volume::GridGeometry& geometry, double minimumMl,
                          Connectivity connectivity) {
    return filterIslands(set, connectivity,
                         [&](const Island& island) { return millilitres(island, geometry) >= minimumMl; });
}

VoxelSet fillHoles(const VoxelSet& set, const volume::GridGeometry& geometry, double largestMl,
                   Connectivity connectivity) {
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    // One layer all around, so that the outside is one island: the first.
    VoxelSet outside = set.within(grow(tight, 1));
    for (auto& value : outside.inside) {
        value = value == 0 ? 1 : 0;
    }
    VoxelSet result = filterIslands(outside, connectivity, [&](const Island& island) {
        return island.first == outside.box.lo || millilitres(island, geometry) > largestMl;
    });
    result = result.within(outside.box);
    for (auto& value : result.inside) {
        value = value == 0 ? 1 : 0;
    }
    return result.tight();
}

} // namespace vs::segment
