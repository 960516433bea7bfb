// SPDX-License-Identifier: Apache-2.0
#include "commands/commands.h"

#include "base/error.h"
#include "base/large_pages.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <string>

namespace {

constexpr int failed = 1;
constexpr int wrongUsage = 2;

// Whatever the cause, exactly one line on standard error.
int report(std::string message, int exitCode) {
    while (!message.empty() && message.back() == '\n') {
        message.pop_back();
    }
    for (char& c : message) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    fmt::print(stderr, "vstudio: {}\n", message);
    return exitCode;
}

int run(int argc, char** argv) {
    CLI::App app("Volume Studio without a display: looks into volumes, renders, grows and measures.",
                 "vstudio");
    app.set_version_flag("--version", "vstudio " VOLUME_STUDIO_VERSION);
    app.require_subcommand(1);
    vs::cli::addInfoCommand(app);
    vs::cli::addRenderCommand(app);
    vs::cli::addRunCommand(app);
    vs::cli::addRecoverCommand(app);
    vs::cli::addReduceCommand(app);
    vs::cli::addConvertCommand(app);
    vs::cli::addCheckCommand(app);
    vs::cli::addGrowCommand(app);
    vs::cli::addHistogramCommand(app);
    vs::cli::addPhantomCommand(app);
    vs::cli::addSketchCommand(app);
    vs::cli::addSweepCommand(app);
    vs::cli::addDevicesCommand(app);
    vs::cli::addExperimentsCommand(app);
    vs::cli::addExportCommand(app);
    vs::cli::addFilmCommand(app);
    vs::cli::addStatsCommand(app);
    vs::cli::addCompareCommand(app);
    vs::cli::addBenchCommand(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) { // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        return report(fmt::format("{}; see vstudio --help", error.what()), wrongUsage);
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    vs::keepFreedMemory();
    try {
        const int code = run(argc, argv);
        // What was printed may still wait to be written; a full disk shows only now.
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            return report("standard output: cannot be written; check where it is sent to", failed);
        }
        return code;
    } catch (const vs::UsageError& error) {
        return report(error.what(), wrongUsage);
    } catch (const std::bad_alloc&) {
        return report("there is no memory for that; end other programs, or use a smaller volume", failed);
    } catch (const std::exception& error) {
        return report(error.what(), failed);
    }
}
