// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments/volume_argument.h"

#include "studio/document/document.h"
#include "studio/document/finer_levels.h"

#include <CLI/CLI.hpp>

#include <string>

namespace vs::cli {

// How a volume lies in memory, and how much of that there is, as given on the command line.
struct StorageArgument {
    std::string storage = "auto";
    std::string deviceMemory;
    std::string hostMemory;

    [[nodiscard]] studio::Storage kind() const;
    // Throws UsageError for what is no amount of memory.
    [[nodiscard]] studio::MemoryBudgets budgets() const;
};

// Adds --storage, --device-memory and --memory.
void addStorageOptions(CLI::App& command, StorageArgument& argument);

// Reads the volume and prints its notices. Throws as volume::readVolume() does.
studio::OpenedScan loadScan(const VolumeArgument& argument, const StorageArgument& storage);

// A document of it, which shows the finer levels that it has. Needs a current context.
std::unique_ptr<studio::Document> documentOf(studio::OpenedScan scan);

// studio::finerLevels(); notices are appended and printed.
std::optional<studio::FinerLevels> findFiner(const volume::Volume& scan, const volume::ReadOptions& read,
                                             const StorageArgument& storage,
                                             std::vector<std::string>& notices);

// Has a document show finer levels, or says in a notice, which is appended and printed, why it cannot.
void showFiner(studio::Document& document, const std::optional<studio::FinerLevels>& levels,
               std::vector<std::string>& notices);

// Prints what of finer levels could not be read: pictures show there what is worked on.
void tellFailures(const studio::Document& document);

} // namespace vs::cli
