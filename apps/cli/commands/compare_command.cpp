// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"
#include "commands/commands.h"

#include "base/error.h"
#include "image/compare.h"
#include "volume/reading/read_picture.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace vs::cli {

namespace {

struct CompareOptions {
    std::string a;
    std::string b;
    double mean = 255;
    int max = 255;
    double changed = 1;
};

void runCompare(const CompareOptions& options) {
    const auto d = image::compare(volume::readPicture(options.a), volume::readPicture(options.b));
    fmt::print("max {} mean {:.4f} changed {:.5f}\n", d.max, d.mean, d.changedFraction);
    if (d.mean > options.mean || d.max > options.max || d.changedFraction > options.changed) {
        throw Error("{}: differs from {} by max {}, mean {:.4f}, changed fraction {:.5f}; at most {}, {}, {} "
                    "is allowed",
                    options.a, options.b, d.max, d.mean, d.changedFraction, options.max, options.mean,
                    options.changed);
    }
}

} // namespace

void addCompareCommand(CLI::App& app) {
    auto* command = app.add_subcommand("compare", "Tell how far two pictures are apart");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("a", options->a, "First picture (PNG)")->required();
    command->add_option("b", options->b, "Second picture (PNG)")->required();
    command->add_option("--mean", options->mean, "Fail above this mean difference (0..255)")
        ->check(between(0, 255));
    command->add_option("--max", options->max, "Fail above this difference of any channel (0..255)");
    command
        ->add_option("--changed", options->changed,
                     "Fail above this fraction of pixels that differ by more than 8")
        ->check(between(0, 1));
    command->callback([options] { runCompare(*options); });
}

} // namespace vs::cli
