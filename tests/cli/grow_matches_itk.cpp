// SPDX-License-Identifier: Apache-2.0
// Runs the real `vstudio grow` and compares what it writes: labels with ITK's filter, generations with a
// plain queue, geometry with the input's; and the exit codes of calls that make no sense. grow_matches_itk
// VSTUDIO FOLDER
#include "gpu/segment/itk_growing.h"
#include "phantom/phantom.h"
#include "reference/growth.h"
#include "volume/io/write.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vs;
namespace fs = std::filesystem;

int failures = 0;

void expect(bool holds, const std::string& what) {
    if (!holds) {
        fmt::print("FAILED: {}\n", what);
        ++failures;
    }
}

struct Case {
    fs::path volume;
    std::vector<glm::ivec3> seeds;
    Range range;
    bool cornersTouch = false;
    int steps = -1;
};

class Runner {
public:
    Runner(std::string vstudio, fs::path folder) : vstudio_(std::move(vstudio)), folder_(std::move(folder)) {}

    // Exit code of `vstudio ARGUMENTS`.
    [[nodiscard]] int run(const std::string& arguments) const {
        const int status = std::system(fmt::format("'{}' {}", vstudio_, arguments).c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    void check(const Case& test) const {
        const fs::path labels = folder_ / "grow_labels.nii.gz";
        const fs::path generations = folder_ / "grow_generations.nii.gz";
        std::string call = fmt::format("grow '{}' --range={}:{} --connectivity {} -o '{}' --generations '{}'",
                                       test.volume.string(), test.range.lo, test.range.hi,
                                       test.cornersTouch ? 26 : 6, labels.string(), generations.string());
        for (const glm::ivec3 seed : test.seeds) {
            call += fmt::format(" --seed {},{},{}", seed.x, seed.y, seed.z);
        }
        call += test.steps >= 0 ? fmt::format(" --steps {}", test.steps) : "";
        fmt::print("{}\n", call);
        std::fflush(stdout);
        expect(run(call) == 0, "exit code of " + call);
        const auto input = volume::readVolume(test.volume).volume;
        compare(test, input, volume::readVolume(labels).volume, volume::readVolume(generations).volume);
    }

private:
    static void compare(const Case& test, const volume::Volume& input, const volume::Volume& labels,
                        const volume::Volume& generations) {
        const glm::ivec3 dims = input.geometry.dims;
        expect(labels.type == volume::ScalarType::UInt8, "labels are uint8");
        expect(generations.type == volume::ScalarType::UInt32, "generations are uint32");
        for (const auto* written : {&labels, &generations}) {
            expect(written->geometry.dims == dims, "size of what was written");
            double worst = 0;
            for (int column = 0; column < 4; ++column) {
                const glm::dvec4 d = glm::abs(written->geometry.worldFromVoxel[column] -
                                              input.geometry.worldFromVoxel[column]);
                worst = std::max({worst, d.x, d.y, d.z});
            }
            // NIfTI holds the place in single precision.
            expect(worst < 1e-3, fmt::format("place of what was written, off by {}", worst));
        }
        reference::QueueGrowth queue(dims);
        queue.setRules([&](glm::ivec3 v) { return test.range.contains(input.at(v)); }, test.cornersTouch);
        queue.addSeeds(test.seeds);
        queue.advance(test.steps < 0 ? std::numeric_limits<int>::max() : test.steps);
        const auto* written = reinterpret_cast<const std::uint32_t*>(generations.bytes.data());
        const auto* mask = reinterpret_cast<const std::uint8_t*>(labels.bytes.data());
        std::vector<std::uint8_t> itk;
        if (test.steps < 0) {
            itk = test::growWithItk(input, test.seeds, test.range, test.cornersTouch);
        }
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < queue.generations().size(); ++i) {
            const std::uint32_t generation = queue.generations()[i];
            const bool isWrong = written[i] != generation || mask[i] != (generation != 0 ? 1 : 0) ||
                                 (!itk.empty() && itk[i] != mask[i]);
            wrong += isWrong ? 1 : 0;
        }
        expect(wrong == 0, fmt::format("{} voxels differ", wrong));
    }

    std::string vstudio_;
    fs::path folder_;
};

void checkRefusals(const Runner& runner, const fs::path& volume, const fs::path& folder) {
    const std::string begin =
        fmt::format("grow '{}' -o '{}' ", volume.string(), (folder / "grow_none.nii.gz").string());
    const auto expectCode = [&](int code, const std::string& arguments) {
        const int actual = runner.run(begin + arguments);
        expect(actual == code, fmt::format("exit code of {}: {}, not {}", arguments, actual, code));
    };
    expectCode(2, "--seed 1,2 --range 10:20");
    expectCode(2, "--seed 1,2,x --range 10:20");
    expectCode(2, "--seed 1,2,3.5 --range 10:20");
    expectCode(2, "--seed 1,2,3 --range 20:10");
    expectCode(2, "--seed 1,2,3 --range 20");
    expectCode(2, "--seed 1,2,3 --range 10:20 --connectivity 18");
    expectCode(2, "--seed 1,2,3 --range 10:20 --steps -1");
    expectCode(2, "--range 10:20");
    expectCode(1, "--seed 1,2,1000 --range -200:300");
    expectCode(1, "--seed -1,2,3 --range -200:300");
    expectCode(1, "--seed 1,2,3 --range=-900:-800");
    expect(!fs::exists(folder / "grow_none.nii.gz"), "a refused call writes nothing");
}

int runAll(const std::string& vstudio, const fs::path& folder) {
    const Runner runner(vstudio, folder);
    std::mt19937 random(7);
    const auto phantom =
        phantom::makePhantom({61, 43, 38}, volume::ScalarType::UInt8,
                             [&](glm::dvec3) { return double(random() % 100); }, {0.7, 0.7, 1.5});
    const fs::path path = folder / "grow_input.nii.gz";
    volume::writeGrid(
        path, phantom.geometry,
        std::span(reinterpret_cast<const std::uint8_t*>(phantom.bytes.data()), phantom.bytes.size()));
    const std::vector<glm::ivec3> seeds{{30, 20, 20}, {31, 20, 20}, {3, 4, 5}, {55, 40, 30}, {30, 21, 20}};
    runner.check({path, seeds, {0, 60}, false, -1});
    runner.check({path, seeds, {0, 60}, true, -1});
    runner.check({path, seeds, {0, 60}, false, 0});
    runner.check({path, seeds, {0, 60}, false, 7});
    const fs::path brain = "/usr/share/mricron/templates/ch2.nii.gz";
    if (fs::exists(brain)) {
        runner.check({brain, {{90, 108, 90}, {60, 100, 90}, {120, 120, 80}}, {70, 130}, false, -1});
        runner.check({brain, {{90, 108, 90}, {60, 100, 90}, {120, 120, 80}}, {70, 130}, true, -1});
    } else {
        fmt::print("{} is not installed: left out\n", brain.string());
    }
    checkRefusals(runner, path, folder);
    return failures == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print("usage: grow_matches_itk VSTUDIO FOLDER\n");
        return 2;
    }
    try {
        return runAll(argv[1], argv[2]);
    } catch (const std::exception& error) {
        fmt::print("FAILED: {}\n", error.what());
        return 1;
    }
}
