// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace vs {

// Tells contents from others that are not meant to deceive: FNV-1a on words of 64 bits (Fowler, Noll and Vo),
// what is left at the end byte by byte. Eight bytes at a time, since it must not dominate reading a file.
class Hash64 {
public:
    void add(std::uint64_t word) {
        hash_ ^= word;
        hash_ *= 1099511628211ULL;
    }
    // In as many pieces as one likes; the last of them may be followed by nothing else.
    void add(std::span<const std::byte> bytes) {
        while (!bytes.empty() && rest_ > 0) {
            bytes = addOne(bytes);
        }
        const std::size_t words = bytes.size() / kWord;
        for (std::size_t i = 0; i < words; ++i) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + kWord * i, kWord);
            add(word);
        }
        bytes = bytes.subspan(kWord * words);
        while (!bytes.empty()) {
            bytes = addOne(bytes);
        }
    }
    // 16 digits.
    [[nodiscard]] std::string text() const {
        Hash64 whole = *this;
        for (std::size_t i = 0; i < rest_; ++i) {
            whole.add(std::uint64_t(word_[i]));
        }
        return fmt::format("{:016x}", whole.hash_);
    }

private:
    static constexpr std::size_t kWord = 8;

    std::span<const std::byte> addOne(std::span<const std::byte> bytes) {
        word_[rest_++] = bytes.front();
        if (rest_ == kWord) {
            std::uint64_t word = 0;
            std::memcpy(&word, word_.data(), kWord);
            rest_ = 0;
            add(word);
        }
        return bytes.subspan(1);
    }

    std::uint64_t hash_ = 14695981039346656037ULL;
    std::array<std::byte, kWord> word_{}; // bytes that do not make a word yet
    std::size_t rest_ = 0;                // so many
};

} // namespace vs
