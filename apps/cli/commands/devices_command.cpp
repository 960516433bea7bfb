// SPDX-License-Identifier: Apache-2.0
#include "commands/commands.h"
#include "reports/device_report.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "gl/context.h"
#include "studio/selfcheck/self_check.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

namespace vs::cli {

namespace {

struct DevicesOptions {
    bool checks = false;
    std::vector<std::string> stages; // none: all
    std::string json;
};

// The checks of the stages that are asked for.
std::vector<studio::StageCheck> chosenChecks(const std::vector<std::string>& names) {
    const auto all = studio::stageChecks();
    std::vector<studio::StageCheck> chosen;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& check) { return check.name == name; });
        if (found == all.end()) {
            std::string known;
            for (const auto& check : all) {
                known += (known.empty() ? "" : ", ") + std::string(check.name);
            }
            throw UsageError("--stage '{}' does not exist; choose among: {}", name, known);
        }
        chosen.push_back(*found);
    }
    return names.empty() ? std::vector(all.begin(), all.end()) : chosen;
}

void listDevices() {
    const auto devices = gl::listDevices();
    bool any = false;
    for (const auto& device : devices) {
        if (device.info) {
            any = true;
            fmt::print("{}: {} ({}), OpenGL {}{}\n", device.index, device.info->renderer, device.info->vendor,
                       device.info->version, device.info->isSoftware ? ", software" : "");
            fmt::print("   volumes up to {} voxels along an axis, storage blocks up to {} MiB\n",
                       device.info->max3DTextureSize, device.info->maxStorageBlockBytes >> 20);
        } else {
            fmt::print("{}: no OpenGL 4.5 core without a window\n", device.index);
        }
    }
    if (!any) {
        throw GlError(
            "no device here offers OpenGL 4.5; install a GPU driver or Mesa's software renderer (Debian: "
            "libgl1-mesa-dri libegl-mesa0)");
    }
    fmt::print("VOLUME_STUDIO_DEVICE=N chooses one; without it the first that is not software is used\n");
}

// Checks every stage on the device that other commands would use, and prints each result as soon as it is
// there.
void checkDevice(const DevicesOptions& options) {
    const auto checks = chosenChecks(options.stages);
    if (!options.json.empty()) {
        outputFile(options.json); // what can be wrong with it is said before anything is checked
    }
    const auto context = gl::Context::createHeadless();
    fmt::print("{}\n", describeDevice(context.device()));
    std::vector<studio::StageResult> results;
    for (const studio::StageCheck& check : checks) {
        results.push_back(studio::runCheck(check, context));
        fmt::print("{}", describe(results.back()));
        std::fflush(stdout);
    }
    if (!options.json.empty()) {
        writeFileAtomically(options.json, jsonOf(context.device(), results));
    }
    fmt::print("\n{}", verdictOf(results));
    for (const auto& result : results) {
        if (!result.isOk()) {
            throw GlError("this device or its driver computes something wrong, as said above; a newer driver "
                          "or another device (VOLUME_STUDIO_DEVICE=N) may be right");
        }
    }
}

void run(const DevicesOptions& options) {
    if (options.checks) {
        checkDevice(options);
    } else {
        listDevices();
    }
}

} // namespace

void addDevicesCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "devices", "List the devices that can render without a window, or check what one of them computes");
    const auto options = std::make_shared<DevicesOptions>();
    auto* check = command->add_flag(
        "--check", options->checks,
        "Check every stage of the program's work on the device that VOLUME_STUDIO_DEVICE "
        "chooses against the CPU, and print a report to send in; fails if something is wrong");
    command
        ->add_option("--stage", options->stages,
                     "Check this stage only, by its name in the report; may be given again")
        ->needs(check);
    command->add_option("--json", options->json, "Write the check's report to this file too (JSON)")
        ->needs(check);
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
