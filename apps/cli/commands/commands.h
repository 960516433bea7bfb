// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

// One function per command, each in its own NAME_command.cpp. They add a subcommand whose callback does the
// work and throws vs::Error.
namespace vs::cli {

void addInfoCommand(CLI::App& app);
void addRecoverCommand(CLI::App& app);
void addReduceCommand(CLI::App& app);
void addConvertCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addRunCommand(CLI::App& app);
void addCheckCommand(CLI::App& app);
void addGrowCommand(CLI::App& app);
void addHistogramCommand(CLI::App& app);
void addPhantomCommand(CLI::App& app);
void addSketchCommand(CLI::App& app);
void addSweepCommand(CLI::App& app);
void addDevicesCommand(CLI::App& app);
void addExperimentsCommand(CLI::App& app);
void addExportCommand(CLI::App& app);
void addFilmCommand(CLI::App& app);
void addStatsCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);

} // namespace vs::cli
