// SPDX-License-Identifier: Apache-2.0
// vstudio histogram: how often values occur, as a chart for print and as numbers.
#include "arguments/parse.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/value_counts.h"

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"
#include "field/gradient.h"
#include "gl/context.h"
#include "image/axis.h"
#include "image/chart.h"
#include "image/image.h"
#include "render/colours/colour_map.h"
#include "volume/grid/histogram.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

namespace vs::cli {

namespace {

struct HistogramOptions {
    std::shared_ptr<VolumeArgument> volume;
    std::string output;
    std::string kind = "intensity";
    std::string range;
    std::string size = "1200x800";
    std::string csv;
    bool isLinear = false;
};

// Counts in equal bins over a range.
struct Counts {
    Range range;
    std::vector<double> counts;
    double pitch = 0; // between neighbouring values that can occur; 0: anything can
};

constexpr int kBins = 512; // at most
constexpr int kGradientBins = 320;
constexpr const char* kGradientLabel = "gradient magnitude (intensity per mm)";

// Axes need a width, whatever the values.
Range around(double value) { return {value - 0.5, value + 0.5}; }
Range notEmpty(const Range& gradients) { return gradients.width() > 0 ? gradients : Range{0, 1}; }

// Values that come in steps have bins around as many of them each as make few enough bins: with unequal
// numbers of them the bins would look like a comb. Others have equal parts of the range.
Counts countIntensities(const volume::Volume& volume) {
    if (volume.usual.width() == 0) {
        return {around(volume.usual.lo), {double(volume.geometry.voxelCount() - volume.nonFiniteCount)}};
    }
    const auto steps = countSteps(volume);
    if (!steps) {
        const auto counts = volume::histogram(volume, kBins);
        return {volume.usual, {counts.begin(), counts.end()}};
    }
    const std::size_t perBin = (steps->counts.size() + kBins - 1) / kBins;
    std::vector<double> counts((steps->counts.size() + perBin - 1) / perBin);
    for (std::size_t i = 0; i < steps->counts.size(); ++i) {
        counts[i / perBin] += double(steps->counts[i]);
    }
    const double lo = volume.range.lo - 0.5 * steps->pitch;
    return {{lo, lo + double(perBin * counts.size()) * steps->pitch}, counts, steps->pitch};
}

// A range of values with the bins that they stand in.
Range widened(const Range& range, const Counts& histogram) {
    return {range.lo - 0.5 * histogram.pitch, range.hi + 0.5 * histogram.pitch};
}

double sum(const std::vector<double>& counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); }

// "7 221 032 voxels, 4 not finite, 256 bins"
std::string describe(const volume::Volume& volume, double counted, const std::string& bins) {
    const double all = double(volume.geometry.voxelCount());
    const double other = all - counted - double(volume.nonFiniteCount);
    std::string text = image::tickLabel(all) + " voxels";
    if (volume.nonFiniteCount > 0) {
        text += ", " + image::tickLabel(double(volume.nonFiniteCount)) + " not finite";
    }
    if (other > 0) {
        text += ", " + image::tickLabel(other) + " not shown";
    }
    return text + ", " + bins + " bins";
}

// One line a bin.
std::string csvOf(const Counts& histogram) {
    std::string text = "from,to,voxels\n";
    const double width = histogram.range.width() / double(histogram.counts.size());
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        text += fmt::format("{:.9g},{:.9g},{:.0f}\n", histogram.range.lo + double(i) * width,
                            histogram.range.lo + double(i + 1) * width, histogram.counts[i]);
    }
    return text;
}

struct Result {
    image::Image picture;
    std::string csv;
};

std::string label(const std::string& what, const Range& range) {
    // 32-bit floats have no more digits than that.
    const auto rounded = [](double value) {
        return image::tickLabel(std::stod(fmt::format("{:.6g}", value)));
    };
    return what + " " + rounded(range.lo) + " to " + rounded(range.hi);
}

Result intensityHistogram(const volume::Volume& volume, const Range& shaded, glm::ivec2 size, bool isLinear) {
    const Counts histogram = countIntensities(volume);
    image::BarChart chart;
    chart.title = volume.name;
    chart.note = describe(volume, sum(histogram.counts), std::to_string(histogram.counts.size()));
    chart.across = {histogram.range, "intensity"};
    chart.counts = histogram.counts;
    chart.isLogarithmic = !isLinear;
    chart.shaded = widened(shaded, histogram);
    chart.shadedLabel = label("displayed range", shaded);
    return {image::drawChart(chart, size), csvOf(histogram)};
}

// The gradients of all voxels: their logarithmic counts leave room for the rare steep ones.
Result gradientHistogram(const volume::Volume& volume, glm::ivec2 size, bool isLinear) {
    const auto context = gl::Context::createHeadless();
    const field::Field field = field::uploadVolume(volume);
    const Range range = notEmpty(field::fullGradientRange(field));
    const auto counts = field::gradientHistogram(field, range, kGradientBins);
    context.requireNoErrors();
    const Counts histogram{range, {counts.begin(), counts.end()}};
    image::BarChart chart;
    chart.title = volume.name;
    chart.note = describe(volume, sum(histogram.counts), std::to_string(kGradientBins));
    chart.across = {range, kGradientLabel};
    chart.counts = histogram.counts;
    chart.isLogarithmic = !isLinear;
    return {image::drawChart(chart, size), csvOf(histogram)};
}

// "value_from,value_to,gradient_from,gradient_to,voxels", one line a bin that is not empty.
std::string csvOf(const field::JointHistogram& joint) {
    std::string text = "value_from,value_to,gradient_from,gradient_to,voxels\n";
    const double wide = joint.values.width() / joint.bins.x;
    const double tall = joint.gradients.width() / joint.bins.y;
    for (std::size_t i = 0; i < joint.counts.size(); ++i) {
        if (joint.counts[i] > 0) {
            const std::size_t column = i % std::size_t(joint.bins.x);
            const std::size_t row = i / std::size_t(joint.bins.x);
            const double x = double(column);
            const double y = double(row);
            text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{}\n", joint.values.lo + x * wide,
                                joint.values.lo + (x + 1) * wide, joint.gradients.lo + y * tall,
                                joint.gradients.lo + (y + 1) * tall, joint.counts[i]);
        }
    }
    return text;
}

std::vector<glm::u8vec3> densityColours() {
    const render::ColourMap* map = render::findColourMap("ember");
    VS_CHECK(map != nullptr);
    std::vector<glm::u8vec3> colours;
    for (const glm::dvec3 oklab : map->oklab) {
        colours.push_back(render::colourFromLinear(render::linearFromOklab(oklab)));
    }
    return colours;
}

// The steepest thousandth is left out, or the rest would be squeezed into the lowest part of the chart.
Result jointHistogram(const volume::Volume& volume, const Range& marked, glm::ivec2 size, bool isLinear) {
    const auto context = gl::Context::createHeadless();
    field::Field field = field::uploadVolume(volume);
    const Range gradients = notEmpty(field::gradientRange(field));
    // The bins along the intensities are those of the intensities alone: values lie inside them, not on their
    // borders.
    const Counts alone = countIntensities(volume);
    field.usual = alone.range;
    const auto joint = field::jointHistogram(field, gradients, {int(alone.counts.size()), kGradientBins});
    context.requireNoErrors();
    image::DensityChart chart;
    chart.counts.assign(joint.counts.begin(), joint.counts.end());
    chart.title = volume.name;
    chart.note = describe(volume, sum(chart.counts), fmt::format("{} × {}", joint.bins.x, joint.bins.y));
    chart.across = {joint.values, "intensity"};
    chart.up = {joint.gradients, kGradientLabel};
    chart.bins = joint.bins;
    chart.isLogarithmic = !isLinear;
    chart.colours = densityColours();
    chart.marked = widened(marked, alone);
    chart.markedLabel = label("displayed range", marked);
    return {image::drawChart(chart, size), csvOf(joint)};
}

// The range that the volume is shown in at first, as `info` suggests it.
Range suggestedRange(const volume::Volume& volume) {
    const double lo = volume::otsuThreshold(volume::histogram(volume, 256), volume.usual);
    return {volume.type == volume::ScalarType::Float32 ? lo : std::ceil(lo), volume.usual.hi};
}

glm::ivec2 chartSize(const std::string& text) {
    const glm::ivec2 size = parseSize(text);
    const glm::ivec2 least = image::kSmallestChart;
    if (size.x < least.x || size.y < least.y) {
        throw UsageError("size '{}' has no room for a chart; at least {}x{} pixels are needed", text, least.x,
                         least.y);
    }
    return size;
}

// What can be wrong is said before the volume is read.
void check(const HistogramOptions& options) {
    if (options.kind == "gradient" && !options.range.empty()) {
        throw UsageError("--range {}: marks intensities, and --kind gradient shows none", options.range);
    }
    checkPictureName(options.output);
    outputFile(options.output);
    if (options.csv.empty()) {
        return;
    }
    if (!options.csv.ends_with(".csv")) {
        throw UsageError("--csv {}: give a name that ends in .csv", options.csv);
    }
    outputFile(options.csv);
}

void runHistogram(const HistogramOptions& options) {
    check(options);
    const glm::ivec2 size = chartSize(options.size);
    std::optional<Range> range;
    if (!options.range.empty()) {
        range = parseRange(options.range);
    }
    const auto volume = loadVolume(*options.volume).volume;
    const Range displayed = range ? *range : suggestedRange(volume);
    const Result result = options.kind == "2d" ? jointHistogram(volume, displayed, size, options.isLinear)
                          : options.kind == "gradient"
                              ? gradientHistogram(volume, size, options.isLinear)
                              : intensityHistogram(volume, displayed, size, options.isLinear);
    if (!options.csv.empty()) {
        writeFileAtomically(options.csv, result.csv);
    }
    image::writePng(options.output, result.picture);
    fmt::print("{}: {} histogram of {}, {} x {} pixels\n", options.output, options.kind, volume.name, size.x,
               size.y);
}

} // namespace

void addHistogramCommand(CLI::App& app) {
    auto* command = app.add_subcommand("histogram", "Draw how often values occur in a volume, as PNG");
    auto options = std::make_shared<HistogramOptions>();
    options->volume = addVolumeArgument(*command);
    command->add_option("-o,--output", options->output, "Picture to write (PNG)")->required();
    command->add_option("--kind", options->kind, "intensity, gradient (magnitude) or 2d (both)")
        ->check(CLI::IsMember({"intensity", "gradient", "2d"}))
        ->capture_default_str();
    command->add_option("--range", options->range,
                        "Displayed range LO:HI to mark; suggested from the histogram if not given");
    command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--csv", options->csv, "Write the counts as a table too (CSV)");
    command->add_flag("--linear,!--log", options->isLinear,
                      "Linear counts; logarithmic (--log) if not given");
    command->callback([options] { runHistogram(*options); });
}

} // namespace vs::cli
