// SPDX-License-Identifier: Apache-2.0
// stage_bench: how long single stages take, in turns with a loop that tells how fast the machine is just
// then. bench/compare_baseline runs it and judges.
#include "base/atomic_file.h"
#include "base/timer.h"
#include "gl/context.h"
#include "stages.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <numeric>
#include <thread>

namespace vs {

namespace {

using Json = nlohmann::ordered_json;

// A fixed amount of arithmetic on each processor, as software renderers work on all of them. Returns what
// came of it, so that it is not left out.
std::uint64_t calibrate() {
    std::vector<std::uint64_t> sums(std::max(1U, std::thread::hardware_concurrency()));
    std::iota(sums.begin(), sums.end(), 1); // each its own way
    std::vector<std::thread> threads;
    for (std::uint64_t& sum : sums) {
        threads.emplace_back([&sum] {
            std::uint64_t state = sum;
            for (int i = 0; i < 40'000'000; ++i) {
                state ^= state << 13U;
                state ^= state >> 7U;
                state ^= state << 17U;
            }
            sum = state;
        });
    }
    std::uint64_t all = 0;
    for (std::size_t n = 0; n < threads.size(); ++n) {
        threads[n].join();
        all ^= sums[n];
    }
    return all;
}

// The mean of as many runs as fill a tenth of a second: about as long as the calibration, so that what else
// the machine does meets both alike.
double millisecondsOf(const std::function<void()>& work) {
    gl::Context::finish();
    const Timer timer;
    int runs = 0;
    do {
        work();
        gl::Context::finish();
        ++runs;
    } while (timer.milliseconds() < 100);
    return timer.milliseconds() / runs;
}

// Every stage once a round, each right after the calibration that it is compared with.
Json measure(int rounds) {
    std::vector<BenchStage> stages;
    for (auto* make : {&countingStages, &lookingStages, &sculptingStages}) {
        for (BenchStage& stage : make()) {
            stages.push_back(std::move(stage));
        }
    }
    Json times = Json::object();
    std::uint64_t sum = 0;
    for (int round = -1; round < rounds; ++round) { // the first one compiles what is compiled when needed
        for (const BenchStage& stage : stages) {
            const double calibration = millisecondsOf([&sum] { sum ^= calibrate(); });
            const double taken = millisecondsOf(stage.run);
            if (round >= 0) {
                times[stage.name]["milliseconds"].push_back(taken);
                times[stage.name]["calibration"].push_back(calibration);
            }
        }
    }
    return {{"calibrationResult", sum}, {"stages", times}};
}

int run(int argc, char** argv) {
    int rounds = 9;
    std::string json;
    CLI::App app("Times single stages, in turns with a loop that tells how fast the machine is.",
                 "stage_bench");
    app.add_option("--rounds", rounds, "Rounds that count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--json", json, "File for every single time")->required();
    CLI11_PARSE(app, argc, argv);
    const auto context = gl::Context::createHeadless();
    Json report = measure(rounds);
    report["device"] = context.device().renderer;
    report["processors"] = std::thread::hardware_concurrency();
    context.requireNoErrors();
    writeFileAtomically(json, report.dump(1));
    return 0;
}

} // namespace

} // namespace vs

int main(int argc, char** argv) {
    try {
        return vs::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
