// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "render/rays/ray_caster.h"
#include "volume/grid/volume.h"

namespace vs::studio {

// How a scan is shown to a person who opens it, when nothing says how.
struct FirstLook {
    Range range; // displayed range
    render::Mode mode = render::Mode::Surface;
};

// By modality, format and values: emission scans and angiographies as maximum intensity projections whose
// brightest thousandth saturates, these and MR from above their air (field::findAir) on, all else from
// `suggested` (field::suggestRange): what other scans have in their air, foam and tables, is as solid as weak
// tissue. Needs a current OpenGL context.
FirstLook firstLook(const volume::Volume& volume, const field::Field& field, const Range& suggested);

} // namespace vs::studio
