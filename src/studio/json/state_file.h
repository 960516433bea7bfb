// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/hash.h"
#include "base/json_reader.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace vs::studio {

// A file of large blocks of bytes with a table of contents, a JSON object, at its end: the state of a session
// (doc/session.md). After the first eight bytes, "VSTATE2\n", the blocks follow one another, then the JSON
// text, and at last, in 16 bytes, where that begins and how long it is (little-endian). In the JSON a block
// is [where it begins, its length], and a list of numbers [.., its length, its length before compression
// (zstd)].

// Writes one. What goes wrong throws WriteError.
class StateWriter {
public:
    explicit StateWriter(const std::filesystem::path& path);

    // Adds a block, as it is, and says how the JSON names it.
    nlohmann::ordered_json block(std::span<const std::byte> bytes);
    // Adds a list of numbers, compressed.
    template <typename T>
    nlohmann::ordered_json list(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        return compressed(std::as_bytes(std::span(values)));
    }
    // Adds a list that other parts of the state share with this one: it is there once.
    template <typename T>
    nlohmann::ordered_json shared(const std::shared_ptr<const std::vector<T>>& values) {
        return once(values, [&] { return list(*values); });
    }
    // What `write` says of something that other parts of the state share with this one: it is asked once.
    template <typename T, typename Write>
    nlohmann::ordered_json once(const std::shared_ptr<const T>& value, Write write) {
        const auto known = shared_.find(value.get());
        if (known != shared_.end()) {
            return known->second;
        }
        keep_.push_back(value);
        nlohmann::ordered_json said = write();
        return shared_[value.get()] = std::move(said);
    }
    // Ends the file. Returns its checksum.
    std::string finish(const nlohmann::ordered_json& contents);

private:
    nlohmann::ordered_json compressed(std::span<const std::byte> bytes);
    void write(std::span<const std::byte> bytes);

    std::filesystem::path path_;
    std::ofstream out_;
    std::uint64_t at_ = 0;
    Hash64 hash_;
    std::map<const void*, nlohmann::ordered_json> shared_;
    std::vector<std::shared_ptr<const void>> keep_; // so that no other list takes an address
};

// Reads one. What is wrong in it throws SessionError naming the file.
class StateReader {
public:
    // Reads all of the file; throws ReadError where that fails.
    explicit StateReader(const std::filesystem::path& path);

    [[nodiscard]] const std::string& checksum() const { return checksum_; } // as finish() said it
    [[nodiscard]] JsonReader contents() const { return {contents_, path_.string()}; }

    [[nodiscard]] std::vector<std::byte> block(const JsonReader& place) const;
    // A list of at most so many numbers.
    template <typename T>
    [[nodiscard]] std::vector<T> list(const JsonReader& place, std::size_t most) const {
        const auto bytes = decompressed(place, most * sizeof(T));
        if (bytes.size() % sizeof(T) != 0) {
            place.fail("must be a list of whole numbers");
        }
        std::vector<T> values(bytes.size() / sizeof(T));
        if (!bytes.empty()) { // memcpy takes no null, even for nothing
            std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
        }
        return values;
    }
    // A list that may be shared: read once.
    template <typename T>
    std::shared_ptr<const std::vector<T>> shared(const JsonReader& place, std::size_t most) {
        return once<std::vector<T>>(place, [&] { return list<T>(place, most); });
    }
    // What `read` makes of a list that may be shared: asked once.
    template <typename T, typename Read>
    std::shared_ptr<const T> once(const JsonReader& place, Read read) {
        // What they become is part of the key: a file may claim that two lists are one.
        const std::string key = fmt::format("{} {} {} {}", typeid(T).name(), place.at(0).number(),
                                            place.at(1).number(), place.at(2).number());
        if (const auto known = shared_.find(key); known != shared_.end()) {
            return std::static_pointer_cast<const T>(known->second);
        }
        auto made = std::make_shared<const T>(read());
        shared_[key] = made;
        return made;
    }

private:
    [[nodiscard]] std::span<const std::byte> bytesAt(const JsonReader& place) const;
    [[nodiscard]] std::vector<std::byte> decompressed(const JsonReader& place, std::size_t mostBytes) const;

    std::filesystem::path path_;
    std::vector<std::byte> bytes_;
    std::string checksum_;
    nlohmann::ordered_json contents_;
    std::map<std::string, std::shared_ptr<const void>> shared_;
};

} // namespace vs::studio
