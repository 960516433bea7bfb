// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_measure.h"

#include "base/statistics.h"
#include "base/timer.h"
#include "gl/context.h"

#include <algorithm>

namespace vs::cli {

namespace {

constexpr int kPassRuns = 5;

using PassTable = std::map<std::string, gl::PassTimes>;

double runOnce(const Work& work, int run) {
    if (work.prepare) {
        work.prepare(run);
    }
    gl::Context::finish();
    const Timer timer;
    work.run(run);
    gl::Context::finish();
    return timer.milliseconds();
}

PassTable passesOf(const Work& work, int run) {
    if (work.prepare) {
        work.prepare(run);
    }
    gl::Pass::resetTimes();
    gl::Pass::enableTiming(true);
    work.run(run);
    gl::Pass::enableTiming(false);
    return gl::Pass::times();
}

// A pass that a run does without counts as nothing there.
PassTable medians(const std::vector<PassTable>& runs) {
    PassTable result;
    for (const auto& run : runs) {
        result.insert(run.begin(), run.end());
    }
    for (auto& [name, times] : result) {
        std::vector<double> wall;
        std::vector<double> device;
        std::vector<double> counts;
        for (const auto& run : runs) {
            const auto found = run.find(name);
            const gl::PassTimes here = found == run.end() ? gl::PassTimes{} : found->second;
            wall.push_back(here.milliseconds);
            device.push_back(here.deviceMilliseconds);
            counts.push_back(here.count);
        }
        times = {median(wall), median(device), int(median(counts))};
    }
    return result;
}

} // namespace

double Measurement::medianMilliseconds() const { return median(milliseconds); }

double Measurement::deviceMilliseconds() const {
    double sum = 0;
    for (const auto& [pass, times] : passes) {
        sum += times.deviceMilliseconds;
    }
    return sum;
}

Measurement measure(const std::string& kind, const std::string& name, int runs, const Work& work) {
    Measurement result{kind, name, {}, {}};
    runOnce(work, 0);
    for (int run = 0; run < runs; ++run) {
        result.milliseconds.push_back(runOnce(work, run));
    }
    if (work.usesDevice) {
        std::vector<PassTable> tables;
        for (int run = 0; run < std::min(runs, kPassRuns); ++run) {
            tables.push_back(passesOf(work, run));
        }
        result.passes = medians(tables);
    }
    return result;
}

} // namespace vs::cli
