// SPDX-License-Identifier: Apache-2.0
#include "render/marks/annotation.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vs::render {

namespace {

constexpr double kBarMargin = 26; // pixels at a scale of 1

} // namespace

double annotationScale(glm::ivec2 size, double density) {
    const double side = std::min(size.x, size.y) / density;
    constexpr double kLegible = 0.62; // text of nine pixels
    constexpr double kRoom = 260;     // smaller pictures have none for that
    return density * std::max(side / 870, kLegible * std::min(1.0, side / kRoom));
}

std::string lengthLabel(double mm) {
    struct Unit {
        double mm;
        const char* name;
    };
    constexpr std::array<Unit, 5> kUnits{{{1e3, "m"}, {10, "cm"}, {1, "mm"}, {1e-3, "µm"}, {1e-6, "nm"}}};
    // A hair less, or a product like 1e-3 * 1000 may fall short of its unit.
    const auto* unit = std::find_if(kUnits.begin(), kUnits.end() - 1,
                                    [mm](const Unit& u) { return mm >= u.mm * (1 - 1e-9); });
    return fmt::format("{:.6g} {}", mm / unit->mm, unit->name);
}

ScaleBar scaleBar(const ViewRays& rays, const volume::GridGeometry& geometry, double density) {
    const double pixelMm = rays.pixelMm(geometry.centreWorld());
    const double most = 0.25 * rays.size.x * pixelMm;
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    const double times = most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1;

    ScaleBar bar;
    bar.lengthMm = times * decade;
    bar.label = lengthLabel(bar.lengthMm);
    // Both ends on pixel borders, so that they are sharp: at most half a pixel off.
    const double margin = std::round(kBarMargin * annotationScale(rays.size, density));
    bar.left = {margin, rays.size.y - margin};
    bar.right = bar.left + glm::dvec2(std::round(bar.lengthMm / pixelMm), 0);
    return bar;
}

} // namespace vs::render
