// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace vs::decoder {

// How much memory and processor time reading a file may cost. Both grow with what is there: with the file's
// own bytes and with those of the voxels that its header, once checked, promises; the promise counts up to
// 1040 times the file's bytes, which is more than deflate packs.
//
//   memory of its own  192 MiB + 2 x file + 6 x promise
//   processor time     1.5 s + 250 ns x (file + promise) + 1 ms for each file
//
// Beyond them an allocation fails and the process ends with SIGPROF. Without effect on memory where a
// sanitizer, which reserves much, is built in; time is twenty times as long then.
class Limits {
public:
    // What reading starts with: little, whatever the header will say. An empty path: no file is read.
    explicit Limits(const std::filesystem::path& path);

    // The header promises voxels of so many bytes.
    void promise(std::uint64_t bytes);
    // It names another file of so many bytes, which holds them.
    void addFile(std::uint64_t bytes);

private:
    void set() const;

    std::uint64_t files_ = 1;
    std::uint64_t fileBytes_ = 0;
    std::uint64_t promisedBytes_ = 0;
};

} // namespace vs::decoder
