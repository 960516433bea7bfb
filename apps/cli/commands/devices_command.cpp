// SPDX-License-Identifier: Apache-2.0
#include "commands/commands.h"

#include "base/error.h"
#include "gl/context.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace vs::cli {

namespace {

void runDevices() {
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

} // namespace

void addDevicesCommand(CLI::App& app) {
    auto* command = app.add_subcommand("devices", "List the devices that can render without a window");
    command->callback(runDevices);
}

} // namespace vs::cli
