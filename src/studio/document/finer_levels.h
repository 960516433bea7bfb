// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/detail.h"
#include "volume/grid/brick_source.h"
#include "volume/io/read.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::studio {

class Document;

// How a scan lies in memory: all of it in one texture, or, as far as pictures are concerned, in bricks.
// `Bricks` draws everything from bricks, what would fit too.
enum class Storage { Auto, Dense, Bricks };
inline constexpr std::array<const char*, 3> kStorages{"auto", "dense", "bricks"};
constexpr const auto& namesOf(Storage) { return kStorages; }

// What volumes and what is done to them may take, in bytes; 0: what this machine has is asked for.
struct MemoryBudgets {
    std::size_t deviceBytes = 0;
    std::size_t hostBytes = 0;
    bool isDeviceChosen = false; // somebody said how much the device has

    // With another's instead of zeros.
    [[nodiscard]] MemoryBudgets orElse(const MemoryBudgets& other) const;
    // With what this machine has instead of zeros: three quarters of the memory of the device that pictures
    // are made on, or half of the machine's where that has none of its own; a quarter of the machine's for
    // the host.
    [[nodiscard]] MemoryBudgets filledIn() const;
};

// An amount of memory in bytes: "512MiB", "2GiB", or a number of MiB. Throws UsageError naming `what`.
std::size_t memoryOf(const std::string& text, const std::string& what);

// Levels of a scan that are finer than the one that is worked on.
struct FinerLevels {
    std::shared_ptr<const volume::BrickSource> source; // null: the document's own volume
    std::optional<volume::CellExtremes> extremes;      // of the finest
    field::DetailOptions options;
    bool isAllKnown = false; // whether the extremes are known of all of it

    // Whether their finest is finer than a volume that is worked on, so that tools cut that one.
    [[nodiscard]] bool areFinerThan(const volume::Volume& volume) const {
        return source != nullptr && source->levels().front().dims != volume.geometry.dims;
    }
};

// The level that a scan is worked on at: of a store the one that the options name, or else the finest that
// leaves room to work on it within the budgets; nothing: the finest, or there are none. Throws ReadError.
std::optional<int> levelToWorkOn(const std::filesystem::path& path, const volume::ReadOptions& options,
                                 Storage storage, const MemoryBudgets& budgets);

// The level that is worked on where all of the finest was meant and nobody said so: that, unless this
// machine's memory has no room to work on it, or somebody said how much may be taken; then as
// levelToWorkOn(). Throws ReadError.
std::optional<int> levelInReach(const std::filesystem::path& path, const volume::ReadOptions& options,
                                const MemoryBudgets& budgets);

// The levels of a scan's store that are finer than what was read with these options; with Storage::Bricks
// that one too, and that of any other volume; with Storage::Dense none. Notices are appended, also where they
// cannot be had: the scan is there without them.
std::optional<FinerLevels> finerLevels(const volume::Volume& scan, const volume::ReadOptions& read,
                                       Storage storage, const MemoryBudgets& budgets,
                                       std::vector<std::string>& notices);

// Has the document show them, or says in a notice why it cannot.
void showFinerLevels(Document& document, const std::optional<FinerLevels>& levels,
                     std::vector<std::string>& notices);

// A scan, read at the level that is worked on.
struct OpenedScan {
    volume::ReadResult read;
    volume::ReadOptions options; // with that level
    std::optional<FinerLevels> finer;
};

// Reads a scan, all of this together. Throws as volume::readVolume() does.
OpenedScan openScan(const std::filesystem::path& path, const volume::ReadOptions& options, Storage storage,
                    const MemoryBudgets& budgets);

} // namespace vs::studio
