// SPDX-License-Identifier: Apache-2.0
#include "phantom/body_phantom.h"

#include "phantom/ct_scan.h"
#include "phantom/noise.h"
#include "phantom/solid_distances.h"
#include "phantom/tissue_painter.h"

#include <cmath>

namespace vs::phantom {

namespace {

constexpr glm::dvec3 kBodyExtentMm(400);

namespace chest {
constexpr double air = -1000;
constexpr double lung = -850;
constexpr double fat = -100;
constexpr double skin = 20;
constexpr double blood = 45;
constexpr double muscle = 55;
constexpr double marrow = 220;
constexpr double bone = 700;
} // namespace chest

// Signed distance to the trunk without its shoulders, whose inside ribs and lungs follow.
double trunkDistance(glm::dvec3 p) {
    const double waist = std::exp(-std::pow((p.z + 120) / 70, 2));
    const glm::dvec2 radii(158 - 14 * waist, 112 - 12 * waist);
    return smoothMax(ellipseDistance({p.x, p.y - 5}, radii), p.z - 125, 90);
}

double bodyDistance(glm::dvec3 p, double trunk) {
    const glm::dvec3 m(std::abs(p.x), p.y, p.z);
    const double shoulder = coneDistance(m, {60, 12, 112}, 46, {132, 12, 84}, 50);
    const double neck = coneDistance(p, {0, 18, 110}, 60, {0, 0, 190}, 52);
    const double head = ellipsoidDistance(p - glm::dvec3(0, -12, 245), {74, 96, 90});
    return smoothMin(smoothMin(smoothMin(trunk, shoulder, 50), neck, 30), head, 15);
}

// Folds and pores of the skin: what a level crosses is rough at the scale of a voxel.
double roughness(glm::dvec3 p) {
    return 0.9 * std::sin(0.71 * p.x + 0.4 * p.y) * std::sin(0.63 * p.y - 0.3 * p.z) +
           0.6 * std::sin(1.9 * p.z + 0.8 * p.x) * std::sin(1.7 * p.x - p.y);
}

class Body {
public:
    Body(glm::dvec3 p, double voxelMm) : p_(p), painter_(voxelMm, chest::air), trunk_(trunkDistance(p)) {}

    // `grain`: -1 to 1, this voxel's own share of the roughness.
    TissuePainter paint(double grain) {
        double skin = bodyDistance(p_, trunk_);
        constexpr double kMargin = 6;
        if (skin > kMargin) {
            return painter_;
        }
        if (skin > -kMargin) {
            skin += roughness(p_) + 0.3 * grain;
        }
        over(skin, chest::skin, BodyTissue::Soft);
        over(skin + 2.5, chest::fat, BodyTissue::Soft);
        over(skin + 13 + 3 * std::sin(0.03 * p_.x + 0.02 * p_.z), chest::muscle, BodyTissue::Soft);
        paintOrgans();
        paintBones();
        return painter_;
    }

private:
    void over(double distance, double value, BodyTissue tissue) {
        painter_.paint(distance, value, std::uint8_t(tissue));
    }
    void paintOrgans() {
        const glm::dvec3 m(std::abs(p_.x), p_.y, p_.z);
        const double dome =
            -45 - 0.012 * (m.x - 70) * (m.x - 70) - 0.006 * (p_.y + 20) * (p_.y + 20); // the diaphragm
        const double side =
            smoothMax(ellipsoidDistance(m - glm::dvec3(72, 5, 10), {58, 84, 108}), trunk_ + 34, 8);
        const double heart = ellipsoidDistance(p_ - glm::dvec3(28, -28, -8), {48, 44, 52});
        const double lungs = smoothMax(smoothMax(side, dome - p_.z, 8), 4 - heart, 6);
        over(lungs, chest::lung, BodyTissue::Lung);
        const double branches = std::sin(0.11 * p_.x + 2 * std::sin(0.03 * p_.z)) * std::sin(0.12 * p_.y) +
                                std::sin(0.1 * p_.z + std::sin(0.05 * p_.x));
        over(std::max(lungs + 3, 7 * (1.6 - std::abs(branches))), chest::blood, BodyTissue::Soft);
        over(heart, chest::blood, BodyTissue::Soft);
    }
    void paintBones() {
        const double slope = p_.z + 0.45 * p_.y; // ribs fall from the spine to the front
        const double bars = std::abs(std::sin(0.105 * slope)) / 0.105 - 5;
        const double cage = std::abs(trunk_ + 29) - 4.5;
        const double ribs = smoothMax(std::max(cage, std::abs(p_.z - 20) - 105), bars, 4);
        const double sternum = std::max({cage - 1, ellipseDistance({p_.x, p_.z - 35}, {16, 75}), p_.y});
        const double spine = p_.y - 62 + 34 * glm::smoothstep(70.0, 190.0, p_.z); // it leans into the neck
        const double discs = std::abs(std::sin(0.105 * p_.z)) / 0.105 - 2.5;
        const double vertebrae = smoothMax(ellipseDistance({p_.x, spine}, {22, 17}), -discs, 3);
        const double process = smoothMax(ellipseDistance({p_.x, spine - 31}, {4, 9}), 7 - 2 * discs, 3);
        const double arch =
            smoothMax(std::abs(glm::length(glm::dvec2(p_.x, spine - 22)) - 12) - 3, -discs, 2);
        const double bones = std::min({ribs, sternum, vertebrae, process, arch});
        over(bones, chest::bone, BodyTissue::Bone);
        over(bones + 2, chest::marrow, BodyTissue::Bone);
    }

    glm::dvec3 p_;
    TissuePainter painter_;
    double trunk_;
};

} // namespace

Scanner bodyScanner(const BodyPhantomOptions& options) {
    return ctScanner({options.dims, kBodyExtentMm, options.noisePercent, options.seed}, "body phantom",
                     [](glm::dvec3 p, double voxelMm, std::size_t n) {
                         const double grain = double(randomBits(n) >> 12) / double(1ULL << 51) - 1;
                         return Body(p, voxelMm).paint(grain);
                     });
}

LabelledVolume makeBodyPhantom(const BodyPhantomOptions& options) { return scanAll(bodyScanner(options)); }

} // namespace vs::phantom
