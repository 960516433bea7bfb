// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"

#include "gl/program.h"
#include "gl/shaders/bindings.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vs::studio {

namespace {

// So many that a driver is still at work on them when it is given the next thing to do.
constexpr std::size_t kWords = std::size_t(1) << 24;

class Words {
public:
    Words() : buffer_(kWords * sizeof(std::uint32_t), "self check words") {}

    void fillByDispatch(std::size_t first, std::size_t count, std::uint32_t value) {
        prepare(first, count, value);
        fill_.dispatch({256, 1, 1}, gl::Barrier::Storage);
    }
    void fillByIndirectDispatch(const gl::Buffer& arguments, std::uint32_t value) {
        prepare(0, kWords, value);
        fill_.dispatchIndirect(arguments, 0, gl::Barrier::Storage);
    }
    void write(std::size_t first, std::span<const std::uint32_t> values) {
        buffer_.write(values, first * sizeof(std::uint32_t));
    }
    void clear(std::size_t first, std::size_t count) {
        buffer_.clear(first * sizeof(std::uint32_t), count * sizeof(std::uint32_t));
    }
    [[nodiscard]] std::size_t count(std::uint32_t value) const {
        const auto words = buffer_.read<std::uint32_t>(kWords);
        return std::size_t(std::count(words.begin(), words.end(), value));
    }

private:
    void prepare(std::size_t first, std::size_t count, std::uint32_t value) {
        buffer_.bindStorage(gl::kWordsStorage);
        fill_.set("firstWord", std::uint32_t(first))
            .set("wordCount", std::uint32_t(count))
            .set("value", value);
    }

    gl::Buffer buffer_;
    gl::Program fill_{"gl/shaders/fill_words.comp"};
};

} // namespace

void checkOrder(Tally& tally) {
    constexpr std::size_t some = 5000;
    const std::vector<std::uint32_t> ones(some, 1);
    {
        Words words;
        words.write(kWords - some, ones);
        tally.about("words that were written to new memory");
        tally.compare(double(words.count(1)), double(some));
    }
    Words words;
    words.fillByDispatch(kWords - some, some, 2);
    tally.about("words that a dispatch has given new memory");
    tally.compare(double(words.count(2)), double(some));
    for (int round = 0; round < 4; ++round) {
        words.fillByDispatch(0, kWords, 3);
        words.clear(0, kWords - 1);
        words.fillByDispatch(kWords - some - 1, some, 4);
        words.write(0, ones);
        tally.about("zeros between what came after them");
        tally.compare(double(words.count(0)), double(kWords - 1 - 2 * some));
        tally.compare(double(words.count(4)), double(some));
        tally.compare(double(words.count(1)), double(some));
    }
    gl::Buffer arguments(4 * sizeof(std::uint32_t), "self check arguments");
    for (std::uint32_t round = 10; round < 14; ++round) {
        const std::array<std::uint32_t, 4> groups{round * 10, 1, 1, round};
        arguments.write(std::span<const std::uint32_t>(groups));
        words.fillByIndirectDispatch(arguments, round);
        tally.about("words of a dispatch whose size was written just before");
        tally.compare(double(words.count(round)), double(kWords));
        tally.compare(double(arguments.read<std::uint32_t>(4)[3]), double(round));
    }
}

} // namespace vs::studio
