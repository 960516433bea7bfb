// SPDX-License-Identifier: Apache-2.0
// grow_bench: how quickly regions grow, beside ITK's filter and a plain scanline fill in the same run.
#include "base/atomic_file.h"
#include "base/error.h"
#include "gl/context.h"
#include "growing_report.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace vs {

namespace {

constexpr int kMoves = 30;

struct GrowBenchOptions {
    std::vector<std::string> parts{"brain", "air", "scaling", "thin", "change", "scrub"};
    std::string brain = "/usr/share/mricron/templates/ch2better.nii.gz";
    int runs = 5;
    int side = 512;
    double largest = 1e8;
    std::string json;
    std::string where;

    [[nodiscard]] segment::GrowthEngine engine() const {
        return where == "host"     ? segment::GrowthEngine::Host
               : where == "device" ? segment::GrowthEngine::Device
                                   : segment::quickerEngine();
    }
    [[nodiscard]] bool wants(const std::string& part) const {
        return std::find(parts.begin(), parts.end(), part) != parts.end();
    }
};

// Says so when the file is not there.
std::optional<GrowingCase> brainOrWord(const GrowBenchOptions& options) {
    auto brain = brainCase(options.brain);
    if (!brain) {
        fmt::print(stderr, "{}: is not there, the brain is left out; --brain names another copy\n",
                   options.brain);
    }
    return brain;
}

void measureAll(const GrowBenchOptions& options, GrowingReport& report) {
    if (const auto brain = options.wants("brain") ? brainOrWord(options) : std::nullopt) {
        report.add("brain", compareWithOthers(*brain, options.engine(), options.runs));
    }
    if (options.wants("air")) {
        report.add("air", compareWithOthers(airCase(options.side), options.engine(), options.runs));
    }
    if (options.wants("scaling")) {
        for (double voxels = 1e5; voxels <= options.largest; voxels *= 10) {
            report.add("scaling", compareWithOthers(compactCase(std::uint64_t(voxels), false),
                                                    options.engine(), options.runs));
        }
    }
    if (options.wants("thin")) {
        for (const int voxels : {10000, 30000, 100000}) {
            report.add("thin", compareWithOthers(thinCase(voxels), options.engine(), options.runs));
        }
    }
    constexpr std::uint64_t kMiddling = 10000000;
    if (options.wants("change")) {
        if (const auto brain = brainOrWord(options)) {
            report.add(measureChange(*brain, options.engine(), options.runs));
        }
        report.add(measureChange(compactCase(kMiddling, true), options.engine(), options.runs));
    }
    if (options.wants("scrub")) {
        if (const auto brain = brainOrWord(options)) {
            report.add(measureScrubbing(*brain, options.engine(), kMoves));
        }
        report.add(measureScrubbing(compactCase(kMiddling, false), options.engine(), kMoves));
    }
}

int run(int argc, char** argv) {
    GrowBenchOptions options;
    CLI::App app("Times region growing here, by ITK and by scanlines, in turns.", "grow_bench");
    app.add_option("--parts", options.parts, "What to measure, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember({"brain", "air", "scaling", "thin", "change", "scrub"}))
        ->capture_default_str();
    app.add_option("--brain", options.brain, "ch2better.nii.gz of Debian's mricron-data")
        ->capture_default_str();
    app.add_option("--runs", options.runs, "Runs that count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--side", options.side, "Voxels along the body phantom's side")
        ->check(CLI::Range(16, 1024))
        ->capture_default_str();
    app.add_option("--largest", options.largest, "Voxels of the largest region of the scaling series")
        ->capture_default_str();
    app.add_option("--engine", options.where, "Where to grow; without it, where it is quicker")
        ->check(CLI::IsMember({"host", "device"}));
    app.add_option("--json", options.json, "File for every single time");
    CLI11_PARSE(app, argc, argv);
    const auto context = gl::Context::createHeadless();
    GrowingReport report(context.device().renderer);
    measureAll(options, report);
    context.requireNoErrors();
    if (!options.json.empty()) {
        writeFileAtomically(options.json, report.json());
    }
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
