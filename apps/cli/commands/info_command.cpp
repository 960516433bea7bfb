// SPDX-License-Identifier: Apache-2.0
// vstudio info: what a volume is, for people and as JSON.
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/value_counts.h"

#include "volume/grid/histogram.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace vs::cli {
namespace {

using volume::ReadResult;
using volume::Volume;

constexpr int bins = 256;
constexpr std::array<int, 7> percents{1, 5, 25, 50, 75, 95, 99};

struct Summary {
    std::vector<std::uint64_t> counts;
    std::array<double, percents.size()> percentiles{};
    double commonest = 0;  // middle of the fullest bin
    double foreground = 0; // Otsu's threshold between background and foreground
};

// One bin for each value where integers are few enough, else as many bins as still tell percentiles well.
std::vector<std::uint64_t> fineCounts(const Volume& volume) {
    return hasFewValues(volume) ? countsPerValue(volume) : volume::histogram(volume, 65536);
}

// The value that the given part of all finite voxels does not exceed.
double percentile(const Range& range, const std::vector<std::uint64_t>& counts, double part) {
    const double total = double(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)));
    double below = 0;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        below += double(counts[bin]);
        if (counts[bin] > 0 && below >= part * total) {
            const double place = counts.size() > 1 ? double(bin) / double(counts.size() - 1) : 0.0;
            return range.lo + range.width() * place;
        }
    }
    return range.hi;
}

Summary summarise(const Volume& volume) {
    Summary summary;
    summary.counts = volume::histogram(volume, bins);
    const auto fine = fineCounts(volume);
    const Range& range = hasFewValues(volume) ? volume.range : volume.usual; // of the fine counts
    for (std::size_t i = 0; i < percents.size(); ++i) {
        summary.percentiles[i] = percentile(range, fine, percents[i] / 100.0);
    }
    const auto fullest = std::max_element(fine.begin(), fine.end()) - fine.begin();
    summary.commonest =
        range.lo + (fine.size() > 1 ? range.width() * double(fullest) / double(fine.size() - 1) : 0.0);
    summary.foreground = volume::otsuThreshold(summary.counts, volume.usual);
    if (volume.type != volume::ScalarType::Float32) {
        summary.foreground = std::ceil(summary.foreground);
    }
    return summary;
}

// 64 blocks of logarithmic height: rare values matter as much as the background that outnumbers them.
std::string sparkline(const std::vector<std::uint64_t>& counts) {
    constexpr std::array<const char*, 9> blocks{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr std::size_t columns = 64;
    std::array<double, columns> heights{};
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        heights[bin * columns / counts.size()] += double(counts[bin]);
    }
    const double highest = std::log1p(*std::max_element(heights.begin(), heights.end()));
    std::string line;
    for (const double height : heights) {
        const double part = highest > 0 ? std::log1p(height) / highest : 0.0;
        line += blocks[std::size_t(std::ceil(part * 8))];
    }
    return line;
}

std::string humanBytes(std::size_t bytes) {
    const double mebibytes = double(bytes) / (1024.0 * 1024.0);
    return mebibytes < 1 ? fmt::format("{:.1f} KiB", mebibytes * 1024) : fmt::format("{:.1f} MiB", mebibytes);
}

void printText(const Volume& volume) {
    const auto& geometry = volume.geometry;
    const auto& m = geometry.worldFromVoxel;
    const auto s = geometry.spacing();
    const Summary summary = summarise(volume);
    fmt::print("file         {}\n", volume.path.string());
    fmt::print("size         {} x {} x {} voxels, {}, {}\n", geometry.dims.x, geometry.dims.y,
               geometry.dims.z, name(volume.type), humanBytes(volume.bytes.size()));
    fmt::print("spacing      {:.6g} x {:.6g} x {:.6g} mm\n", s.x, s.y, s.z);
    fmt::print("orientation  {}\n", geometry.orientationCode());
    for (int row = 0; row < 3; ++row) {
        fmt::print("{}[{:9.6f} {:9.6f} {:9.6f}]\n", row == 0 ? "direction    " : "             ",
                   m[0][row] / s.x, m[1][row] / s.y, m[2][row] / s.z);
    }
    fmt::print("origin       {:.6g}, {:.6g}, {:.6g} mm (LPS)\n", m[3][0], m[3][1], m[3][2]);
    fmt::print("values       {:.6g} to {:.6g}", volume.range.lo, volume.range.hi);
    fmt::print("{}\n",
               volume.nonFiniteCount > 0 ? fmt::format(", {} not finite", volume.nonFiniteCount) : "");
    fmt::print("percentiles ");
    for (std::size_t i = 0; i < percents.size(); ++i) {
        fmt::print(" {}%: {:.6g}{}", percents[i], summary.percentiles[i],
                   i + 1 < percents.size() ? "," : "\n");
    }
    fmt::print("commonest    {:.6g}\n", summary.commonest);
    fmt::print("histogram    |{}|\n", sparkline(summary.counts));
    fmt::print("suggested    {:.6g} to {:.6g} (shown range: foreground by Otsu's threshold)\n",
               summary.foreground, volume.usual.hi);
}

nlohmann::json toJson(const ReadResult& result) {
    const Volume& volume = result.volume;
    const auto& m = volume.geometry.worldFromVoxel;
    const auto s = volume.geometry.spacing();
    const auto d = volume.geometry.dims;
    const Summary summary = summarise(volume);
    nlohmann::json direction = nlohmann::json::array();
    nlohmann::json affine = nlohmann::json::array();
    for (int row = 0; row < 4; ++row) {
        affine.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
        if (row < 3) {
            direction.push_back({m[0][row] / s.x, m[1][row] / s.y, m[2][row] / s.z});
        }
    }
    nlohmann::json percentiles;
    for (std::size_t i = 0; i < percents.size(); ++i) {
        percentiles[std::to_string(percents[i])] = summary.percentiles[i];
    }
    return {{"path", volume.path.string()},
            {"name", volume.name},
            {"dims", {d.x, d.y, d.z}},
            {"type", name(volume.type)},
            {"spacing", {s.x, s.y, s.z}},
            {"origin", {m[3][0], m[3][1], m[3][2]}},
            {"direction", direction},
            {"orientation", volume.geometry.orientationCode()},
            {"worldFromVoxel", affine},
            {"range", {volume.range.lo, volume.range.hi}},
            {"suggestedRange", {summary.foreground, volume.usual.hi}},
            {"nonFinite", volume.nonFiniteCount},
            {"voxels", volume.geometry.voxelCount()},
            {"bytes", volume.bytes.size()},
            {"histogram",
             {{"bins", bins},
              {"lo", volume.usual.lo},
              {"hi", volume.usual.hi},
              {"counts", summary.counts},
              {"percentiles", percentiles}}},
            {"notices", result.notices}};
}

} // namespace

void addInfoCommand(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Says what a volume is: size, type, place, values");
    const auto argument = addVolumeArgument(*command);
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON instead of text");
    command->callback([argument, json] {
        const auto result = loadVolume(*argument);
        if (*json) {
            // File names need not be UTF-8, JSON must be.
            fmt::print("{}\n", toJson(result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
        } else {
            printText(result.volume);
        }
    });
}

} // namespace vs::cli
