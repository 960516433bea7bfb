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
    std::optional<int> level;
    std::optional<int> channel;
};

// Adds --raw, --series, --frame, --level and --channel for a volume that is named elsewhere.
// `level` is how --level is called where that means something else.
void addReadOptions(CLI::App& command, VolumeArgument& argument, const char* level = "--level");

// Adds VOLUME, --raw, --series, --frame, --level and --channel to a subcommand. The result is filled in when
// the line is parsed; capture it in the subcommand's callback.
std::shared_ptr<VolumeArgument> addVolumeArgument(CLI::App& command);

// --raw, --series, --frame, --level and --channel as reading wants them. Throws UsageError for a raw layout
// that makes no sense.
volume::ReadOptions readOptions(const VolumeArgument& argument);

// Reads the volume and prints its notices. Throws ReadError, or UsageError for a raw layout that makes no
// sense.
volume::ReadResult loadVolume(const VolumeArgument& argument);

} // namespace vs::cli
