// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texel_buffer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vs::field {

// Sparse bricks on the device, in one buffer of words that shaders read as texels: first a word for each
// place of their grid, its page, then the bricks, each of as many words. A page is 0 where nothing is, the
// brick's number counted from 1, or, with its highest bit set, whatever the owner says of a place that needs
// no brick.
class BrickWords {
public:
    using Words = std::vector<std::uint32_t>;
    static constexpr std::uint32_t kNoBrick = std::uint32_t(1) << 31;
    // What a place is to hold: a brick, or, where it has no words, a page (0: nothing).
    struct Content {
        Words words;
        std::uint32_t page = 0;
    };
    using Changes = std::map<std::uint32_t, Content>; // by place

    BrickWords(std::size_t wordsOfBrick, std::string label)
        : wordsOfBrick_(wordsOfBrick), label_(std::move(label)) {}

    // How many bricks the device has room for in a grid of so many places.
    [[nodiscard]] static std::size_t mostBricks(std::size_t places, std::size_t wordsOfBrick);

    [[nodiscard]] bool isHeld(std::uint32_t place) const { return pages_.count(place) > 0; }
    // Makes changes to what is held; changes(true) are those to nothing, for when it has to begin anew.
    // Returns how many bricks there would be if that is more than there is room for; then nothing is held.
    [[nodiscard]] std::size_t update(std::size_t places, const std::function<Changes(bool)>& changes);
    void forget();

    // Where in the buffer bricks begin.
    [[nodiscard]] std::size_t firstWord() const { return places_; }
    void bindTexture(unsigned unit) const { buffer_.bindTexture(unit); }

private:
    void begin(std::size_t places, std::size_t bricks);
    void put(std::uint32_t place, const Content& content);
    void release(std::uint32_t place);
    void setPage(std::uint32_t place, std::uint32_t page);
    [[nodiscard]] std::size_t bricksAfter(const Changes& changes) const;

    std::size_t wordsOfBrick_;
    std::string label_;
    std::size_t places_ = 0;
    std::map<std::uint32_t, std::uint32_t> pages_; // of places that hold something
    std::vector<std::uint32_t> free_;              // numbers of bricks, from 0
    std::uint32_t used_ = 0;                       // bricks, free ones among them
    std::size_t capacity_ = 0;                     // bricks
    gl::TexelBuffer buffer_;
};

} // namespace vs::field
