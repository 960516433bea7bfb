// SPDX-License-Identifier: Apache-2.0
#include "arguments/sweep_arguments.h"

#include "arguments/parse.h"
#include "base/error.h"
#include "base/lines.h"
#include "image/image.h"
#include "sculpt/mask/mask_image.h"
#include "volume/reading/read_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vs::cli {

namespace {

// Sizes of a mask, each above 0 and at most 4096.
std::vector<double> maskSizes(const std::string& text, const std::string& sizes, std::size_t count,
                              const std::string& example) {
    auto n = parseNumbers(sizes, ',', count, "--mask " + text, example);
    if (!std::all_of(n.begin(), n.end(), [](double value) { return value > 0 && value <= 4096; })) {
        throw UsageError("--mask {}: sizes are in steps (voxels), above 0 and at most 4096", text);
    }
    return n;
}

sculpt::Outline polylineMask(const std::string& text, const std::string& corners) {
    const std::string example = "polyline:-10,-8:12,-6:0,14";
    std::vector<glm::dvec2> points;
    for (const std::string& corner : split(corners, ':')) {
        const auto n = parseNumbers(corner, ',', 2, "--mask " + text, example);
        if (std::max(std::abs(n[0]), std::abs(n[1])) > 4096) {
            throw UsageError("--mask {}: coordinates are in steps (voxels), at most 4096", text);
        }
        points.emplace_back(n[0], n[1]);
    }
    if (points.size() < 3) {
        throw UsageError("--mask {}: needs three corners or more, as in {}", text, example);
    }
    return sculpt::polylineOutline(points);
}

sculpt::Outline starMask(const std::string& text, const std::string& sizes) {
    const auto n = maskSizes(text, sizes, 3, "star:20,8,5");
    if (n[2] < 2 || n[2] > 1000 || n[2] != std::floor(n[2])) {
        throw UsageError("--mask {}: a star has 2 to 1000 points, as in star:20,8,5", text);
    }
    return sculpt::starOutline({0, 0}, n[0], n[1], int(n[2]));
}

sculpt::MaskRaster imageMask(const std::string& text, const std::string& rest, double pitch) {
    const auto comma = rest.rfind(',');
    if (comma == std::string::npos || comma == 0) {
        throw UsageError("--mask {}: name a picture and its width in steps (voxels), as in image:leaf.png,40",
                         text);
    }
    const auto width = maskSizes(text, rest.substr(comma + 1), 1, "image:leaf.png,40");
    return sculpt::maskFromImage(volume::readPicture(rest.substr(0, comma)), width[0], pitch);
}

} // namespace

Parted partAtColon(const std::string& text) {
    const auto split = text.find(':');
    return {text.substr(0, split), split == std::string::npos ? "" : text.substr(split + 1)};
}

std::size_t chooseName(const std::string& text, const char* const* names, std::size_t count,
                       const std::string& option) {
    const auto* found = std::find(names, names + count, text);
    if (found == names + count) {
        throw UsageError("{} '{}' is not known; use {}", option, text, fmt::join(names, names + count, ", "));
    }
    return std::size_t(found - names);
}

glm::ivec3 parseDims(const std::string& text) {
    const auto n = parseNumbers(text, ',', 3, "--dims", "128,128,128");
    for (const double value : n) {
        if (value != std::floor(value) || value < 1 || value > 2048) {
            throw UsageError("--dims {}: each of the three must be a whole number from 1 to 2048", text);
        }
    }
    return glm::ivec3(glm::dvec3(n[0], n[1], n[2]));
}

glm::dvec3 parseSpacing(const std::string& text) {
    const auto n = parseNumbers(text, ',', 3, "--spacing", "1,1,2.5");
    if (!std::all_of(n.begin(), n.end(), [](double value) { return value >= 1e-6 && value <= 1e6; })) {
        throw UsageError("--spacing {}: each of the three is in mm, from 0.000001 to 1000000", text);
    }
    return {n[0], n[1], n[2]};
}

sculpt::MaskFilter parseFilter(const std::string& text) {
    const auto parts = split(text, ',');
    if (parts.empty() || parts.size() > 3) {
        throw UsageError("--filter {}: write SAMPLING, RECONSTRUCTION and WIDTH, as in jittered,bspline,40",
                         text);
    }
    sculpt::MaskFilter filter;
    filter.sampling = choose<sculpt::Sampling>(parts[0], sculpt::kMaskSamplings, "--filter: sampling");
    const bool isFiltered =
        filter.sampling == sculpt::Sampling::Uniform || filter.sampling == sculpt::Sampling::Jittered;
    if (parts.size() > 1 && !isFiltered) {
        throw UsageError("--filter {}: {} has no sub-samples to reconstruct from; leave the rest away", text,
                         parts[0]);
    }
    if (parts.size() > 1) {
        filter.reconstruction =
            choose<sculpt::Reconstruction>(parts[1], sculpt::kReconstructions, "--filter: reconstruction");
        filter.width = filter.reconstruction == sculpt::Reconstruction::Box
                           ? 10
                           : (filter.reconstruction == sculpt::Reconstruction::Tent ? 20 : 40);
    }
    if (parts.size() > 2) {
        const auto width = parseNumbers(parts[2], ',', 1, "--filter " + text, "jittered,bspline,40")[0];
        if (width != std::floor(width) || width < 4 || width > 400) {
            throw UsageError("--filter {}: the width is a whole number of sub-samples from 4 to 400", text);
        }
        filter.width = int(width);
    }
    return filter;
}

void parseSubdivision(const std::string& text, MaskMaking& making) {
    const Parted parts = partAtColon(text);
    making.subdivision =
        choose<sculpt::Subdivision>(parts.head, sculpt::kSubdivisions, "--subdivide: scheme");
    const auto levels = parseNumbers(parts.rest, ',', 1, "--subdivide " + text, "chaikin:3")[0];
    if (levels != std::floor(levels) || levels < 0 || levels > 12) {
        throw UsageError("--subdivide {}: the levels are a whole number from 0 to 12", text);
    }
    making.levels = int(levels);
}

sculpt::MaskRaster parseMask(const std::string& text, const MaskMaking& making) {
    const auto [shape, sizes] = partAtColon(text);
    sculpt::Outline outline;
    if (shape == "ellipse") {
        const auto n = maskSizes(text, sizes, 2, "ellipse:30,20");
        outline = sculpt::ellipseOutline({0, 0}, {n[0], n[1]});
    } else if (shape == "circle") {
        outline = sculpt::circleOutline({0, 0}, maskSizes(text, sizes, 1, "circle:20")[0]);
    } else if (shape == "rectangle") {
        const auto n = maskSizes(text, sizes, 2, "rectangle:40,20");
        outline = sculpt::rectangleOutline({-n[0] / 2, -n[1] / 2}, {n[0] / 2, n[1] / 2});
    } else if (shape == "square") {
        const auto n = maskSizes(text, sizes, 1, "square:30");
        outline = sculpt::rectangleOutline({-n[0] / 2, -n[0] / 2}, {n[0] / 2, n[0] / 2});
    } else if (shape == "star") {
        outline = starMask(text, sizes);
    } else if (shape == "polyline") {
        outline = polylineMask(text, sizes);
    } else if (shape == "image") {
        return imageMask(text, sizes, making.pitch);
    } else {
        throw UsageError("--mask {}: use {}, in steps (voxels)", text, kMaskForms);
    }
    if (making.subdivision) {
        outline = sculpt::subdivide(std::move(outline), *making.subdivision, making.levels);
    }
    return sculpt::rasterize(outline, making.pitch, making.filter);
}

sculpt::FootprintShape parseFootprint(const std::string& text, int radius) {
    if (radius < 2 || radius > 4) {
        throw UsageError("--radius {}: use 2, 3 or 4", radius);
    }
    const auto [name, sizes] = partAtColon(text);
    sculpt::FootprintShape shape;
    shape.radius = radius;
    shape.isSmoothWhereCoarse = true;
    shape.kind = choose<sculpt::FootprintKind>(name, sculpt::kFootprintKinds, "--footprint");
    if (shape.kind == sculpt::FootprintKind::Ellipsoid) {
        const auto n = parseNumbers(sizes, ',', 3, "--footprint " + text, "ellipsoid:1,1,0.6");
        const double most = sculpt::FootprintShape::kMaxSigmaVoxels;
        if (!std::all_of(n.begin(), n.end(), [&](double s) { return s >= 0.1 && s <= most + 0.001; })) {
            throw UsageError("--footprint {}: standard deviations are 0.1 to {:.2f} steps", text, most);
        }
        shape.sigmaSteps = glm::min(glm::dvec3(n[0], n[1], n[2]), most);
    } else if (text.find(':') != std::string::npos) {
        throw UsageError("--footprint {}: {} takes its size from --radius; leave '{}' away", text, name,
                         ":" + sizes);
    }
    return shape;
}

} // namespace vs::cli
