// SPDX-License-Identifier: Apache-2.0
#include "phantom/skull_phantom.h"

#include "phantom/ct_scan.h"
#include "phantom/skull_bones.h"
#include "phantom/skull_teeth.h"
#include "phantom/solid_distances.h"

namespace vs::phantom {

namespace {

constexpr glm::dvec3 kSkullExtentMm(170, 220, 224);
constexpr glm::dvec3 kSkullMiddleInHead(0, -2, -28); // the grid's, in head coordinates

namespace cranial {
constexpr double air = -1000;
constexpr double fat = -90;
constexpr double fluid = 12;
constexpr double skin = 20;
constexpr double white = 30;
constexpr double grey = 38;
constexpr double muscle = 58;
constexpr double pulp = 100;
constexpr double cartilage = 110;
constexpr double ligament = 150;
constexpr double marrow = 480;
constexpr double jawMarrow = 650;
constexpr double jaw = 900;
constexpr double bone = 950;
constexpr double dentine = 1600;
constexpr double enamel = 2500;
} // namespace cranial

constexpr double kLigamentMm = 1.5; // between a root and its socket

constexpr glm::dvec3 kEye(31, -73, -33);

double headSkin(glm::dvec3 p, const HeadShape& shape) {
    const glm::dvec3 m = mirrored(p);
    const double face = ellipsoidDistance(p - glm::dvec3(0, -31, -58), {67, 64, 78});
    const double chin = coneDistance(m, {9, -77, -112}, 17, {0, -78, -112}, 17);
    const double jaws = coneDistance(m, {42, -14, -100}, 16, {20, -66, -112}, 16);
    const double lips = ellipsoidDistance(m - glm::dvec3(0, -88, kBiteZ), {24, 8.5, 11});
    const double mouth = coneDistance(m, {0, -98.5, kBiteZ}, 1.2, {22, -90, kBiteZ}, 0.6);
    const double nose = smoothMin(coneDistance(p, {0, -88, -26}, 6, {0, -101, -58}, 7.5),
                                  ellipsoidDistance(m - glm::dvec3(8, -94, -62), {7, 9, 6}), 5);
    const double solid = smoothMin(smoothMin(shape.skin, face, 12), smoothMin(chin, jaws, 14), 14);
    const double lids = glm::length(m - kEye) - 13.2;
    const double whole = smoothMin(smoothMin(smoothMin(solid, lips, 8), nose, 5), lids, 4);
    return smoothMax(whole, -mouth, 2);
}

class Skull {
public:
    Skull(glm::dvec3 p, double voxelMm)
        : p_(p), m_(mirrored(p)), shape_(headShape(p)), painter_(voxelMm, cranial::air),
          skin_(headSkin(p, shape_)) {}

    TissuePainter paint() {
        constexpr double kMargin = 3;
        if (skin_ > kMargin) {
            return painter_;
        }
        if (shape_.inner > -kMargin) {
            paintSoft();
            paintBones();
            paintTeeth();
            over(airWays(p_), cranial::air, SkullTissue::Air);
        }
        if (shape_.inner < kMargin || (m_.x < 20 && p_.z < -30)) {
            paintBrain();
        }
        return painter_;
    }

private:
    void over(double distance, double value, SkullTissue tissue) {
        painter_.paint(distance, value, std::uint8_t(tissue));
    }
    void paintSoft();
    void paintBones();
    void paintTeeth();
    void paintBrain();

    glm::dvec3 p_;
    glm::dvec3 m_; // p_ with both sides alike
    HeadShape shape_;
    TissuePainter painter_;
    double skin_;
};

void Skull::paintSoft() {
    over(skin_, cranial::skin, SkullTissue::Soft);
    over(skin_ + 1.8, cranial::fat, SkullTissue::Soft);
    const double below = glm::smoothstep(-20.0, -60.0, p_.z);
    const double fatMm = 2.4 + 0.8 * std::sin(0.09 * p_.y + 0.07 * p_.z) + 2 * below;
    over(skin_ + 1.8 + fatMm, cranial::muscle, SkullTissue::Soft);
    if (shape_.outer > 5) { // muscles, parted by sheets of fat
        const double bundles = std::sin(0.17 * p_.x + 1.5 * std::sin(0.05 * p_.z)) +
                               std::sin(0.15 * p_.y + 1.2 * std::sin(0.06 * p_.x)) +
                               0.6 * std::sin(0.12 * p_.z);
        over(std::max({std::abs(bundles) / 0.24 - 1, skin_ + 7, 8 - shape_.outer}), 0.7 * cranial::fat,
             SkullTissue::Soft);
    }
    const double socket = std::max(orbits(p_), skin_ + 3);
    over(socket, cranial::fat, SkullTissue::Soft);
    const double nerve = coneDistance(m_, {30, -63, -33}, 2.2, {13, -34, -31}, 2.2);
    over(std::min(nerve, glm::length(m_ - kEye) - 11.5), cranial::fluid, SkullTissue::Soft);
    over(ellipsoidDistance(m_ - kEye - glm::dvec3(0, -8, 0), {4.5, 2.2, 4.5}), cranial::pulp,
         SkullTissue::Soft);
}

void Skull::paintBones() {
    const double skull = std::max(cranium(p_, shape_), skin_ + 2.5);
    over(skull, cranial::bone, SkullTissue::Skull);
    // Marrow between the tables of the vault, and in what is thick.
    over(std::max(std::max(vault(p_, shape_), skull) + 2, 2 - shape_.inner), cranial::marrow,
         SkullTissue::Skull);
    over(std::max(sinuses(p_), skull + 1.6), cranial::air, SkullTissue::Air);
    if (p_.z < -40) {
        const double lowerJaw = std::max(mandible(p_), skin_ + 2.5);
        over(lowerJaw, cranial::jaw, SkullTissue::Mandible);
        over(lowerJaw + 3, cranial::jawMarrow, SkullTissue::Mandible);
        const double neck = neckVertebrae(p_);
        const double discs = smoothMax(ellipseDistance({p_.x, p_.y - 14}, {11, 8}), p_.z + 90, 3);
        over(discs, cranial::cartilage, SkullTissue::Soft);
        over(neck, cranial::bone, SkullTissue::Vertebrae);
        over(neck + 1.8, cranial::marrow, SkullTissue::Vertebrae);
    }
}

void Skull::paintTeeth() {
    const Tooth tooth = toothNear(p_);
    if (tooth.number == 0) {
        return;
    }
    constexpr int kTargetNumber = 6; // the first molar
    const bool isTarget = tooth.number == kTargetNumber && p_.x > 0 && p_.z < kBiteZ;
    const SkullTissue label = isTarget ? SkullTissue::FirstMolar : SkullTissue::Tooth;
    over(std::min(tooth.root, tooth.crown) - kLigamentMm, cranial::ligament, SkullTissue::Soft);
    over(tooth.crown, cranial::enamel, label);
    over(tooth.dentine, cranial::dentine, label);
    over(tooth.pulp, cranial::pulp, label);
}

void Skull::paintBrain() {
    const double canal = coneDistance(p_, {0, 26, -40}, 12, {0, 30, -160}, 8);
    const double room = smoothMin(shape_.inner, canal, 6);
    over(room, cranial::fluid, SkullTissue::Soft);
    const double fissure = smoothMax(1.3 - m_.x, -10 - p_.z, 4);
    const bool isDeep = shape_.inner < -14; // where no folds reach
    const double folds = isDeep ? 0
                                : 1.1 * std::sin(0.31 * p_.x + std::sin(0.2 * p_.y)) *
                                          std::sin(0.29 * p_.y + std::sin(0.22 * p_.z)) +
                                      0.8 * std::sin(0.33 * p_.z + 0.5);
    const double brain = smoothMax(shape_.inner + 3.2 + folds, fissure, 3);
    const double cord = coneDistance(p_, {0, 26, -40}, 9, {0, 30, -160}, 5);
    over(std::min(brain, std::max(cord, room + 2)), cranial::grey, SkullTissue::Brain);
    over(brain + 4.5 + 2 * folds, cranial::white, SkullTissue::Brain);
    if (!isDeep) {
        return;
    }
    const glm::dvec3 s = mirrored(shape_.skullPlace);
    const double horns = smoothMin(smoothMin(coneDistance(s, {7.5, -30, 5}, 4, {7, -6, 12.5}, 5),
                                             coneDistance(s, {7, -6, 12.5}, 5, {13, 24, 12}, 5.5), 3),
                                   coneDistance(s, {13, 24, 12}, 5.5, {24, 46, 2}, 4), 3);
    over(horns, cranial::fluid, SkullTissue::Brain);
}

} // namespace

Scanner skullScanner(const SkullPhantomOptions& options) {
    return ctScanner({options.dims, kSkullExtentMm, options.noisePercent, options.seed}, "skull phantom",
                     [](glm::dvec3 p, double voxelMm, std::size_t) {
                         return Skull(p + kSkullMiddleInHead, voxelMm).paint();
                     });
}

LabelledVolume makeSkullPhantom(const SkullPhantomOptions& options) { return scanAll(skullScanner(options)); }

} // namespace vs::phantom
