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

namespace vs::studio {

// How a scan lies in memory: all of it in one texture, or, as far as pictures are concerned, in bricks.
// `Bricks` draws everything from bricks, what would fit too.
enum class Storage { Auto, Dense, Bricks };
inline constexpr std::array<const char*, 3> kStorages{"auto", "dense", "bricks"};
constexpr const auto& namesOf(Storage) { return kStorages; }

// What volumes and what is done to them may take, in bytes; 0: what this machine has is asked for.
struct MemoryBudgets {
    std::size_t deviceBytes = 0;
    std::size_t hostBytes = 0;

    // With what this machine has instead of zeros: half of its memory for what a software renderer calls its
    // device, a quarter for the host.
    [[nodiscard]] MemoryBudgets filledIn() const;
};

// Levels of a scan that are finer than the one that is worked on.
struct FinerLevels {
    std::shared_ptr<const volume::BrickSource> source; // null: the document's own volume
    std::optional<volume::CellExtremes> extremes; // of the finest
    field::DetailOptions options;
};

// A scan, read at the level that is worked on, with those that are finer.
struct OpenedScan {
    volume::ReadResult read;
    std::optional<FinerLevels> finer;
};

// Reads a scan: of a store the level that the options name, or the finest that leaves room to work on it within
// the budgets, and says so where that is not the finest of all; of anything else all of it. Storage::Dense has
// no finer levels. Throws as volume::readVolume() does.
OpenedScan openScan(const std::filesystem::path& path, const volume::ReadOptions& options, Storage storage,
                    const MemoryBudgets& budgets);

// A volume in memory in bricks of its own: none that are finer.
FinerLevels ownLevel(const MemoryBudgets& budgets);

} // namespace vs::studio
