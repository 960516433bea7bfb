// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace vs::segment {

// Lists of a number for each voxel of a tile of 8^3, which live until all are taken back: threads take one
// for a few voxels each, too often to ask the system for memory.
class TileLists {
public:
    TileLists();

    // A list whose numbers are not set; null: there is no memory. Threads may ask at once.
    std::uint16_t* take() noexcept;
    // No list is in use any more. Their memory is kept, up to a limit.
    void takeBackAll();
    [[nodiscard]] std::size_t bytes() const { return blocks_.size() * kListsInBlock * kListBytes; }

private:
    static constexpr std::size_t kNumbers = 512; // in a list
    static constexpr std::size_t kListBytes = kNumbers * sizeof(std::uint16_t);
    static constexpr std::size_t kListsInBlock = 256;
    static constexpr std::size_t kListsAtOnce = 32; // that a thread takes for itself
    static constexpr std::size_t kBlocksKept = 256; // 64 MiB

    std::uint16_t* takeSome() noexcept;

    std::mutex mutex_;
    std::vector<std::unique_ptr<std::uint16_t[]>> blocks_;
    std::size_t used_ = 0;    // lists that were taken
    std::uint64_t epoch_ = 0; // another one whenever all were taken back, and no other object's
};

} // namespace vs::segment
