// SPDX-License-Identifier: Apache-2.0
// load_bench: how long scans take to read, beside ITK reading them in turns.
#include "base/error.h"
#include "base/statistics.h"
#include "base/timer.h"
#include "load_with_itk.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>
#include <vector>

namespace vs {

namespace {

struct Times {
    std::vector<double> ours;
    std::vector<double> itk;
    std::size_t voxels = 0;
};

// One run that does not count comes first, so that the file lies in memory.
Times measure(const std::string& path, int runs) {
    Times times;
    for (int run = 0; run <= runs; ++run) {
        const Timer timer;
        const auto volume = volume::readVolume(path).volume;
        const double ours = timer.milliseconds();
        const ItkLoad itk = loadWithItk(path);
        times.voxels = volume.geometry.voxelCount();
        if (itk.voxels != times.voxels) {
            throw Error("{}: {} voxels read here and {} by ITK; they should be the same", path, times.voxels,
                        itk.voxels);
        }
        if (run > 0) {
            times.ours.push_back(ours);
            times.itk.push_back(itk.milliseconds);
        }
    }
    return times;
}

void report(const std::string& path, const Times& times) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times.ours.size(); ++i) {
        ratios.push_back(times.ours[i] / times.itk[i]);
    }
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.2f} |\n", path.substr(path.find_last_of('/') + 1),
               times.voxels, median(times.ours), median(times.itk), median(ratios));
    std::fflush(stdout);
}

int run(std::vector<std::string> arguments) {
    int runs = 5;
    if (arguments.size() >= 2 && arguments[0] == "--runs") {
        const std::string& count = arguments[1];
        const auto read = std::from_chars(count.data(), count.data() + count.size(), runs);
        if (read.ec != std::errc() || runs < 1) {
            throw Error("--runs {}: must be a whole number above 0", count);
        }
        arguments.erase(arguments.begin(), arguments.begin() + 2);
    }
    if (arguments.empty()) {
        throw Error("usage: load_bench [--runs N] SCAN...; a DICOM series is its folder");
    }
    fmt::print("| scan | voxels | ours (ms) | ITK (ms) | ours / ITK |\n|---|---|---|---|---|\n");
    for (const std::string& path : arguments) {
        report(path, measure(path, runs));
    }
    return 0;
}

} // namespace

} // namespace vs

int main(int argc, char** argv) {
    try {
        return vs::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
