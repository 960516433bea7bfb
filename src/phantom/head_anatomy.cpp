// SPDX-License-Identifier: Apache-2.0
#include "phantom/head_anatomy.h"

#include "phantom/head_cortex.h"
#include "phantom/head_shape.h"
#include "phantom/solid_distances.h"

#include <cmath>

namespace vs::phantom {

namespace {

class Head {
public:
    Head(glm::dvec3 p, double voxelMm);

    TissuePainter paint();

private:
    void paintScalp();
    void paintFace();
    void paintBones();
    void paintBrain();
    void paintDeepBrain();
    void paintVentricles();
    void paintBridges();
    void over(double distance, double value, HeadTissue tissue) {
        painter_.paint(distance, value, std::uint8_t(tissue));
    }

    glm::dvec3 p_;
    glm::dvec3 skull_{0}; // HeadShape::skullPlace
    glm::dvec3 mirror_;   // p_ with both sides alike
    glm::dvec3 mirrorSkull_{0};
    TissuePainter painter_;
    double skin_ = 0;  // signed distances to the surfaces of the head,
    double outer_ = 0; // of the skull
    double inner_ = 0; // and of the skull's inside
};

Head::Head(glm::dvec3 p, double voxelMm) : p_(p), mirror_(mirrored(p)), painter_(voxelMm, t1::air) {
    const HeadShape shape = headShape(p);
    skull_ = shape.skullPlace;
    mirrorSkull_ = mirrored(skull_);
    inner_ = shape.inner;
    outer_ = shape.outer;
    skin_ = shape.skin;
}

void Head::paintScalp() {
    over(skin_, t1::skin, HeadTissue::Scalp);
    over(skin_ + 1.8, t1::fat, HeadTissue::Scalp);
    const double below = glm::smoothstep(-20.0, -50.0, p_.z); // more fat on cheeks and neck
    const double fatMm = 2.6 + 0.9 * std::sin(0.09 * p_.y + 0.07 * p_.z) + 3.5 * below;
    over(skin_ + 1.8 + fatMm, t1::muscle, HeadTissue::Scalp);
    // Muscles are parted by sheets of fat.
    const double bundles = std::sin(0.17 * p_.x + 1.5 * std::sin(0.05 * p_.z)) +
                           std::sin(0.15 * p_.y + 1.2 * std::sin(0.06 * p_.x)) + 0.6 * std::sin(0.12 * p_.z);
    const double sheet = std::abs(bundles) / 0.24 - 1.0;
    over(std::max({sheet, skin_ + 8, 10 - outer_}), 0.75 * t1::fat, HeadTissue::Scalp);
}

void Head::paintFace() {
    over(ellipsoidDistance(mirror_ - glm::dvec3(30, -60, -35), {17, 25, 15}), t1::fat, HeadTissue::Scalp);
    over(coneDistance(mirror_, {30, -38, -32}, 2.5, {41, -67, -34}, 3), t1::muscle, HeadTissue::Scalp);
    over(coneDistance(mirror_, {20, -38, -32}, 2.5, {21, -67, -34}, 3), t1::muscle, HeadTissue::Scalp);
    over(glm::length(mirror_ - glm::dvec3(31, -70, -34)) - 12.2, t1::muscle, HeadTissue::Scalp);
    over(glm::length(mirror_ - glm::dvec3(31, -70, -34)) - 11, t1::fluid - 10, HeadTissue::Scalp);
    over(ellipsoidDistance(mirror_ - glm::dvec3(31, -78.5, -34), {4.5, 2.2, 4.5}), t1::muscle,
         HeadTissue::Scalp);
    // Nasal cavity with its conchae, maxillary sinuses, throat.
    const double nose = ellipsoidDistance(p_ - glm::dvec3(0, -62, -52), {13, 27, 19});
    over(nose - 1.5, t1::bone, HeadTissue::Skull);
    const double conchae = std::abs(std::sin(0.28 * p_.z + 0.05 * mirror_.x)) / 0.28 - 2.2;
    over(smoothMax(nose, 1.3 - mirror_.x, 1), t1::air, HeadTissue::Air);
    over(std::max({conchae, nose + 1, 4.5 - mirror_.x}), t1::skin, HeadTissue::Scalp);
    const double sinus = ellipsoidDistance(mirror_ - glm::dvec3(29, -57, -60), {13, 15, 13});
    over(sinus - 1.5, t1::bone, HeadTissue::Skull);
    over(sinus, t1::air, HeadTissue::Air);
    over(smoothMin(coneDistance(p_, {0, -36, -55}, 7, {0, -14, -72}, 6),
                   coneDistance(p_, {0, -14, -72}, 6, {0, -12, -130}, 8), 4),
         t1::air, HeadTissue::Air);
}

void Head::paintBones() {
    const double jaw = smoothMin(coneDistance(mirror_, {46, 2, -58}, 5, {38, -18, -90}, 7),
                                 coneDistance(mirror_, {38, -18, -90}, 7, {0, -72, -96}, 9), 5);
    const double discs = std::abs(std::sin(0.2 * (p_.z + 4))) / 0.2 - 1.3;
    const double vertebrae = ellipseDistance({p_.x, p_.y - 11}, {12, 9.5});
    const double column = smoothMax(vertebrae, p_.z + 62, 3);
    const double spine = std::max(coneDistance(p_, {0, 48, -66}, 5, {0, 62, -130}, 4), -discs);
    over(std::min({outer_, jaw, column, spine}), t1::bone, HeadTissue::Skull);
    over(std::max(column + 1.5, 1.3 - discs), t1::marrow, HeadTissue::Skull);
    over(std::max(column + 1, discs), t1::muscle, HeadTissue::Skull);
    over(std::min(jaw, spine) + 2.2, t1::marrow, HeadTissue::Skull);
    // Marrow between the tables of the vault.
    over(std::max(outer_ + 2.1, 2.1 - inner_), t1::marrow, HeadTissue::Skull);
}

void Head::paintBrain() {
    const double canal = coneDistance(p_, {0, 24, -40}, 12, {0, 33, -130}, 10);
    over(smoothMin(inner_, canal, 6), t1::fluid, HeadTissue::Csf);
    const double room = smoothMin(inner_, canal, 6);
    const FoldedSheet large = cerebrum(skull_, inner_);
    over(large.pial, t1::grey, HeadTissue::Grey);
    const FoldedSheet small = cerebellum(skull_, inner_);
    over(small.pial, t1::grey, HeadTissue::Grey);
    over(large.white, t1::white, HeadTissue::White);
    over(small.white, t1::white, HeadTissue::White);
    const double stem = smoothMin(smoothMin(coneDistance(mirror_, {5, 14, -8}, 11, {3, 14, -28}, 11),
                                            coneDistance(p_, {0, 18, -34}, 12, {0, 27, -56}, 8.5), 8),
                                  smoothMin(coneDistance(p_, {0, 27, -56}, 8.5, {0, 33, -130}, 5.5),
                                            ellipsoidDistance(p_ - glm::dvec3(0, 9, -33), {17, 11, 13}), 4),
                                  8);
    const double peduncles = coneDistance(mirror_, {12, 20, -35}, 7, {19, 38, -38}, 6);
    over(std::max(smoothMin(stem, peduncles, 6), room + 1.5), t1::white, HeadTissue::White);
}

void Head::paintDeepBrain() {
    const glm::dvec3 m = mirrorSkull_;
    over(corpusCallosum(skull_), t1::white, HeadTissue::White);
    const double thalamus = ellipsoidDistance(m - glm::dvec3(10.5, 13, 1), {8, 14, 9});
    const double putamen = ellipsoidDistance(m - glm::dvec3(26 + 0.15 * (m.y + 2), -2, 0), {5.5, 17, 10});
    const double caudate = smoothMin(coneDistance(m, {14, -22, 6}, 6.5, {17, 0, 15}, 4),
                                     coneDistance(m, {17, 0, 15}, 4, {21, 22, 15}, 2), 3);
    over(std::min({thalamus, putamen, caudate}), 1.06 * t1::grey, HeadTissue::Grey);
}

// Two curved horns on each side, the third ventricle between the thalami, the fourth before the cerebellum.
void Head::paintVentricles() {
    const glm::dvec3 m = mirrorSkull_;
    const double front = coneDistance(m, {7.5, -30, 5}, 4, {7, -6, 12.5}, 5);
    const double body = coneDistance(m, {7, -6, 12.5}, 5, {13, 24, 12}, 5.5);
    const double atrium = coneDistance(m, {13, 24, 12}, 5.5, {24, 37, 3}, 6.5);
    const double back = coneDistance(m, {24, 37, 3}, 6.5, {24, 62, 0}, 2);
    const double below = coneDistance(m, {26, 36, 1}, 5, {34, 12, -17}, 3.2);
    const double tip = coneDistance(m, {34, 12, -17}, 3.2, {31, -9, -24}, 2.2);
    const double lateral = smoothMin(smoothMin(smoothMin(front, body, 3), smoothMin(atrium, back, 5), 3),
                                     smoothMin(below, tip, 3), 3);
    const double third = smoothMax(m.x - 1.8, ellipseDistance({p_.y - 9, p_.z + 2}, {17, 11}), 2);
    const double fourth = ellipsoidDistance(p_ - glm::dvec3(0, 29, -38), {7, 4.5, 11});
    over(std::min({lateral, third, fourth}), t1::fluid, HeadTissue::Ventricle);
}

// What lets growth by threshold alone run out of the brain: optic nerves, and veins from the cortex through
// the skull to the scalp.
void Head::paintBridges() {
    const double nerve = std::min({coneDistance(mirror_, {30, -64, -34}, 1.9, {9, -24, -28}, 1.9),
                                   coneDistance(mirror_, {9, -24, -28}, 1.9, {0, -13, -25}, 2),
                                   coneDistance(mirror_, {0, -13, -25}, 2, {9, 8, -18}, 2)});
    const double veins = std::min({coneDistance(p_, {14, 24, 58}, 1.3, {19, 27, 84}, 1.2),
                                   coneDistance(p_, {-16, 38, 52}, 1.3, {-21, 44, 80}, 1.2),
                                   coneDistance(mirror_, {50, 42, -4}, 1.3, {72, 60, -8}, 1.3)});
    over(std::max(veins, skin_ + 2), t1::vessel, HeadTissue::Scalp);
    over(nerve, 0.85 * t1::white, HeadTissue::Scalp);
}

TissuePainter Head::paint() {
    constexpr double kMargin = 4; // beyond what a voxel spreads, for grids of up to 5 mm
    if (skin_ > kMargin) {
        return painter_;
    }
    const bool isNearBrain = inner_ < kMargin || (mirror_.x < 20 && p_.z < -30);
    if (inner_ > -kMargin) {
        paintScalp();
        paintFace();
        paintBones();
    }
    if (isNearBrain) {
        paintBrain();
        paintDeepBrain();
        paintVentricles();
    }
    paintBridges();
    return painter_;
}

} // namespace

TissuePainter paintHead(glm::dvec3 p, double voxelMm) { return Head(p, voxelMm).paint(); }

} // namespace vs::phantom
