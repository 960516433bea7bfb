// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <optional>

namespace vs::mesh {

inline constexpr int kMostSmoothing = 200;

// What is done to a surface after contouring.
struct Refinement {
    // Passes of windowed sinc smoothing (Taubin, Zhang and Golub 1996, "Optimal surface smoothing as filter
    // design"), which takes steps away and keeps the volume; 0: none.
    int smoothing = 0;
    // How many triangles are to be left of how many, by quadric error metrics (Garland and Heckbert 1997;
    // VTK's, with the volume kept); 1: all.
    double share = 1;
    // The number of triangles that are left at most, about.
    std::optional<std::size_t> mostTriangles = {};
};

// The refined mesh, still closed where it was. Throws GivenUp.
Mesh refined(Mesh mesh, const Refinement& refinement, const Progress& progress = {});

} // namespace vs::mesh
