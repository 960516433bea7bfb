// SPDX-License-Identifier: Apache-2.0
#include "volume/phantom.h"

#include <cmath>
#include <type_traits>

namespace vs::volume {

Volume makePhantom(glm::ivec3 dims, ScalarType type, const std::function<double(glm::dvec3)>& value,
                   glm::dvec3 spacing) {
    Volume volume;
    volume.geometry = makeGeometry(dims, spacing);
    volume.type = type;
    volume.name = "phantom";
    volume.bytes.resize(volume.geometry.voxelCount() * sizeOf(type));
    visit(volume, [&](const auto* typed) {
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
    computeRange(volume);
    return volume;
}

Volume makeBall(glm::ivec3 dims, glm::dvec3 centreVoxel, double radiusVoxels, double inside, double outside,
                double edgeVoxels, ScalarType type) {
    return makePhantom(dims, type, [=](glm::dvec3 p) {
        const double depth = (radiusVoxels - glm::length(p - centreVoxel)) / edgeVoxels + 0.5;
        return outside + (inside - outside) * std::clamp(depth, 0.0, 1.0);
    });
}

} // namespace vs::volume
