// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/placement.h"

#include <QRectF>

#include <vector>

namespace vs::desktop {

// Finds where a pasted part stands free: as a camera sees it, it overlaps neither what remains nor another
// part, so it cannot lie inside of them either. To the right where there is room in the picture, else on the
// nearest side that has it, else to the right beyond the picture.
class FreeRoom {
public:
    FreeRoom(const render::Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 viewport);

    // Something that can be seen, by points in it (voxel space): what remains, or a part where it is placed.
    void take(const std::vector<glm::dvec3>& voxels);
    void take(const std::vector<glm::dvec3>& voxels, const render::Placement& place);

    // Finds a place for a part, which is only moved across the line of sight; the place is not taken yet. The
    // part must have points.
    [[nodiscard]] render::Placement find(const std::vector<glm::dvec3>& voxels) const;
    // A camera that sees all that was taken: the given one, or if something is not in its picture, one
    // farther off.
    [[nodiscard]] render::Camera cameraOnAll() const;

private:
    // A block that is turned as the viewer is, by its corners in the world.
    using Block = std::vector<glm::dvec3>;
    enum class Side { Right, Left, Down, Up };
    struct Try {
        glm::dvec3 moveMm{0};
        QRectF seen;
    };

    [[nodiscard]] Block blockAround(const std::vector<glm::dvec3>& voxels, const glm::dmat4& worldFromVoxel,
                                    double outliers) const;
    [[nodiscard]] glm::dvec3 direction(Side side) const;
    void tryBeyond(const Block& part, const Try& from, Side side, double edge, std::vector<Try>& tries) const;
    [[nodiscard]] Try beyond(const Block& part, const Try& from, Side side, double edge) const;
    [[nodiscard]] bool isFree(const QRectF& seen) const;
    [[nodiscard]] bool isInPicture(const Block& part, glm::dvec3 moveMm) const;

    render::Camera camera_;
    const volume::GridGeometry* geometry_;
    glm::ivec2 viewport_;
    render::ViewRays rays_; // from well outside, so that all lies before the viewer
    double gap_;            // pixels
    std::vector<Block> blocks_;
    std::vector<QRectF> taken_; // as rays_ see them
};

} // namespace vs::desktop
