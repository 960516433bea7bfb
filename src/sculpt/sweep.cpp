// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sweep.h"

namespace vs::sculpt {

SweptPatches sweepPiece(const MaskRaster& mask, const PathPiece& piece) {
    // Depth 0 is the piece's start, 1 its end. Elements that move backwards, on the inner side of a turn,
    // count nothing.
    SweptPatches out(0, 1, 1);
    for (int j = 0; j < mask.size.y; ++j) {
        for (int i = 0; i < mask.size.x; ++i) {
            const glm::dvec2 element = mask.origin + mask.pitch * glm::dvec2(i, j);
            const glm::dvec3 start = piece.from.place(element);
            out.addCorner(glm::vec3(start), glm::vec3(piece.to.place(element) - start), mask.at(i, j));
        }
    }
    const auto row = std::uint32_t(mask.size.x);
    for (int j = 0; j + 1 < mask.size.y; ++j) {
        for (int i = 0; i + 1 < mask.size.x; ++i) {
            const auto corner = std::uint32_t(j) * row + std::uint32_t(i);
            out.addCell({corner, corner + 1, corner + row, corner + row + 1});
        }
    }
    return out;
}

Box3 sweepMask(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask,
               std::span<const PathPiece> path, glm::ivec3 dims, const Footprint& footprint) {
    Box3 box;
    for (const PathPiece& piece : path) {
        box = unite(box, sweepPiece(mask, piece).pointBox());
    }
    radiator.begin(box, dims, footprint);
    for (const PathPiece& piece : path) {
        generator.generate(sweepPiece(mask, piece), [&](const gl::Buffer& points, std::size_t count) {
            radiator.deposit(points, count);
        });
    }
    return radiator.finish();
}

} // namespace vs::sculpt
