// SPDX-License-Identifier: Apache-2.0
#include "growing_report.h"

#include "base/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace vs {

namespace {

// "12.3 ± 4 %": the median and half the span from the least to the largest.
std::string spread(const std::vector<double>& times) {
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    const double middle = median(times);
    return fmt::format("{:.2f} ± {:.0f} %", middle, 50 * (*most - *least) / middle);
}

// Of runs that took turns, the median of the ratios within a turn.
double medianRatio(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < above.size(); ++i) {
        ratios.push_back(above[i] / below[i]);
    }
    return median(ratios);
}

} // namespace

GrowingReport::GrowingReport(const std::string& device) {
    json_["device"] = device;
    json_["rows"] = nlohmann::ordered_json::array();
    fmt::print("{}; medians ± half the span; ratios are medians over runs that took turns\n", device);
}

void GrowingReport::begin(const std::string& table, const std::string& header) {
    if (table_ != table) {
        table_ = table;
        const auto columns = std::count(header.begin(), header.end(), '|') - 1;
        std::string rule = "|";
        for (std::ptrdiff_t i = 0; i < columns; ++i) {
            rule += "---|";
        }
        fmt::print("\n{}\n{}\n", header, rule);
    }
}

void GrowingReport::add(const std::string& part, const Comparison& c) {
    begin(
        "compare",
        "| region | voxels | generations | ours (ms) | ITK (ms) | scanlines (ms) | ITK / ours | scanlines / "
        "ours | ours (Mvoxel/s) | scanlines (Mvoxel/s) | ours (µs a generation) | reset (ms) | set-up (ms) "
        "|");
    const double ours = median(c.ours);
    const double ratio = medianRatio(c.itk, c.ours);
    const double toScanlines = medianRatio(c.scanlines, c.ours);
    fmt::print(
        "| {} | {} | {} | {} | {} | {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.2f} | {:.1f} | {:.0f} |\n",
        c.name, c.voxels, c.generations, spread(c.ours), spread(c.itk), spread(c.scanlines), ratio,
        toScanlines, 1e-3 * double(c.voxels) / ours, 1e-3 * double(c.voxels) / median(c.scanlines),
        1e3 * ours / c.generations, median(c.resets), c.setUp);
    std::fflush(stdout);
    json_["rows"].push_back({{"part", part},
                             {"region", c.name},
                             {"voxels", c.voxels},
                             {"generations", c.generations},
                             {"setUpMs", c.setUp},
                             {"oursMs", c.ours},
                             {"resetMs", c.resets},
                             {"itkMs", c.itk},
                             {"scanlinesMs", c.scanlines},
                             {"scanlinesOverOurs", toScanlines},
                             {"itkOverOurs", ratio}});
}

void GrowingReport::add(const ChangeCost& c) {
    begin("change", "| region | range | wider | voxels | more | fresh (ms) | change (ms) | change / fresh |");
    const double ratio = medianRatio(c.change, c.fresh);
    fmt::print("| {} | {}:{} | {}:{} | {} | {:.2f} % | {} | {} | {:.3f} |\n", c.name, c.range.lo, c.range.hi,
               c.wider.lo, c.wider.hi, c.voxels, 100 * double(c.more) / double(c.voxels), spread(c.fresh),
               spread(c.change), ratio);
    std::fflush(stdout);
    json_["rows"].push_back({{"part", "change"},
                             {"region", c.name},
                             {"range", {c.range.lo, c.range.hi}},
                             {"wider", {c.wider.lo, c.wider.hi}},
                             {"voxels", c.voxels},
                             {"moreVoxels", c.more},
                             {"freshMs", c.fresh},
                             {"changeMs", c.change},
                             {"changeOverFresh", ratio}});
}

void GrowingReport::add(const ScrubCost& c) {
    begin("scrub", "| region | voxels | generations | moves | median (ms) | largest (ms) |");
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} |\n", c.name, c.voxels, c.generations, c.moves.size(),
               median(c.moves), *std::max_element(c.moves.begin(), c.moves.end()));
    std::fflush(stdout);
    json_["rows"].push_back({{"part", "scrub"},
                             {"region", c.name},
                             {"voxels", c.voxels},
                             {"generations", c.generations},
                             {"movesMs", c.moves}});
}

} // namespace vs
