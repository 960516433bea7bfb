// SPDX-License-Identifier: Apache-2.0
#include "phantom/curved_plate.h"

#include "phantom/solid_distances.h"

#include <cmath>
#include <utility>

namespace vs::phantom {

double outlineDistance(glm::dvec2 p, std::span<const glm::dvec2> outline) {
    double nearest = 1e18; // squared
    bool isInside = false;
    glm::dvec2 from = outline.back();
    for (const glm::dvec2 to : outline) {
        const glm::dvec2 edge = to - from;
        const glm::dvec2 q = p - from;
        const glm::dvec2 off = q - edge * std::clamp(glm::dot(q, edge) / glm::dot(edge, edge), 0.0, 1.0);
        nearest = std::min(nearest, glm::dot(off, off));
        if ((from.y > p.y) != (to.y > p.y) && q.x < edge.x * q.y / edge.y) {
            isInside = !isInside;
        }
        from = to;
    }
    return isInside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

std::vector<glm::dvec2> rounded(std::vector<glm::dvec2> outline) {
    for (int times = 0; times < 2; ++times) {
        std::vector<glm::dvec2> finer;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 a = outline[i];
            const glm::dvec2 b = outline[(i + 1) % outline.size()];
            finer.push_back(glm::mix(a, b, 0.25));
            finer.push_back(glm::mix(a, b, 0.75));
        }
        outline = std::move(finer);
    }
    return outline;
}

CurvedPlate::CurvedPlate(Form form) : form_(std::move(form)), normal_(0), reachMm_(0) {
    form_.along = glm::normalize(form_.along);
    normal_ = glm::normalize(glm::cross(form_.along, form_.across));
    form_.across = glm::cross(normal_, form_.along);
    for (const glm::dvec2 corner : form_.outline) {
        reachMm_ = std::max(reachMm_, glm::length(corner));
    }
}

double CurvedPlate::distance(glm::dvec3 p) const {
    constexpr double kFarMm = 30; // beyond that no one needs it exactly
    const glm::dvec3 q = p - form_.origin;
    const double beyond = glm::length(q) - reachMm_;
    if (beyond > kFarMm) {
        return beyond;
    }
    const glm::dvec2 sv(glm::dot(q, form_.along), glm::dot(q, form_.across));
    const auto& bend = form_.bend;
    const double above = bend[0] + bend[1] * sv.x * sv.x + bend[2] * sv.x * sv.y + bend[3] * sv.y * sv.y;
    const glm::dvec2 slope(2 * bend[1] * sv.x + bend[2] * sv.y, bend[2] * sv.x + 2 * bend[3] * sv.y);
    const double off = std::abs(glm::dot(q, normal_) - above) / std::sqrt(1 + glm::dot(slope, slope));
    if (off > kFarMm) {
        return off - form_.thicknessMm;
    }
    const double edge = outlineDistance(sv, form_.outline);
    const double rim = form_.rimMm * std::exp(-std::pow(std::min(edge, 0.0) / 9, 2));
    return smoothMax(off - 0.5 * (form_.thicknessMm + rim), edge, form_.thicknessMm);
}

} // namespace vs::phantom
