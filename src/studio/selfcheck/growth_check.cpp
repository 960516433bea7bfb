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

using segment::Connectivity;
using segment::Constraints;
using segment::Growth;
using segment::GrowthEngine;

constexpr glm::ivec3 kDims(41, 36, 27);
constexpr int kAll = std::numeric_limits<int>::max();

// Waves with some noise: neighbours differ little enough for growth to get somewhere.
volume::Volume makeWaves(volume::ScalarType type) {
    std::mt19937 random(11);
    return phantom::makePhantom(kDims, type,
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
    forEachVoxel({glm::ivec3(0), kDims}, [&](glm::ivec3 v, std::size_t) {
        const bool isCut = v.x + v.y > 40 && (v.z < 12 || v.z > 15);
        texels.push_back(isCut ? 200 : 100);
    });
    gl::Texture sculpture(kDims, gl::Format::R8, gl::Filter::Nearest, "self check fence");
    sculpture.upload({glm::ivec3(0), kDims}, std::as_bytes(std::span(texels)));
    return sculpture;
}

// Every rule alone and all together, on either side of the fence.
std::vector<std::pair<const char*, Constraints>> rulesWith(Connectivity connectivity,
                                                           const gl::Texture& fence) {
    Constraints range{.range = {20, 150}, .connectivity = connectivity};
    Constraints difference = range;
    difference.difference = {-5, 8};
    Constraints gradient = range;
    gradient.gradient = {2, 14};
    Constraints steeper = range;
    steeper.gradientDifference = {-4, 3};
    Constraints fenced = range;
    fenced.sculpture = &fence;
    fenced.view = field::SculptureView::Cut;
    Constraints all = fenced;
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
    forEachVoxel({glm::ivec3(0), (kDims - first + 8) / 9},
                 [&](glm::ivec3 step, std::size_t) { voxels.push_back(first + 9 * step); });
    return voxels;
}

// What a growth has come to.
void compareGrowths(Tally& tally, const Growth& device, const Growth& host) {
    const auto found = device.generations(false);
    const auto expected = host.generations(false);
    tally.compareAll(std::span<const std::uint32_t>(found), std::span<const std::uint32_t>(expected));
    const auto labels = device.labelMap();
    const auto expectedLabels = host.labelMap();
    tally.compareAll(std::span<const std::uint8_t>(labels), std::span<const std::uint8_t>(expectedLabels));
    tally.compare(double(device.voxelCount()), double(host.voxelCount()));
}

// Two segments, grown, taken back, absorbed in part and grown on.
void growBoth(Tally& tally, const field::Field& field, const Constraints& rules) {
    Growth device(field, GrowthEngine::Device);
    Growth host(field, GrowthEngine::Host);
    const auto both = [&](const std::function<int(Growth&)>& act) { tally.compare(act(device), act(host)); };
    const auto seeds = everyNinth({4, 3, 2});
    const auto others = everyNinth({1, 7, 5});
    both([&](Growth& growth) {
        growth.setConstraints(rules);
        return growth.addSeeds(seeds).added;
    });
    both([](Growth& growth) { return growth.advance(4); });
    both([](Growth& growth) { return growth.takeBack(1); });
    both([&](Growth& growth) { return growth.absorb({seeds.data(), 1}, 3); });
    both([&](Growth& growth) {
        growth.activate(2);
        growth.setConstraints(rules);
        return growth.addSeeds(others).added;
    });
    both([](Growth& growth) { return growth.advance(kAll); });
    compareGrowths(tally, device, host);
    both([](Growth& growth) {
        growth.activate(1);
        return growth.advance(kAll);
    });
    compareGrowths(tally, device, host);
    // Growth that gets nowhere would leave nothing to compare.
    tally.require(host.voxelCount(1) > 100 && host.voxelCount(2) > 100);
}

} // namespace

void checkGrowth(Tally& tally) {
    using enum volume::ScalarType;
    const gl::Texture fence = makeFence();
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = makeWaves(type);
        const auto field = field::uploadVolume(volume);
        for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
            for (const auto& [what, rules] : rulesWith(connectivity, fence)) {
                if (type != UInt8 && !rules.hasFence()) {
                    continue; // how values are stored matters to all rules together as to each
                }
                tally.about(std::string("growth by ") + what + ", " +
                            (connectivity == Connectivity::Six ? "6" : "26") + " neighbours, " + name(type));
                growBoth(tally, field, rules);
            }
        }
    }
}

void checkSeeds(Tally& tally) {
    constexpr glm::dvec3 spacing(1, 0.5, 2);
    const auto volume = makeNoise(kDims, volume::ScalarType::UInt8, 0, 100, spacing);
    const auto field = field::uploadVolume(volume);
    field::SurfacePoints points{gl::Buffer(1200 * sizeof(field::SurfacePoint), "self check points"),
                                {40, 30}};
    std::vector<field::SurfacePoint> places;
    for (const glm::vec4 place : placesIn(kDims, 1200)) {
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
        forEachVoxel(intersect({cell, cell + 2}, {glm::ivec3(0), kDims}), [&](glm::ivec3 v, std::size_t) {
            const double distance = glm::length((glm::dvec3(v) - glm::dvec3(place.voxel)) * spacing);
            if (place.voxel.w > 0.5F && range.contains(volume.at(v)) && distance < nearest) {
                nearest = distance;
                best = indexOf(v, kDims);
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
        tally.require(expected.contains(indexOf(v, kDims)));
    }
}

} // namespace vs::studio
