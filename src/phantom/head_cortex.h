// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

namespace vs::phantom {

// A folded sheet of grey matter around white matter: signed distances in mm, negative inside.
struct FoldedSheet {
    double pial = 0;  // to the outer surface, along the walls of the sulci too
    double white = 0; // to the white matter
};

// Head coordinates of the phantom in mm, origin in the middle of the head, x to the left, y backwards, z up.
// `room`: signed distance to the inside of the skull, which the brain keeps clear of by a layer of fluid.

// Both hemispheres, parted by a fissure down to the corpus callosum. Sulci stand on the nodal lines of
// random plane waves of one wavelength (26 mm, and shallow ones of 14 mm) on the cerebrum's surface and go
// down 9 to 22 mm along its normals, narrowing; the grey ribbon is about 2.9 mm thick.
FoldedSheet cerebrum(glm::dvec3 p, double room);

// Signed distance to the cerebellum without its folds.
double cerebellumHull(glm::dvec3 p, double room);
// The cerebellum with its folia: sheets that fan out from the fourth ventricle.
FoldedSheet cerebellum(glm::dvec3 p, double room);

// Signed distance to the corpus callosum, the white bridge at the bottom of the fissure.
double corpusCallosum(glm::dvec3 p);

} // namespace vs::phantom
