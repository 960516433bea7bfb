// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/solids/solid_cut.h"
#include "sculpt/surface/patch_surface.h"
#include "studio/operations/filling.h"
#include "studio/strokes/cut_stroke.h"
#include "volume/grid/volume.h"

#include <cstdint>
#include <vector>

namespace vs::studio {

// Fills a hole that an outline encloses on the picture up to the surface that closes it
// (sculpt/surface/patch_surface.h): what is empty below that surface and hangs together with what is seen of
// the hole.
class PatchStroke : public CutStroke {
public:
    // `operation` has its canvas set; the volume must outlive the stroke.
    PatchStroke(Cutter& cutter, const MakeFrame& makeFrame, const volume::Volume& volume,
                const FillHole& operation);
    // Throws Error when no surface is seen around the hole.
    void replay() override;

private:
    // What is seen within the outline and around it, world.
    struct Seen {
        std::vector<glm::dvec3> around;
        std::vector<glm::dvec3> inside;
        std::vector<glm::dvec2> through; // pixels within the outline in which nothing is met
    };
    // Voxels in and about the hole: how deep they lie below the surface that closes it (mm), and which of
    // them belong to the hole.
    struct Hole {
        Box3 box;
        std::vector<float> depths;
        std::vector<std::uint8_t> isIn;

        [[nodiscard]] std::size_t indexOf(glm::ivec3 voxel) const {
            const glm::ivec3 v = voxel - box.lo;
            const glm::ivec3 n = box.size();
            return (std::size_t(v.z) * std::size_t(n.y) + std::size_t(v.y)) * std::size_t(n.x) +
                   std::size_t(v.x);
        }
    };

    // How wide a step is in the picture where the surface under the outline is.
    [[nodiscard]] double stepPixels(const sculpt::Outline& outline) const;
    [[nodiscard]] Seen look(const sculpt::OutlineDistances& outline, double ringPixels) const;
    // Places of the hole that are seen, just above its floor.
    [[nodiscard]] std::vector<glm::dvec3> seedsOf(const Seen& seen, const sculpt::PatchSurface& surface,
                                                  double depthMm) const;
    [[nodiscard]] Hole find(const std::vector<glm::dvec3>& seeds, const sculpt::PatchSurface& surface,
                            const sculpt::OutlineDistances& outline, double depthMm) const;
    // Which voxels of a box nothing is seen in that the scan has, and that are not filled either.
    [[nodiscard]] std::vector<std::uint8_t> emptyIn(const Box3& box) const;
    [[nodiscard]] std::vector<float> energiesOf(const Hole& hole, double depthMm, int radius) const;

    render::Frame frame_;
    const volume::Volume* volume_;
};

} // namespace vs::studio
