// SPDX-License-Identifier: Apache-2.0
#include "studio/state/spill_file.h"

#include "base/check.h"
#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace vs::studio {

SpillFile::SpillFile(std::filesystem::path folder) : folder_(std::move(folder)) {}

SpillFile::~SpillFile() {
    if (file_ >= 0) {
        ::close(file_);
    }
}

void SpillFile::open() {
    if (file_ >= 0) {
        return;
    }
    if (folder_.empty()) {
        std::error_code error;
        folder_ = std::filesystem::temp_directory_path(error);
        if (error) {
            throw WriteError("no folder for temporary files ({}); set TMPDIR to one", error.message());
        }
    }
    file_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file_ < 0) { // a file system without nameless files: the name goes at once
        std::string name = (folder_ / "volume-studio-undo-XXXXXX").string();
        file_ = ::mkostemp(name.data(), O_CLOEXEC);
        if (file_ < 0) {
            throw WriteError("{}: no temporary file can be made there ({}); set TMPDIR to another folder",
                             folder_.string(), std::strerror(errno));
        }
        ::unlink(name.c_str());
    }
}

// The first gap that is large enough, else the end.
std::uint64_t SpillFile::placeFor(std::size_t size) const {
    for (const auto& [offset, room] : gaps_) {
        if (room >= size) {
            return offset;
        }
    }
    return end_;
}

SpillFile::Block SpillFile::write(std::span<const std::byte> bytes) {
    open();
    const Block block{placeFor(bytes.size()), bytes.size()};
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            ::pwrite(file_, bytes.data() + done, bytes.size() - done, off_t(block.offset + done));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            const int problem = count < 0 ? errno : ENOSPC;
            truncate(end_);
            throw WriteError(
                "{}: {} KiB of undo data cannot be kept there ({}); free some room or set TMPDIR",
                folder_.string(), (bytes.size() >> 10U) + 1, std::strerror(problem));
        }
        done += std::size_t(count);
    }
    take(block);
    return block;
}

void SpillFile::take(const Block& block) {
    inUse_ += block.size;
    if (block.offset == end_) {
        end_ += block.size;
        return;
    }
    const auto gap = gaps_.find(block.offset);
    VS_CHECK(gap != gaps_.end() && gap->second >= block.size);
    auto rest = gaps_.extract(gap); // what is left of it is the gap from now on, which needs no memory
    rest.key() += block.size;
    rest.mapped() -= block.size;
    if (rest.mapped() > 0) {
        gaps_.insert(std::move(rest));
    }
}

std::vector<std::byte> SpillFile::read(const Block& block) const {
    std::vector<std::byte> bytes(block.size);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            ::pread(file_, bytes.data() + done, bytes.size() - done, off_t(block.offset + done));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            throw ReadError("{}: undo data kept there cannot be read ({}); it stays where it is, try again",
                            folder_.string(), count < 0 ? std::strerror(errno) : "the file ends too soon");
        }
        done += std::size_t(count);
    }
    return bytes;
}

void SpillFile::release(const Block& block) noexcept {
    inUse_ -= block.size;
    if (block.size == 0) {
        return;
    }
    try {
        addGap(block);
    } catch (const std::bad_alloc&) { // nobody knows of this place any more: the file is longer than need be
    }
}

void SpillFile::addGap(const Block& block) {
    auto [gap, isNew] = gaps_.emplace(block.offset, block.size);
    VS_CHECK(isNew);
    if (const auto next = std::next(gap); next != gaps_.end() && gap->first + gap->second == next->first) {
        gap->second += next->second;
        gaps_.erase(next);
    }
    if (gap != gaps_.begin()) {
        const auto before = std::prev(gap);
        if (before->first + before->second == gap->first) {
            before->second += gap->second;
            gaps_.erase(gap);
            gap = before;
        }
    }
    if (gap->first + gap->second == end_) {
        truncate(gap->first);
        gaps_.erase(gap);
    }
}

void SpillFile::truncate(std::uint64_t end) {
    end_ = end;
    // Should it fail, the file is longer than it need be, no more.
    [[maybe_unused]] const int result = ::ftruncate(file_, off_t(end));
}

} // namespace vs::studio
