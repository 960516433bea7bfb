// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "segment/growth/growth.h"
#include "segment/growth/seeds.h"

#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace vs::studio {

namespace {

constexpr glm::ivec3 kGrowthDims(41, 36, 27);
constexpr int kToTheEnd = std::numeric_limits<int>::max();

// Waves with some noise: neighbours differ little enough for growth to get somewhere.
volume::Volume makeWaves(volume::ScalarType type) {
    std::mt19937 random(11);
    return phantom::makePhantom(kGrowthDims, type,
                                [&](glm::dvec3 p) {
                                    const double noise = double(random() % 13) - 6;
                                    return 100 + 35 * std::sin(0.31 * p.x + 1) + 30 * std::cos(0.23 * p.y) +
                                           25 * std::sin(0.4 * p.z + 0.2 * p.x + 2) + noise;
                                },
                                {0.7, 0.9, 1.3});
}

// A sculpture of which an oblique half is cut away, but for a bridge across.
gl::Texture makeFence() {
    std::vector<std::uint8_t> texels;
    forEachVoxel({glm::ivec3(0), kGrowthDims}, [&](glm::ivec3 v, std::size_t) {
        const bool isCut = v.x + v.y > 40 && (v.z < 12 || v.z > 15);
        texels.push_back(isCut ? 200 : 100);
    });
    gl::Texture sculpture(kGrowthDims, gl::Format::R8, gl::Filter::Nearest, "self check fence");
    sculpture.upload({glm::ivec3(0), kGrowthDims}, std::as_bytes(std::span(texels)));
    return sculpture;
}

// Every rule alone and all together, on either side of the fence.
std::vector<std::pair<const char*, segment::Constraints>> rulesWith(segment::Connectivity connectivity,
                                                                    const gl::Texture& fence) {
    segment::Constraints range{.range = {20, 150}, .connectivity = connectivity};
    segment::Constraints difference = range;
    difference.difference = {-5, 8};
    segment::Constraints gradient = range;
    gradient.gradient = {2, 14};
    segment::Constraints steeper = range;
    steeper.gradientDifference = {-4, 3};
    segment::Constraints fenced = range;
    fenced.sculpture = &fence;
    fenced.view = field::SculptureView::Cut;
    segment::Constraints all = fenced;
    all.difference = {-9, 11};
    all.gradient = {1, 16};
    all.gradientDifference = {-7, 6};
    all.view = field::SculptureView::Probe;
    return {{"a range", range},      {"differences", difference},
            {"gradients", gradient}, {"their differences", steeper},
            {"a fence", fenced},     {"all rules", all}};
}

// Voxels all over the grid, from the first one on.
std::vector<glm::ivec3> everyNinth(glm::ivec3 first) {
    std::vector<glm::ivec3> voxels;
    forEachVoxel({glm::ivec3(0), (kGrowthDims - first + 8) / 9},
                 [&](glm::ivec3 step, std::size_t) { voxels.push_back(first + 9 * step); });
    return voxels;
}

// What a growth has come to.
void compareGrowths(Tally& tally, const segment::Growth& device, const segment::Growth& host) {
    const auto found = device.generations(false);
    const auto expected = host.generations(false);
    tally.compareAll(std::span<const std::uint32_t>(found), std::span<const std::uint32_t>(expected));
    const auto labels = device.labelMap();
    const auto expectedLabels = host.labelMap();
    tally.compareAll(std::span<const std::uint8_t>(labels), std::span<const std::uint8_t>(expectedLabels));
    tally.compare(double(device.voxelCount()), double(host.voxelCount()));
}

// Paints every other voxel of a box into the segment at work, and away from it again: voxels of others stay
// theirs.
void paintBoth(Tally& tally, segment::Growth& growth) {
    const Box3 box{{5, 6, 7}, {34, 31, 22}};
    std::vector<std::uint8_t> inside;
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t) { inside.push_back((v.x + v.y + v.z) % 2); });
    for (const bool isToAdd : {true, false}) {
        auto expected = growth.labelMap();
        forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
            auto& label = expected[indexOf(v, kGrowthDims)];
            label = inside[n] == 0 || label == 2 ? label : std::uint8_t(isToAdd ? 1 : 0);
        });
        growth.paint(box, inside, isToAdd);
        const auto found = growth.labelMap();
        tally.compareAll(std::span<const std::uint8_t>(found), std::span<const std::uint8_t>(expected));
    }
}

// Two segments, grown, taken back, absorbed in part, grown on and in the end erased.
void growBoth(Tally& tally, segment::Growth& device, segment::Growth& host,
              const segment::Constraints& rules) {
    const auto both = [&](const std::function<int(segment::Growth&)>& act) {
        tally.compare(act(device), act(host));
    };
    const auto seeds = everyNinth({4, 3, 2});
    const auto others = everyNinth({1, 7, 5});
    both([&](segment::Growth& growth) {
        growth.setConstraints(rules);
        return growth.addSeeds(seeds).added;
    });
    both([](segment::Growth& growth) { return growth.advance(4); });
    both([](segment::Growth& growth) { return growth.takeBack(1); });
    both([&](segment::Growth& growth) { return growth.absorb({seeds.data(), 1}, 3); });
    both([&](segment::Growth& growth) {
        growth.activate(2);
        growth.setConstraints(rules);
        return growth.addSeeds(others).added;
    });
    both([](segment::Growth& growth) { return growth.advance(kToTheEnd); });
    compareGrowths(tally, device, host);
    both([](segment::Growth& growth) {
        growth.activate(1);
        return growth.advance(kToTheEnd);
    });
    compareGrowths(tally, device, host);
    // Growth that gets nowhere would leave nothing to compare.
    tally.require(host.voxelCount(1) > 100 && host.voxelCount(2) > 100);
    paintBoth(tally, device);
    paintBoth(tally, host);
    for (const std::uint8_t label : {2, 1}) {
        both([&](segment::Growth& growth) {
            growth.activate(label);
            growth.reset();
            return int(growth.voxelCount());
        });
    }
}

} // namespace

void checkGrowth(Tally& tally) {
    using enum volume::ScalarType;
    const gl::Texture fence = makeFence();
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = makeWaves(type);
        const auto field = field::uploadVolume(volume);
        segment::Growth device(field, segment::GrowthEngine::Device);
        segment::Growth host(field, segment::GrowthEngine::Host);
        for (const auto connectivity : {segment::Connectivity::Six, segment::Connectivity::TwentySix}) {
            for (const auto& [what, rules] : rulesWith(connectivity, fence)) {
                // How values are stored, and more neighbours, matter to all rules together as to each.
                const bool isTriedEverywhere = rules.hasFence() && rules.gradientDifference;
                if (!isTriedEverywhere && (type != UInt8 || connectivity != segment::Connectivity::Six)) {
                    continue;
                }
                tally.about(std::string("growth by ") + what + ", " +
                            (connectivity == segment::Connectivity::Six ? "6" : "26") + " neighbours, " +
                            name(type));
                growBoth(tally, device, host, rules);
            }
        }
    }
}

void checkSeeds(Tally& tally) {
    constexpr glm::dvec3 spacing(1, 0.5, 2);
    const auto volume = makeNoise(kGrowthDims, volume::ScalarType::UInt8, 0, 100, spacing);
    const auto field = field::uploadVolume(volume);
    field::SurfacePoints points{gl::Buffer(1200 * sizeof(field::SurfacePoint), "self check points"),
                                {40, 30}};
    std::vector<field::SurfacePoint> places;
    for (const glm::vec4 place : placesIn(kGrowthDims, 1200)) {
        places.push_back({glm::vec4(glm::vec3(place), places.size() % 4 == 0 ? 0 : 1), glm::vec4(0)});
    }
    points.points.write(std::span<const field::SurfacePoint>(places));
    const Range range{30, 60};
    // For each hit the nearest corner of its cell that lies in the range.
    std::set<std::size_t> expected;
    for (const auto& place : places) {
        const glm::ivec3 cell(glm::floor(glm::vec3(place.voxel)));
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t best = 0;
        forEachVoxel(
            intersect({cell, cell + 2}, {glm::ivec3(0), kGrowthDims}), [&](glm::ivec3 v, std::size_t) {
                const double distance = glm::length((glm::dvec3(v) - glm::dvec3(place.voxel)) * spacing);
                if (place.voxel.w > 0.5F && range.contains(volume.at(v)) && distance < nearest) {
                    nearest = distance;
                    best = indexOf(v, kGrowthDims);
                }
            });
        if (std::isfinite(nearest)) {
            expected.insert(best);
        }
    }
    const auto found = segment::SeedFinder().find(points, field, {.range = range});
    tally.about("voxels to grow from");
    tally.compare(double(found.size()), double(expected.size()));
    for (const glm::ivec3 v : found) {
        tally.require(expected.contains(indexOf(v, kGrowthDims)));
    }
}

} // namespace vs::studio
