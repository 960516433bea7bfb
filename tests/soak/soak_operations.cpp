// SPDX-License-Identifier: Apache-2.0
// A hand that never tires: thousands of random operations on one document, without a window. Undone, the
// document is the one that it was, byte for byte; redone, the one that it became; and rounds of work that
// are taken back and forgotten leave no memory behind.
#include "gl/context.h"
#include "gpu/gl_test.h"
#include "soak/memory.h"
#include "soak/worn_document.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace vs::soak {

namespace {

struct Options {
    std::uint64_t seed = 1;
    int operations = 10000;
    int rounds = 12;
    int roundLength = 500;
};

constexpr double kMegabyte = 1024 * 1024;
constexpr int kRowEvery = 500;

void printHead() {
    fmt::print("{:>10} {:>8} {:>9} {:>8} {:>8} {:>9} {:>9} {:>9}\n", "operations", "refused", "resident",
               "heap", "undo", "of undo", "in file", "of log");
}

void printRow(const WornDocument& worn) {
    const Memory memory = Memory::now();
    const auto undo = worn.document().history().statistics();
    const std::size_t log = worn.logBytes();
    fmt::print("{:>10} {:>8} {:>6.1f} MB {:>5.1f} MB {:>8} {:>6.1f} MB {:>6.1f} MB {:>6.1f} MB\n",
               worn.tried(), worn.refused(), double(memory.resident) / kMegabyte,
               double(memory.heap) / kMegabyte, undo.steps, double(worn.historyBytes()) / kMegabyte,
               double(undo.fileBytes) / kMegabyte, double(log) / kMegabyte);
    std::fflush(stdout);
}

// One history of all operations, there and back again.
void wear(const Options& options) {
    WornDocument worn(options.seed);
    worn.begin();
    printHead();
    for (int n = 0; n < options.operations; ++n) {
        worn.step();
        if ((n + 1) % kRowEvery == 0) {
            printRow(worn);
        }
    }
    worn.requireAllTried();
    const std::size_t steps = worn.undoAll();
    worn.requireAsAtTheStart();
    fmt::print("{} steps undone: the document is the one that it was, byte for byte\n", steps);
    worn.redoAll();
    fmt::print("{} steps redone: the document is what it had become\n", steps);
    fmt::print(
        "saved and opened again {} times, undone and redone in between {} times, {} refusals compared\n",
        worn.savings(), worn.journeys(), worn.refusalsCompared());
}

// What is held after rounds of work that were undone and forgotten, beside the log, which sessions keep: by
// the document that was worked on, whose caches are those that the work happened to need, and by a new one in
// its place.
struct Held {
    Memory worn;
    Memory renewed;
};

Held afterRound(WornDocument& worn, int length) {
    for (int n = 0; n < length; ++n) {
        worn.step();
    }
    worn.undoAll();
    worn.requireAsAtTheStart();
    worn.forgetHistory();
    const std::size_t log = worn.logBytes();
    Held held{Memory::now(), {}};
    held.worn.heap -= log;
    held.worn.resident -= log;
    worn.renew();
    held.renewed = Memory::now();
    return held;
}

// What the second half of the rounds has more than the first, of what `of` says of each, by the least:
// drivers keep some textures until others are bound. The first round does not count: shaders and what is kept
// for good are made in it.
template <typename Of>
double rise(const std::vector<Held>& rounds, Of of) {
    const auto less = [&](const Held& a, const Held& b) { return of(a) < of(b); };
    const auto count = std::ptrdiff_t(rounds.size()) - 1;
    const auto leastOf = [&](std::ptrdiff_t part, std::ptrdiff_t parts) {
        const auto first = rounds.begin() + 1;
        return double(
            of(*std::min_element(first + count * part / parts, first + count * (part + 1) / parts, less)));
    };
    if (count < 6) {
        return leastOf(1, 2) - leastOf(0, 2);
    }
    // What is made once (a shader that the software renderer compiles late) rises in one third; what is not
    // given back goes on rising.
    constexpr double halvesOfThirds = 1.5;
    return halvesOfThirds * std::min(leastOf(1, 3) - leastOf(0, 3), leastOf(2, 3) - leastOf(1, 3));
}

// What it may be of new documents' heap: one texture of the head's size (0.7 MB) in a hundred operations that
// is not given back is more after four rounds of sixty.
constexpr double kMostLeft = 1.5 * kMegabyte;
// And of the resident memory, where freed pieces lie between others.
constexpr double kMostLeftResident = 16 * kMegabyte;

void goRound(const Options& options) {
    WornDocument worn(options.seed + 1);
    worn.begin();
    std::vector<Held> rounds;
    for (int round = 1; round <= options.rounds; ++round) {
        rounds.push_back(afterRound(worn, options.roundLength));
        const auto& [old, renewed] = rounds.back();
        fmt::print("round {:2} of {}: {:.1f} MB of heap ({:.1f} MB resident), a new document {:.1f} MB "
                   "({:.1f} MB)\n",
                   round, options.roundLength, double(old.heap) / kMegabyte, double(old.resident) / kMegabyte,
                   double(renewed.heap) / kMegabyte, double(renewed.resident) / kMegabyte);
        std::fflush(stdout);
    }
    if (rounds.size() < 3) {
        return;
    }
    const double heap = rise(rounds, [](const Held& held) { return held.renewed.heap; });
    const double resident = rise(rounds, [](const Held& held) { return held.renewed.resident; });
    const std::string said = fmt::format(
        "{} rounds that were taken back and forgotten: new documents of the second half have {:.1f} MB "
        "more heap and {:.1f} MB more resident than those of the first",
        rounds.size(), heap / kMegabyte, resident / kMegabyte);
    if (heap > kMostLeft || resident > kMostLeftResident) {
        throw Fault(fmt::format("{}; {:.1f} and {:.1f} are allowed", said, kMostLeft / kMegabyte,
                                kMostLeftResident / kMegabyte));
    }
    fmt::print("{}\n", said);
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Random operations on one document: undone byte for byte, and flat in memory.");
    app.add_option("--seed", options.seed);
    app.add_option("--operations", options.operations, "in one history");
    app.add_option("--rounds", options.rounds, "that are each taken back and forgotten");
    app.add_option("--round-length", options.roundLength, "operations of a round");
    CLI11_PARSE(app, argc, argv);
    std::optional<gl::Context> context;
    try {
        context = gl::Context::createHeadless();
    } catch (const Error& error) {
        fmt::print("skipped: {}\n", error.what());
        constexpr int kSkipped = 77; // for ctest
        return test::isDeviceRequired() ? 1 : kSkipped;
    }
    try {
        if (options.operations > 0) {
            wear(options);
        }
        goRound(options);
        context->requireNoErrors();
    } catch (const std::exception& error) {
        fmt::print("WRONG {}\n(seed {}, {} operations, rounds of {})\n", error.what(), options.seed,
                   options.operations, options.roundLength);
        return 1;
    }
    return 0;
}

} // namespace
} // namespace vs::soak

int main(int argc, char** argv) { return vs::soak::run(argc, argv); }
