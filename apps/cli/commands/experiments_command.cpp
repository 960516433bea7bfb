// SPDX-License-Identifier: Apache-2.0
// vstudio experiments: ten experiments (thesis, section 6) as sessions, replayed into pictures, a table and a
// page.
#include "arguments/parse.h"
#include "commands/commands.h"
#include "experiments/page.h"
#include "reports/progress.h"

#include "base/error.h"
#include "base/log.h"
#include "base/timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace vs::cli {

namespace {

struct ExperimentsOptions {
    std::string output;
    std::vector<std::string> names; // of experiments or sessions; empty: all
    std::vector<std::string> data;
    std::optional<int> width;
    bool isList = false;
};

bool isAsked(const ExperimentsOptions& options, const std::string& name) {
    return std::find(options.names.begin(), options.names.end(), name) != options.names.end();
}

// The cases that were asked for, by the name of their experiment or their own.
std::vector<PlayedExperiment> chosen(const ExperimentsOptions& options) {
    std::vector<std::string> known;
    std::vector<PlayedExperiment> result;
    for (const studio::Experiment& experiment : studio::caseIndex().experiments) {
        PlayedExperiment played{&experiment, {}};
        known.push_back(experiment.name);
        for (const studio::Case& one : experiment.cases) {
            known.push_back(one.session);
            if (options.names.empty() || isAsked(options, experiment.name) || isAsked(options, one.session)) {
                played.cases.emplace_back().which = &one;
            }
        }
        if (!played.cases.empty()) {
            result.push_back(std::move(played));
        }
    }
    for (const std::string& name : options.names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw UsageError("there is no experiment '{}'; vstudio experiments --list says which there are",
                             name);
        }
    }
    return result;
}

void list(const std::vector<PlayedExperiment>& experiments) {
    for (const PlayedExperiment& experiment : experiments) {
        fmt::print("{:<10} {} (figure {})\n", experiment.which->name, experiment.which->title,
                   experiment.which->figure);
        for (const PlayedCase& one : experiment.cases) {
            const studio::Session session = studio::sessionOf(*one.which);
            const studio::CaseScan* scan = studio::scanOf(session);
            fmt::print("           {:<28} {}\n", one.which->session,
                       scan != nullptr ? scan->file + ", from " + scan->from : "made by the program");
        }
    }
}

std::string lineOf(const PlayedCase& played) {
    if (played.isMissing) {
        return fmt::format("{}: skipped, {} is not there; it is from {}", played.which->session,
                           played.scan != nullptr ? played.scan->file : std::string("its scan"),
                           played.scan != nullptr ? played.scan->from : std::string("elsewhere"));
    }
    if (!played.error.empty()) {
        return fmt::format("{}: failed: {}", played.which->session, played.error);
    }
    std::string dice;
    for (const auto& [segment, value] : played.figures.dice) {
        dice += fmt::format("{} {} {:.3f}", dice.empty() ? ", Dice" : ",", segment, value);
    }
    return fmt::format("{}: {} pictures in {:.1f} s{}", played.which->session, played.pictureCount(),
                       played.figures.seconds, dice);
}

void run(const ExperimentsOptions& options) {
    auto experiments = chosen(options);
    if (options.isList) {
        list(experiments);
        return;
    }
    if (options.output.empty()) {
        throw UsageError("-o is missing: a folder for the pictures and the page; or --list");
    }
    const Timer timer;
    PlayOptions play{options.output, {options.data.begin(), options.data.end()}, options.width};
    std::filesystem::create_directories(play.output);
    const auto context = gl::Context::createHeadless();
    std::size_t pictures = 0;
    std::size_t failures = 0;
    std::size_t missing = 0;
    for (PlayedExperiment& experiment : experiments) {
        for (PlayedCase& one : experiment.cases) {
            const Activity activity("playing " + one.which->session);
            one = playCase(*one.which, play, context);
            pictures += one.isDone() ? one.pictureCount() : 0;
            failures += one.error.empty() ? 0 : 1;
            missing += one.isMissing ? 1 : 0;
            fmt::print("{}\n", lineOf(one));
        }
    }
    const auto page = play.output / "index.html";
    writePage(page, experiments, context.device().renderer);
    writeFigures(play.output / "figures.csv", experiments);
    fmt::print("{} pictures, {} cases without their scan, in {:.0f} s; see {}\n", pictures, missing,
               timer.milliseconds() / 1000, page.string());
    if (failures > 0) {
        throw Error("{} of the cases failed; {} tells why", failures, page.string());
    }
}

} // namespace

void addExperimentsCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "experiments", "Replay the experiments of the thesis into pictures, a table of figures and a page");
    const auto options = std::make_shared<ExperimentsOptions>();
    command->add_option("NAMES", options->names, "Only these experiments, or sessions; see --list");
    command->add_option("-o,--output", options->output,
                        "Folder for the pictures, index.html and figures.csv");
    command->add_option("--data", options->data, "A folder with scans; may be given several times")
        ->check(CLI::ExistingDirectory);
    command->add_option("--width", options->width, "Pictures so many pixels wide, instead of as they are")
        ->check(between(64, 4096));
    command->add_flag("--list", options->isList,
                      "Say which there are and what scans they need, and play none");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
