// SPDX-License-Identifier: Apache-2.0
#include "base/lines.h"

#include <gtest/gtest.h>

#include <new>
#include <sstream>

namespace vs {
namespace {

using Texts = std::vector<std::string>;

TEST(Text, IsSplitAtSeparators) {
    EXPECT_EQ(split("a:b", ':'), (Texts{"a", "b"}));
    EXPECT_EQ(split(":a::b:", ':'), (Texts{"", "a", "", "b"}));
    EXPECT_EQ(split("", ':'), Texts());
    EXPECT_EQ(split(":", ':'), Texts{""});
}

TEST(Text, HasWords) {
    EXPECT_EQ(words(" one\ttwo\r\n three"), (Texts{"one", "two", "three"}));
    EXPECT_EQ(words(" \n"), Texts());
    EXPECT_EQ(words(""), Texts());
}

// A stream whose source fails after some bytes, as one does for want of memory or on a failing disk.
class Failing : public std::stringbuf {
public:
    explicit Failing(bool isDisk) : std::stringbuf("first\nsec"), isDisk_(isDisk) {}

protected:
    int_type underflow() override {
        if (const auto next = std::stringbuf::underflow(); next != traits_type::eof()) {
            return next;
        }
        if (isDisk_) {
            throw std::ios_base::failure("reading", std::make_error_code(std::errc::io_error));
        }
        throw std::bad_alloc();
    }

private:
    bool isDisk_;
};

TEST(Text, IsNotAtItsEndWhereMemoryIs) {
    Failing source(false);
    std::istream in(&source);
    std::string line;
    EXPECT_TRUE(nextLine(in, line, "a.txt"));
    EXPECT_EQ(line, "first");
    EXPECT_THROW(nextLine(in, line, "a.txt"), std::bad_alloc);
}

TEST(Text, IsNotAtItsEndWhereTheDiskFails) {
    Failing source(true);
    std::istream in(&source);
    std::string line;
    EXPECT_TRUE(nextLine(in, line, "a.txt"));
    try {
        nextLine(in, line, "a.txt");
        FAIL() << "the end of the file, it says";
    } catch (const ReadError& error) {
        EXPECT_EQ(std::string(error.what()), "a.txt: it cannot be read to its end (Input/output error)");
    }
}

} // namespace
} // namespace vs
