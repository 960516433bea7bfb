// SPDX-License-Identifier: Apache-2.0
// load_bench: how long scans take to read, beside ITK reading them in turns. As in the window a decoder waits
// when a scan is read, and there is time to start the next one before another scan is.
#include "base/error.h"
#include "base/large_pages.h"
#include "base/statistics.h"
#include "base/timer.h"
#include "load_with_itk.h"
#include "volume/reading/decoder_at_hand.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace vs {

namespace {

// In which a decoder starts many times over.
constexpr std::chrono::milliseconds kPause{200};

struct Times {
    double first = 0; // ours where no decoder waits
    std::vector<double> ours;
    std::vector<double> itk;
    std::size_t voxels = 0;
};

// Sees to it that there is memory for all that is about to be read: what the host of a virtual machine has
// taken back from it comes again many times slower than what the system has at hand, which would fall on
// whoever comes first.
void touchMemory(std::size_t voxels) {
    constexpr std::size_t most = 16; // bytes for each voxel
    std::vector<std::byte> bytes;
    reserveInLargePages(bytes, most * voxels);
    bytes.resize(most * voxels);
}

double millisecondsToRead(const std::string& path, std::size_t& voxels) {
    const Timer timer;
    const auto volume = volume::readVolume(path).volume;
    const double taken = timer.milliseconds();
    voxels = volume.geometry.voxelCount();
    return taken;
}

// One run that does not count comes first, so that the file lies in memory.
Times measure(const std::string& path, int runs) {
    Times times;
    millisecondsToRead(path, times.voxels);
    touchMemory(times.voxels);
    times.first = millisecondsToRead(path, times.voxels);
    const volume::DecoderAtHand decoder;
    for (int run = 0; run < runs; ++run) {
        std::this_thread::sleep_for(kPause);
        touchMemory(times.voxels);
        const double ours = millisecondsToRead(path, times.voxels);
        std::this_thread::sleep_for(kPause);
        touchMemory(times.voxels);
        const ItkLoad itk = loadWithItk(path);
        if (itk.voxels != times.voxels) {
            throw Error("{}: {} voxels read here and {} by ITK; they should be the same", path, times.voxels,
                        itk.voxels);
        }
        times.ours.push_back(ours);
        times.itk.push_back(itk.milliseconds);
    }
    return times;
}

void report(const std::string& path, const Times& times) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times.ours.size(); ++i) {
        ratios.push_back(times.ours[i] / times.itk[i]);
    }
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n", path.substr(path.find_last_of('/') + 1),
               times.voxels, times.first, median(times.ours), median(times.itk), median(ratios));
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
    fmt::print("| scan | voxels | ours, no decoder waits (ms) | ours (ms) | ITK (ms) | ours / ITK |\n"
               "|---|---|---|---|---|---|\n");
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
