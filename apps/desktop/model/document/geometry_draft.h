// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/slices/slice_view.h"
#include "studio/operations/correcting.h"

namespace vs::desktop {

// A correction of where a scan lies while a person makes it: its three slices are turned until they look as
// they should, and spacings are typed.
class GeometryDraft {
public:
    // Begins with where the scan lies at `present`.
    GeometryDraft(const volume::GridGeometry& file, const volume::GridGeometry& present);

    // What can be done to a slice as it is seen. Each changes what the voxel axes of that slice mean, and
    // with them the other two slices.
    enum class Turn {
        FlipAcross, // exchanges left and right of the picture
        FlipDown,   // exchanges its top and bottom
        Clockwise,  // turns it by a quarter
        Exchange    // what ran across runs down: exchanges two axes
    };
    void turn(render::SliceKind slice, Turn turn);
    void setSpacing(glm::dvec3 mm);
    // Back to what the file says.
    void reset();

    [[nodiscard]] glm::dvec3 spacing() const { return spacing_; }
    [[nodiscard]] const std::string& orientation() const { return orientation_; }
    // What is other than in the file.
    [[nodiscard]] studio::CorrectGeometry correction() const;
    [[nodiscard]] volume::GridGeometry grid() const;

private:
    volume::GridGeometry file_;
    std::string orientation_;
    glm::dvec3 spacing_;
};

} // namespace vs::desktop
