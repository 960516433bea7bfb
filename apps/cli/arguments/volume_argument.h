// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

namespace vs::cli {

// The volume that a command works on, as given on its command line.
struct VolumeArgument {
    std::string path;
    std::optional<std::string> rawLayout;
    std::optional<std::string> series;
    std::optional<int> frame;
};

// Adds --raw, --series and --frame for a volume that is named elsewhere.
void addReadOptions(CLI::App& command, VolumeArgument& argument);

// Adds VOLUME, --raw, --series and --frame to a subcommand. The result is filled in when the line is parsed;
// capture it in the subcommand's callback.
std::shared_ptr<VolumeArgument> addVolumeArgument(CLI::App& command);

// --raw, --series and --frame as reading wants them. Throws UsageError for a raw layout that makes no sense.
volume::ReadOptions readOptions(const VolumeArgument& argument);

// Reads the volume and prints its notices. Throws ReadError, or UsageError for a raw layout that makes no
// sense.
volume::ReadResult loadVolume(const VolumeArgument& argument);

} // namespace vs::cli
