// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "render/rays/ray_caster.h"
#include "volume/grid/volume.h"

#include <cstdint>
#include <vector>

namespace vs::studio {

// How a scan is shown to a person who opens it, when nothing says how.
struct FirstLook {
    Range range; // displayed range
    render::Mode mode = render::Mode::Surface;
};

// Where what is not air begins, in a scan whose air is dark and noisy as that of MR is: above the noise, and
// a quarter of the way from air to `object` at least, the threshold between all that is dark and all that is
// bright (volume::otsuThreshold); half of it where air was set to one value; nowhere beyond `object`. Weak
// signal, as a lower face far from the coil gives, lies between the two. `counts` are those of equal bins
// over `range`, at best of one for each value; air's noise is told by the width of its peak. (Magnitudes
// without signal are distributed after Rayleigh (Gudbjartsson and Patz 1995, "The Rician distribution of
// noisy MRI data"). Four half widths above the peak lie two of 100 000 of them.)
double aboveAir(const std::vector<std::uint32_t>& counts, const Range& range, double object);

// By modality, format and values: emission scans and angiographies as maximum intensity projections whose
// brightest thousandth saturates, these and MR from above their air on, all else from `suggested`
// (field::suggestRange): what other scans have in their air, foam and tables, is as solid as weak tissue.
// Needs a current OpenGL context.
FirstLook firstLook(const volume::Volume& volume, const field::Field& field, const Range& suggested);

} // namespace vs::studio
