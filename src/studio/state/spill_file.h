// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vs::studio {

// Blocks of bytes that are too many to stay in memory, in a temporary file without a name: no other program
// sees it, and it is gone when this one ends, however it ends. The file is made with the first block. Places
// of released blocks are used again, and the file ends where its last block does. One thread.
class SpillFile {
public:
    struct Block {
        std::uint64_t offset = 0;
        std::size_t size = 0;
    };

    // In `folder`, or the system's folder for temporary files.
    explicit SpillFile(std::filesystem::path folder = {});
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    // Throws WriteError, naming the folder, when there is no room; nothing has changed then.
    Block write(std::span<const std::byte> bytes);
    // Throws ReadError when the device that holds the file fails.
    [[nodiscard]] std::vector<std::byte> read(const Block& block) const;
    // The block is not needed any more.
    void release(const Block& block) noexcept;

    [[nodiscard]] std::uint64_t bytesInUse() const { return inUse_; } // of all blocks
    [[nodiscard]] std::uint64_t fileBytes() const { return end_; }    // with the gaps between them

private:
    void open();
    [[nodiscard]] std::uint64_t placeFor(std::size_t size) const;
    void take(const Block& block);
    void addGap(const Block& block);
    void truncate(std::uint64_t end);

    std::filesystem::path folder_;
    int file_ = -1;
    std::uint64_t end_ = 0;
    std::uint64_t inUse_ = 0;
    std::map<std::uint64_t, std::uint64_t> gaps_; // offset and size; none touches another or the end
};

} // namespace vs::studio
