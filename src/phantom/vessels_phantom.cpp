// SPDX-License-Identifier: Apache-2.0
#include "phantom/vessels_phantom.h"

#include "phantom/artery_tree.h"
#include "phantom/head_cortex.h"
#include "phantom/head_shape.h"
#include "phantom/noise.h"
#include "phantom/solid_distances.h"
#include "phantom/tissue_painter.h"

#include <cmath>
#include <memory>

namespace vs::phantom {

namespace {

constexpr glm::dvec3 kVesselsExtentMm(180, 210, 150);
constexpr glm::dvec3 kMiddleInHead(0, -2, -12); // the grid's, in head coordinates

namespace tof {
constexpr double air = 3;
constexpr double bone = 18;
constexpr double fluid = 44;
constexpr double white = 67;
constexpr double muscle = 70;
constexpr double grey = 77;
constexpr double skin = 88;
constexpr double scalpFat = 106;
constexpr double thinVein = 152;
constexpr double cheekFat = 160;
constexpr double vein = 166;
constexpr double smallArtery = 205;
constexpr double largeArtery = 236;
} // namespace tof

class AngioHead {
public:
    AngioHead(const TubeSet& arteries, const TubeSet& veins, glm::dvec3 p, double voxelMm)
        : arteries_(arteries), veins_(veins), p_(p), shape_(headShape(p)), painter_(voxelMm, tof::air),
          shade_(1 + 0.05 * std::sin(0.045 * p.x + 1) * std::cos(0.04 * p.y) + 0.04 * std::sin(0.06 * p.z)) {}

    TissuePainter paint() {
        constexpr double kMargin = 4;
        if (shape_.skin > kMargin) {
            return painter_;
        }
        if (shape_.inner > -kMargin) {
            paintOutside();
        }
        if (shape_.inner < kMargin || (std::abs(p_.x) < 20 && p_.z < -30)) {
            paintBrain();
        }
        paintBlood();
        return painter_;
    }

private:
    void over(double distance, double value, VesselsTissue tissue) {
        painter_.paint(distance, shade_ * value, std::uint8_t(tissue));
    }
    void paintOutside();
    void paintBrain();
    void paintBlood();

    const TubeSet& arteries_;
    const TubeSet& veins_;
    glm::dvec3 p_;
    HeadShape shape_;
    TissuePainter painter_;
    double shade_; // the coil's sensitivity, which varies smoothly
};

void AngioHead::paintOutside() {
    const glm::dvec3 m = mirrored(p_);
    const double skin = shape_.skin;
    over(skin, tof::skin, VesselsTissue::Tissue);
    over(skin + 1.8, tof::scalpFat, VesselsTissue::Tissue);
    const double fatMm = 2.4 + 0.8 * std::sin(0.09 * p_.y + 0.07 * p_.z);
    over(skin + 1.8 + fatMm, tof::muscle, VesselsTissue::Tissue);
    const double bundles = std::sin(0.17 * p_.x + 1.5 * std::sin(0.05 * p_.z)) +
                           std::sin(0.15 * p_.y + 1.2 * std::sin(0.06 * p_.x)) + 0.6 * std::sin(0.12 * p_.z);
    over(std::max(std::abs(bundles) / 0.24 - 1, skin + 8), tof::grey, VesselsTissue::Tissue); // sheets of fat
    const double socket = ellipsoidDistance(m - glm::dvec3(30, -60, -35), {17, 25, 15});
    const double eye = glm::length(m - glm::dvec3(31, -70, -34)) - 12;
    over(std::max(socket, skin + 4), tof::skin, VesselsTissue::Tissue);
    over(std::max(eye, skin + 4), tof::fluid, VesselsTissue::Tissue);
    const double jaw = coneDistance(m, {46, 2, -58}, 5, {38, -18, -90}, 7);
    const double spine = coneDistance(p_, {0, 11, -70}, 11, {0, 11, -130}, 11);
    const double cheek = coneDistance(m, {36, -66, -56}, 6, {62, -28, -46}, 4);
    over(std::min(shape_.outer, std::max(std::min({jaw, spine, cheek}), skin + 5)), tof::bone,
         VesselsTissue::Tissue);
    const double nose = ellipsoidDistance(p_ - glm::dvec3(0, -62, -52), {13, 27, 19});
    const double sinus = ellipsoidDistance(m - glm::dvec3(29, -57, -60), {13, 15, 13});
    const double throat = smoothMin(coneDistance(p_, {0, -36, -55}, 7, {0, -14, -72}, 6),
                                    coneDistance(p_, {0, -14, -72}, 6, {0, -12, -130}, 8), 4);
    const double conchae = std::abs(std::sin(0.28 * p_.z + 0.05 * m.x)) / 0.28 - 2.2;
    over(std::min({smoothMax(nose, 1.3 - m.x, 1), sinus, throat}), tof::air, VesselsTissue::Air);
    over(std::max({conchae, nose + 1, 4.5 - m.x}), tof::muscle, VesselsTissue::Tissue);
}

void AngioHead::paintBrain() {
    const double canal = coneDistance(p_, {0, 24, -40}, 12, {0, 33, -130}, 10);
    const double room = smoothMin(shape_.inner, canal, 6);
    over(room, tof::fluid, VesselsTissue::Tissue);
    const FoldedSheet large = cerebrum(shape_.skullPlace, shape_.inner);
    const FoldedSheet small = cerebellum(shape_.skullPlace, shape_.inner);
    const glm::dvec3 m = mirrored(p_);
    const double stem = smoothMin(coneDistance(m, {5, 14, -8}, 11, {3, 14, -28}, 11),
                                  smoothMin(ellipsoidDistance(p_ - glm::dvec3(0, 9, -33), {17, 11, 13}),
                                            coneDistance(p_, {0, 18, -36}, 12, {0, 33, -130}, 5.5), 6),
                                  8);
    over(std::min(large.pial, small.pial), tof::grey, VesselsTissue::Brain);
    over(std::min({large.white, small.white, corpusCallosum(shape_.skullPlace)}), tof::white,
         VesselsTissue::Brain);
    over(std::max(stem, room + 1.5), tof::white, VesselsTissue::Brain);
    const glm::dvec3 s = mirrored(shape_.skullPlace);
    const double ventricle = smoothMin(smoothMin(coneDistance(s, {7.5, -30, 5}, 4, {7, -6, 12.5}, 5),
                                                 coneDistance(s, {7, -6, 12.5}, 5, {13, 24, 12}, 5.5), 3),
                                       coneDistance(s, {13, 24, 12}, 5.5, {24, 40, 2}, 5), 3);
    over(ventricle, tof::fluid, VesselsTissue::Brain);
}

void AngioHead::paintBlood() {
    const TubeSet::Nearest vein = veins_.nearest(p_);
    const glm::dvec3 q = p_ - glm::dvec3(-44, -47, -68);
    const double lumps =
        1.3 * std::sin(0.5 * q.x) * std::sin(0.45 * q.y + 0.8) + 1.2 * std::sin(0.4 * q.z + 0.3 * q.x);
    over(ellipsoidDistance(q, {8.5, 17, 14}) + lumps, tof::cheekFat, VesselsTissue::Bright);
    over(std::max(vein.distance, shape_.skin + 3), vein.tube == 0 ? tof::thinVein : tof::vein,
         VesselsTissue::Bright);
    const TubeSet::Nearest artery = arteries_.nearest(p_);
    // Blood is fresher in what is wide.
    const double fresh = glm::smoothstep(0.5, 1.9, artery.radius);
    over(artery.distance, glm::mix(tof::smallArtery, tof::largeArtery, fresh) / shade_,
         VesselsTissue::Artery);
}

} // namespace

Scanner vesselsScanner(const VesselsPhantomOptions& options) {
    struct Trees {
        TubeSet arteries = arteryTree();
        TubeSet veins = veinTree();
    };
    const auto grid = phantomGrid(options.dims, kVesselsExtentMm);
    const double voxelMm = std::cbrt(grid.voxelMm3());
    const double sigma = 0.01 * options.noisePercent * tof::largeArtery;
    return scannerOf<std::uint8_t>(
        "vessels phantom", grid, volume::ScalarType::UInt8,
        [trees = std::make_shared<const Trees>(), voxelMm, sigma,
         seed = options.seed](glm::dvec3 place, std::size_t n) -> Measured {
            const glm::dvec3 p = place + kMiddleInHead;
            const TissuePainter painted = AngioHead(trees->arteries, trees->veins, p, voxelMm).paint();
            double value = painted.value();
            if (sigma > 0) {
                const glm::dvec2 noise = sigma * normalPair(seed, n);
                value = std::hypot(value + noise.x, noise.y);
            }
            return {std::clamp(std::floor(value + 0.5), 0.0, 255.0), painted.label()};
        });
}

LabelledVolume makeVesselsPhantom(const VesselsPhantomOptions& options) {
    return scanAll(vesselsScanner(options));
}

} // namespace vs::phantom
