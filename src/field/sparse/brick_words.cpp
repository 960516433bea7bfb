// SPDX-License-Identifier: Apache-2.0
#include "field/sparse/brick_words.h"

#include "gl/limits.h"

#include <algorithm>
#include <span>

namespace vs::field {

namespace {

constexpr std::size_t kFirstBricks = 16;

bool isBrick(std::uint32_t page) { return page != 0 && (page & BrickWords::kNoBrick) == 0; }

} // namespace

std::size_t BrickWords::mostBricks(std::size_t places, std::size_t wordsOfBrick) {
    const std::size_t most =
        std::min(gl::TexelBuffer::mostTexels(), gl::limits().storageBlockBytes / sizeof(std::uint32_t));
    return most > places ? (most - places) / wordsOfBrick : 0;
}

void BrickWords::forget() {
    pages_.clear();
    free_.clear();
    used_ = 0;
    capacity_ = 0;
    places_ = 0;
    buffer_ = gl::TexelBuffer();
}

void BrickWords::begin(std::size_t places, std::size_t bricks) {
    forget();
    buffer_ = gl::TexelBuffer(places + bricks * wordsOfBrick_, gl::Format::R32UI, label_);
    places_ = places;
    capacity_ = bricks;
}

void BrickWords::setPage(std::uint32_t place, std::uint32_t page) {
    buffer_.write(std::as_bytes(std::span(&page, 1)), place);
    if (page == 0) {
        pages_.erase(place);
    } else {
        pages_[place] = page;
    }
}

void BrickWords::release(std::uint32_t place) {
    const auto known = pages_.find(place);
    if (known != pages_.end()) {
        if (isBrick(known->second)) {
            free_.push_back(known->second - 1);
        }
        setPage(place, 0);
    }
}

void BrickWords::put(std::uint32_t place, const Content& content) {
    const auto known = pages_.find(place);
    if (content.words.empty()) {
        setPage(place, content.page);
        return;
    }
    std::uint32_t brick = 0;
    const bool isThere = known != pages_.end() && isBrick(known->second);
    if (isThere) {
        brick = known->second - 1;
    } else if (!free_.empty()) {
        brick = free_.back();
        free_.pop_back();
    } else {
        brick = used_++;
    }
    buffer_.write(std::as_bytes(std::span(content.words)), places_ + brick * wordsOfBrick_);
    if (!isThere) {
        setPage(place, brick + 1);
    }
}

std::size_t BrickWords::bricksAfter(const Changes& changes) const {
    std::size_t bricks = used_ - free_.size();
    for (const auto& [place, content] : changes) {
        const auto known = pages_.find(place);
        const bool was = known != pages_.end() && isBrick(known->second);
        bricks += content.words.empty() ? 0 : 1;
        bricks -= was ? 1 : 0;
    }
    return bricks;
}

std::size_t BrickWords::update(std::size_t places, const std::function<Changes(bool)>& changes) {
    const bool isNew = places != places_;
    if (isNew) {
        forget();
    }
    Changes all = changes(isNew);
    const std::size_t bricks = bricksAfter(all);
    if (isNew || bricks > capacity_) {
        const std::size_t most = mostBricks(places, wordsOfBrick_);
        if (bricks > most) {
            forget();
            return bricks;
        }
        all = isNew ? all : changes(true); // all of it has to come again
        begin(places, std::min(std::max({bricks, 2 * capacity_, kFirstBricks}), most));
    }
    // What goes makes room for what comes.
    for (const auto& [place, content] : all) {
        if (content.words.empty()) {
            release(place);
        }
    }
    for (const auto& [place, content] : all) {
        if (!content.words.empty() || content.page != 0) {
            put(place, content);
        }
    }
    return 0;
}

} // namespace vs::field
