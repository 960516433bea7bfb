// SPDX-License-Identifier: Apache-2.0
#include "phantom/phantom.h"

#include <cmath>
#include <type_traits>

namespace vs::phantom {

volume::Volume makePhantom(glm::ivec3 dims, volume::ScalarType type,
                           const std::function<double(glm::dvec3)>& value, glm::dvec3 spacing) {
    volume::Volume volume;
    volume.geometry = volume::makeGeometry(dims, spacing);
    volume.type = type;
    volume.name = "phantom";
    volume.bytes.resize(volume.geometry.voxelCount() * volume::sizeOf(type));
    volume::visit(volume, [&](const auto* typed) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
        T* out = reinterpret_cast<T*>(volume.bytes.data());
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x) {
                    const double v = value({x, y, z});
                    *out++ = std::is_integral_v<T> ? T(std::lround(v)) : T(v);
                }
            }
        }
    });
    volume::computeRange(volume);
    return volume;
}

volume::Volume makeBall(glm::ivec3 dims, glm::dvec3 centreVoxel, double radiusVoxels, double inside,
                        double outside, double edgeVoxels, volume::ScalarType type) {
    return makePhantom(dims, type, [=](glm::dvec3 p) {
        const double depth = (radiusVoxels - glm::length(p - centreVoxel)) / edgeVoxels + 0.5;
        return outside + (inside - outside) * std::clamp(depth, 0.0, 1.0);
    });
}

} // namespace vs::phantom
