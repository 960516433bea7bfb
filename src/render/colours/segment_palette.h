// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace vs::render {

// The colour (sRGB, 0 to 1) that the segment of a label, 1 to 255, has where nobody chose one; always the
// same. The first seven are those of Okabe and Ito's palette (Okabe and Ito 2008) that stand out from ivory.
// Each of the others is as far as can be, in OKLab, from all before it and above all from the last few:
// labels that follow one another often lie beside one another.
glm::dvec3 segmentColour(int label);

} // namespace vs::render
