// SPDX-License-Identifier: Apache-2.0
#include "phantom/abdomen_phantom.h"

#include "phantom/abdomen_bones.h"
#include "phantom/abdomen_tubes.h"
#include "phantom/ct_scan.h"
#include "phantom/solid_distances.h"

namespace vs::phantom {

namespace {

constexpr glm::dvec3 kAbdomenExtentMm(400, 320, 460);

namespace abdominal {
constexpr double air = -1000;
constexpr double gas = -900;
constexpr double fat = -100;
constexpr double urine = 8;
constexpr double skin = 20;
constexpr double wall = 40;
constexpr double thrombus = 42;
constexpr double muscle = 55;
constexpr double cartilage = 95;
constexpr double liver = 100;
constexpr double spleen = 122;
constexpr double kidney = 165;
constexpr double stool = 250;
constexpr double blood = 300;
constexpr double marrow = 430;
constexpr double bone = 720;
constexpr double steel = 2400;
} // namespace abdominal

// All tubes, which are the same for every voxel.
struct Tubes {
    TubeSet arteries = abdominalArteries();
    TubeSet wires = stentWires();
    TubeSet ribs = lowerRibs();
    TubeSet colon = colonCourse();
};

double skinDistance(glm::dvec3 p) {
    const glm::dvec3 m(std::abs(p.x), p.y, p.z);
    const double waist = std::exp(-std::pow((p.z - 50) / 70, 2));
    const double hips = glm::smoothstep(-10.0, -150.0, p.z);
    const glm::dvec2 radii(173 - 15 * waist + 7 * hips, 114 - 5 * waist - 2 * hips);
    const double furrow =
        5 * std::exp(-std::pow(p.x / 14, 2)) * glm::smoothstep(60.0, 100.0, p.y) * (1 - hips);
    const double trunk = smoothMax(ellipseDistance({p.x, p.y + 2}, radii) + furrow, -200 - p.z, 60);
    const double thigh = coneDistance(m, {86, 6, -175}, 84, {92, 4, -330}, 76);
    const double buttock = ellipsoidDistance(m - glm::dvec3(50, 54, -165), {72, 66, 66});
    const double navel = ellipsoidDistance(p - glm::dvec3(0, -116, 12), {5, 12, 7});
    return smoothMax(smoothMin(smoothMin(trunk, thigh, 22), buttock, 18), -navel, 6);
}

class Abdomen {
public:
    Abdomen(const Tubes& tubes, glm::dvec3 p, double voxelMm)
        : tubes_(tubes), p_(p), m_(std::abs(p.x), p.y, p.z), painter_(voxelMm, abdominal::air),
          skin_(skinDistance(p)) {}

    TissuePainter paint() {
        constexpr double kMargin = 6;
        if (skin_ > kMargin) {
            return painter_;
        }
        paintWall();
        if (skin_ < -kMargin) {
            paintOrgans();
            paintColon();
            paintBones();
            paintArteries();
        }
        return painter_;
    }

private:
    void over(double distance, double value, AbdomenTissue tissue) {
        painter_.paint(distance, value, std::uint8_t(tissue));
    }
    void paintWall();
    void paintCavity(double muscles);
    void paintOrgans();
    void paintKidneys();
    void paintColon();
    void paintBones();
    void paintArteries();

    const Tubes& tubes_;
    glm::dvec3 p_;
    glm::dvec3 m_; // p_ with both sides alike
    TissuePainter painter_;
    double skin_;
};

// Skin, fat, muscles parted by sheets of fat, and the fat within.
void Abdomen::paintWall() {
    over(skin_, abdominal::skin, AbdomenTissue::Soft);
    over(skin_ + 2.4, abdominal::fat, AbdomenTissue::Soft);
    const double below = glm::smoothstep(20.0, -120.0, p_.z);
    const double fatMm =
        12 + 7 * below + 3 * std::sin(0.03 * p_.x + 0.02 * p_.z) + 2 * std::sin(0.045 * p_.y);
    const double muscles = skin_ + 2.4 + fatMm;
    over(muscles, abdominal::muscle, AbdomenTissue::Soft);
    const double bundles = std::sin(0.085 * p_.x + 1.4 * std::sin(0.02 * p_.z)) +
                           std::sin(0.08 * p_.y + 1.2 * std::sin(0.03 * p_.x)) + 0.5 * std::sin(0.05 * p_.z);
    const double sheet = std::abs(bundles) / 0.12 - 0.9;
    over(std::max({sheet, muscles + 4, p_.z + 60 - 2 * std::max(p_.y - 60, 0.0)}), 0.7 * abdominal::fat,
         AbdomenTissue::Soft);
    paintCavity(muscles);
}

void Abdomen::paintCavity(double muscles) {
    const double floor = -178 - p_.z + 0.0022 * (m_.x * m_.x + (p_.y - 20) * (p_.y - 20));
    const double back = p_.y - 76 + 0.0009 * m_.x * m_.x;
    const double cavity = smoothMax(smoothMax(muscles + 13, back, 12), floor, 20);
    if (cavity > 6) {
        return;
    }
    over(cavity, abdominal::fat, AbdomenTissue::Soft);
    const double psoas = smoothMin(smoothMin(coneDistance(m_, {26, 44, 125}, 8, {42, 34, 40}, 19),
                                             coneDistance(m_, {42, 34, 40}, 19, {66, 10, -62}, 18), 8),
                                   smoothMin(coneDistance(m_, {66, 10, -62}, 18, {88, -24, -122}, 14),
                                             coneDistance(m_, {88, -24, -122}, 14, {106, 14, -190}, 10), 8),
                                   8);
    const double iliacus = coneDistance(m_, {114, 8, -30}, 8, {94, -8, -100}, 16);
    over(smoothMin(psoas, iliacus, 10), abdominal::muscle, AbdomenTissue::Soft);
    // Loops of the small bowel: one folded tube fills the middle.
    const double room = ellipsoidDistance(p_ - glm::dvec3(6, -42, -8), {78, 46, 66});
    const glm::dvec3 q = p_ + 7.0 * glm::sin(0.06 * glm::dvec3(p_.y, p_.z, p_.x));
    const double loops = std::sin(0.13 * q.x) * std::cos(0.11 * q.z) +
                         std::sin(0.12 * q.y) * std::cos(0.13 * q.x) +
                         std::sin(0.12 * q.z) * std::cos(0.12 * q.y);
    over(std::max({room, 9 * (0.12 - std::abs(loops)), cavity + 3}), abdominal::wall - 8,
         AbdomenTissue::Soft);
}

void Abdomen::paintOrgans() {
    const double wall = skin_ + 30;
    if (p_.z > 40) {
        const double dome = ellipsoidDistance(p_ - glm::dvec3(-62, -4, 178), {96, 96, 92});
        const double left = ellipsoidDistance(p_ - glm::dvec3(18, -44, 196), {72, 52, 46});
        const double under = 92 + 0.42 * (p_.x + 70) - 0.32 * (p_.y + 20) - p_.z;
        const double liver = smoothMax(smoothMax(smoothMin(dome, left, 20), under, 16), wall, 8);
        over(liver, abdominal::liver, AbdomenTissue::Liver);
        const double veins = std::sin(0.07 * p_.x + 1.6 * std::sin(0.04 * p_.y)) * std::sin(0.08 * p_.z) +
                             std::sin(0.06 * p_.y + std::sin(0.05 * p_.x));
        over(std::max(liver + 5, 12 * (1.55 - std::abs(veins))), abdominal::liver + 22, AbdomenTissue::Liver);
        const double spleen =
            smoothMax(ellipsoidDistance(p_ - glm::dvec3(104, 42, 178), {34, 44, 52}), wall, 8);
        over(spleen, abdominal::spleen, AbdomenTissue::Soft);
        const double stomach = smoothMin(ellipsoidDistance(p_ - glm::dvec3(66, -22, 188), {40, 46, 46}),
                                         coneDistance(p_, {50, -60, 150}, 26, {2, -62, 128}, 16), 22);
        over(std::max({stomach, 4 - spleen, 3 - liver}), abdominal::wall, AbdomenTissue::Soft);
        over(std::max({stomach, 4 - spleen, 3 - liver}) + 5, abdominal::skin, AbdomenTissue::Soft);
        paintKidneys();
    } else {
        const double bladder = ellipsoidDistance(p_ - glm::dvec3(0, -26, -132), {32, 28, 25});
        over(bladder, abdominal::wall, AbdomenTissue::Soft);
        over(bladder + 3.5, abdominal::urine, AbdomenTissue::Soft);
    }
}

void Abdomen::paintKidneys() {
    const double height = p_.x > 0 ? 100 : 88;  // the liver presses on the right one
    const double lean = 0.22 * (p_.z - height); // upwards they come closer
    const glm::dvec3 q(m_.x - 70 + lean, p_.y - 48 - 0.12 * (p_.z - height), p_.z - height);
    const double kidney = ellipsoidDistance(q, {27, 22, 54});
    if (kidney > 14) {
        return;
    }
    const double sinus = ellipsoidDistance(q - glm::dvec3(-20, -6, 0), {22, 10, 20});
    over(kidney - 9, abdominal::fat, AbdomenTissue::Soft);
    over(smoothMax(kidney, -sinus, 5), abdominal::kidney, AbdomenTissue::Kidneys);
    const double pyramids = std::sin(0.28 * q.z) * std::sin(0.22 * q.y + 0.9);
    over(std::max({kidney + 8, 3 - sinus, 9 * (0.35 - std::abs(pyramids))}), abdominal::kidney - 28,
         AbdomenTissue::Kidneys);
}

// Haustra are bulges between folds, in three rows that are out of step. Gas lies in front.
void Abdomen::paintColon() {
    constexpr double kHaustrumMm = 27;
    constexpr double kWallMm = 3;
    const TubeSet::Nearest nearest = tubes_.colon.nearest(p_);
    if (nearest.tube < 0 || nearest.distance > 12) {
        return;
    }
    const glm::dvec3 off = p_ - nearest.middle;
    const glm::dvec3 side = glm::normalize(glm::cross(nearest.direction, glm::dvec3(0.3, 0.8, 0.52)));
    const double around = std::atan2(glm::dot(off, glm::cross(side, nearest.direction)), glm::dot(off, side));
    const double phase = std::numbers::pi * nearest.alongMm / kHaustrumMm + 0.8 * std::sin(1.5 * around) +
                         0.7 * std::sin(0.021 * nearest.alongMm);
    const double bulge = std::sqrt(std::abs(std::sin(phase)));
    constexpr double kRectumMm = 960; // from where on there are no haustra
    const double depth = 0.26 * (1 - glm::smoothstep(kRectumMm - 80, kRectumMm, nearest.alongMm));
    const double sacs = nearest.distance + nearest.radius * depth * (1 - bulge);
    const double lumen = std::max(sacs, skin_ + 26); // the wall of the belly is in front
    // Where the stool's level lies: 1 all gas, -1 all stool.
    const double along = nearest.alongMm;
    const double level =
        -0.2 + 1.6 * glm::smoothstep(170.0, 215.0, along) - 2.8 * glm::smoothstep(440.0, 480.0, along) +
        1.7 * glm::smoothstep(640.0, 700.0, along) - 0.9 * glm::smoothstep(860.0, 930.0, along);
    const double above = off.y - level * nearest.radius;
    over(lumen - kWallMm, abdominal::wall, AbdomenTissue::Soft);
    over(lumen, abdominal::stool, AbdomenTissue::ColonStool);
    over(std::max(lumen, above), abdominal::gas, AbdomenTissue::ColonGas);
}

void Abdomen::paintBones() {
    const SpineDistances column = spine(p_);
    over(column.canal, abdominal::skin, AbdomenTissue::Soft);
    over(column.disc, abdominal::cartilage, AbdomenTissue::Soft);
    const auto paintBone = [&](double distance, double cortexMm, AbdomenTissue tissue) {
        over(distance, abdominal::bone, tissue);
        over(distance + cortexMm, abdominal::marrow, tissue);
    };
    paintBone(column.bone, 2.2, AbdomenTissue::Spine);
    paintBone(tubes_.ribs.nearest(p_).distance, 2, AbdomenTissue::Ribs);
    if (p_.z < 20) {
        const double hips = pelvis(p_);
        const double legs = femora(p_);
        over(legs - 3, abdominal::cartilage, AbdomenTissue::Soft);
        paintBone(std::max(hips, 4 - legs), 2.4, AbdomenTissue::Pelvis);
        paintBone(legs, 3, AbdomenTissue::Femora);
    }
}

void Abdomen::paintArteries() {
    const double lumen = tubes_.arteries.nearest(p_).distance;
    const double sac = ellipsoidDistance(p_ - glm::dvec3(3, -3, 36), {25, 20, 40}); // an aneurysm, clotted
    over(std::max(sac, 18 - p_.y > 0 ? sac : p_.y - 18), abdominal::thrombus, AbdomenTissue::Soft);
    over(lumen - 1.6, abdominal::wall, AbdomenTissue::Soft);
    const double plaque = coneDistance(p_, {76, -40, -127}, 3.6, {72, -24, -130}, 4.5);
    over(plaque, abdominal::blood, AbdomenTissue::Soft);
    over(lumen, abdominal::blood, AbdomenTissue::Artery);
    over(tubes_.wires.nearest(p_).distance, abdominal::steel, AbdomenTissue::Stent);
}

} // namespace

Scanner abdomenScanner(const AbdomenPhantomOptions& options) {
    return ctScanner({options.dims, kAbdomenExtentMm, options.noisePercent, options.seed}, "abdomen phantom",
                     [tubes = std::make_shared<const Tubes>()](glm::dvec3 p, double voxelMm, std::size_t) {
                         return Abdomen(*tubes, p, voxelMm).paint();
                     });
}

LabelledVolume makeAbdomenPhantom(const AbdomenPhantomOptions& options) {
    return scanAll(abdomenScanner(options));
}

} // namespace vs::phantom
