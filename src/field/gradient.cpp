// SPDX-License-Identifier: Apache-2.0
#include "field/gradient.h"

#include "base/check.h"
#include "field/cell_ranges.h"
#include "field/shaders/bindings.h"
#include "gl/pass.h"
#include "gl/program.h"

#include <bit>
#include <numeric>

namespace vs::field {

namespace {

// Logarithmic bins of count_gradients.comp: 32 to an octave, the lowest one from 0 to 2^-64.
constexpr int kLogBins = 4096;
constexpr std::uint32_t kLogShift = 18;
constexpr std::uint32_t kLogFirst = (127U - 64U) << (23U - kLogShift);

double lowerEnd(std::size_t logBin) {
    return logBin == 0 ? 0 : double(std::bit_cast<float>((std::uint32_t(logBin) + kLogFirst) << kLogShift));
}

struct Magnitudes {
    std::vector<std::uint32_t> counts; // in kLogBins
    double largest = 0;
};

// What every variant of the counting shader needs.
void bind(gl::Program& program, const Field& field, const Range& gradients, glm::ivec2 bins) {
    field.texels.bindTexture(kDataTexture);
    program.set("dims", field.geometry.dims)
        .set("bins", bins)
        .set("valueScale", glm::vec3(field.valueScale, field.valueOffset, field.isIntegral ? 1 : 0))
        .set("ranges", glm::vec4(float(field.usual.lo), float(field.usual.hi), float(gradients.lo),
                                 float(gradients.hi)))
        .set("worldFromVoxelGradient",
             glm::mat4(glm::transpose(glm::dmat3(field.geometry.voxelFromWorld()))));
}

// Runs one variant over the whole field.
void count(gl::Program& program, const Field& field, const Range& gradients, glm::ivec2 bins) {
    bind(program, field, gradients, bins);
    VoxelRows(field.geometry.dims).advance(program, kUnlimitedMs);
}

// No voxel among usual values is steeper: along each axis half of their width lies between two neighbours.
double steepestOfUsual(const Field& field) {
    const glm::dmat3 worldFromVoxelGradient = glm::transpose(glm::dmat3(field.geometry.voxelFromWorld()));
    double perStep = 0;
    for (int axis = 0; axis < 3; ++axis) {
        perStep += glm::length(worldFromVoxelGradient[axis]);
    }
    constexpr double rounding = 1 + 1e-4; // of the device's floats
    return 0.5 * field.usual.width() * perStep * rounding;
}

// Of what is no steeper than usual values can make it: the edge of a fill value tells nothing.
Magnitudes readMagnitudes(const gl::Buffer& counts, const Field& field) {
    Magnitudes out;
    out.counts = counts.read<std::uint32_t>(kLogBins + 1);
    out.largest = double(std::bit_cast<float>(out.counts.back()));
    out.counts.pop_back();
    const double steepest = steepestOfUsual(field);
    if (out.largest > steepest) {
        out.largest = 0;
        for (std::size_t i = 0; i < out.counts.size(); ++i) {
            if (lowerEnd(i) > steepest) {
                out.counts[i] = 0;
            } else if (out.counts[i] > 0 && i > 0) {
                out.largest = std::min(lowerEnd(i + 1), steepest); // to a bin's width
            }
        }
    }
    return out;
}

Magnitudes countMagnitudes(const Field& field) {
    const gl::Pass pass("gradient range");
    gl::Program program("field/shaders/count_gradients.comp", {{"COUNT", "0"}});
    gl::Buffer counts((kLogBins + 1) * sizeof(std::uint32_t), "gradient magnitudes");
    counts.bindStorage(kCountsStorage);
    count(program, field, {}, {kLogBins, 1});
    return readMagnitudes(counts, field);
}

// From 0 to the 99.9th percentile.
Range usualRange(const Magnitudes& magnitudes) {
    const auto total = std::accumulate(magnitudes.counts.begin(), magnitudes.counts.end(), std::uint64_t(0));
    double left = 0.999 * double(total);
    for (std::size_t i = 0; i < magnitudes.counts.size(); ++i) {
        const double here = magnitudes.counts[i];
        if (here > 0 && here >= left) {
            const double top = i + 1 < magnitudes.counts.size() ? lowerEnd(i + 1) : magnitudes.largest;
            const double percentile = glm::mix(lowerEnd(i), top, left / here);
            // Less than a thousandth of all has a gradient: then all of these count.
            return {0, i == 0 ? magnitudes.largest : std::min(percentile, magnitudes.largest)};
        }
        left -= here;
    }
    return {0, magnitudes.largest};
}

} // namespace

Range gradientRange(const Field& field) { return usualRange(countMagnitudes(field)); }

Range fullGradientRange(const Field& field) { return {0, countMagnitudes(field).largest}; }

GradientField computeGradients(const Field& field, double usual) {
    constexpr double room = 16; // so that 16 bits tell usual ones apart to a 4096th
    const gl::Pass pass("gradients");
    GradientField gradients;
    gradients.most = usual > 0 ? room * usual : 1;
    gradients.texels =
        gl::Texture(field.geometry.dims, gl::Format::R16, gl::Filter::Linear, "gradient magnitudes");
    gradients.texels.bindImage(kTargetImage, gl::Access::Write);
    gl::Program program("field/shaders/count_gradients.comp", {{"COUNT", "3"}});
    count(program, field, {0, gradients.most}, {1, 1});
    gradients.cells = computeCellRanges(gradients.texels);
    gradients.quads =
        field.mayHaveQuads ? makeQuads(field.geometry.dims, gl::Format::R16) : gl::TexelBuffer();
    if (gradients.quads) {
        fillQuads(gradients.texels, gradients.quads);
        gradients.texels = {};
    }
    return gradients;
}

std::vector<std::uint32_t> gradientHistogram(const Field& field, const Range& gradients, int bins) {
    VS_CHECK(bins >= 1 && bins <= 4096);
    const gl::Pass pass("gradient histogram");
    gl::Program program("field/shaders/count_gradients.comp", {{"COUNT", "1"}});
    gl::Buffer counts(std::size_t(bins) * sizeof(std::uint32_t), "gradient histogram");
    counts.bindStorage(kCountsStorage);
    count(program, field, gradients, {bins, 1});
    return counts.read<std::uint32_t>(std::size_t(bins));
}

JointHistogram jointHistogram(const Field& field, const Range& gradients, glm::ivec2 bins) {
    VS_CHECK(bins.x >= 1 && bins.x <= 4096 && bins.y >= 1 && bins.y <= 4096);
    const gl::Pass pass("joint histogram");
    gl::Program program("field/shaders/count_gradients.comp", {{"COUNT", "2"}});
    const std::size_t all = std::size_t(bins.x) * std::size_t(bins.y);
    gl::Buffer counts(all * sizeof(std::uint32_t), "joint histogram");
    counts.bindStorage(kCountsStorage);
    count(program, field, gradients, bins);
    return {bins, field.usual, gradients, counts.read<std::uint32_t>(all)};
}

JointCounting::JointCounting(const Field& field, glm::ivec2 bins)
    : field_(&field), measure_("field/shaders/count_gradients.comp", {{"COUNT", "0"}}),
      count_("field/shaders/count_gradients.comp", {{"COUNT", "2"}}),
      magnitudes_((kLogBins + 1) * sizeof(std::uint32_t), "gradient magnitudes"),
      counts_(std::size_t(bins.x) * std::size_t(bins.y) * sizeof(std::uint32_t), "joint histogram"),
      measured_(field.geometry.dims), counted_(field.geometry.dims) {
    VS_CHECK(bins.x >= 1 && bins.x <= 4096 && bins.y >= 1 && bins.y <= 4096);
    joint_ = {bins, field.usual, {}, {}};
}

bool JointCounting::advance(double budgetMs) {
    const gl::Pass pass("joint histogram in slices");
    if (!measured_.isDone()) {
        magnitudes_.bindStorage(kCountsStorage);
        bind(measure_, *field_, {}, {kLogBins, 1});
        if (measured_.advance(measure_, budgetMs)) {
            joint_.gradients = usualRange(readMagnitudes(magnitudes_, *field_));
        }
        return false;
    }
    counts_.bindStorage(kCountsStorage);
    bind(count_, *field_, joint_.gradients, joint_.bins);
    if (!counted_.advance(count_, budgetMs)) {
        return false;
    }
    if (joint_.counts.empty()) {
        joint_.counts = counts_.read<std::uint32_t>(std::size_t(joint_.bins.x) * std::size_t(joint_.bins.y));
    }
    return true;
}

} // namespace vs::field
