// SPDX-License-Identifier: Apache-2.0
#include "studio/state/spill_file.h"

#include "base/error.h"
#include "property.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <random>
#include <sys/resource.h>

namespace vs::studio {
namespace {

std::vector<std::byte> noise(std::size_t size, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> bytes(size);
    for (auto& byte : bytes) {
        byte = std::byte(random() & 0xffU);
    }
    return bytes;
}

TEST(SpillFile, GivesBackWhatWasWritten) {
    SpillFile file;
    const auto a = file.write(noise(1000, 1));
    const auto b = file.write(noise(1, 2));
    const auto c = file.write(noise(70000, 3));
    EXPECT_EQ(file.read(b), noise(1, 2));
    EXPECT_EQ(file.read(c), noise(70000, 3));
    EXPECT_EQ(file.read(a), noise(1000, 1));
    EXPECT_EQ(file.bytesInUse(), 71001U);
    EXPECT_EQ(file.fileBytes(), 71001U);
}

TEST(SpillFile, PlacesAreUsedAgainAndTheFileShrinks) {
    SpillFile file;
    const auto a = file.write(noise(100, 1));
    const auto b = file.write(noise(200, 2));
    const auto c = file.write(noise(300, 3));
    file.release(b);
    EXPECT_EQ(file.fileBytes(), 600U);
    const auto d = file.write(noise(150, 4)); // into the gap
    EXPECT_EQ(file.fileBytes(), 600U);
    EXPECT_EQ(file.read(c), noise(300, 3));
    file.release(c); // with the rest of the gap before it
    EXPECT_EQ(file.fileBytes(), 250U);
    file.release(a);
    EXPECT_EQ(file.read(d), noise(150, 4));
    file.release(d);
    EXPECT_EQ(file.fileBytes(), 0U);
    EXPECT_EQ(file.bytesInUse(), 0U);
}

// Writes a block of `size` bytes or, when there is any, reads and releases the one that `which` comes to.
struct Move {
    bool isWrite;
    int size;
    int which;
};

void showValue(const Move& move, std::ostream& out) {
    move.isWrite ? out << "write " << move.size : out << "release " << move.which;
}

rc::Gen<Move> anyMove() {
    return rc::gen::exec([] {
        const bool isWrite = *test::below(5) < 3;
        return Move{isWrite, isWrite ? *test::below(3000) : 0, isWrite ? 0 : *test::below(10000)};
    });
}

TEST(SpillFile, AtRandomNothingIsMixedUp) {
    test::checkProperty(10, [] {
        SpillFile file;
        std::vector<std::pair<SpillFile::Block, unsigned>> blocks;
        std::uint64_t bytes = 0;
        unsigned count = 0;
        for (const Move& move : *test::upTo(400, anyMove())) {
            if (blocks.empty() || move.isWrite) {
                blocks.emplace_back(file.write(noise(std::size_t(move.size), count)), count);
                bytes += std::uint64_t(move.size);
            } else {
                const std::size_t which = std::size_t(move.which) % blocks.size();
                const auto [block, seed] = blocks[which];
                RC_ASSERT((file.read(block) == noise(block.size, seed)));
                file.release(block);
                bytes -= block.size;
                blocks.erase(blocks.begin() + std::ptrdiff_t(which));
            }
            ++count;
            RC_ASSERT(file.bytesInUse() == bytes);
            RC_ASSERT(bytes <= file.fileBytes());
        }
        for (const auto& [block, seed] : blocks) {
            RC_ASSERT((file.read(block) == noise(block.size, seed)));
            file.release(block);
        }
        RC_ASSERT(file.fileBytes() == 0U);
    });
}

TEST(SpillFile, AFolderThatCannotBeWrittenToIsNamed) {
    SpillFile file("/nowhere/at/all");
    try {
        file.write(noise(10, 1));
        FAIL();
    } catch (const WriteError& error) {
        EXPECT_NE(std::strstr(error.what(), "/nowhere/at/all"), nullptr) << error.what();
        EXPECT_EQ(std::strchr(error.what(), '\n'), nullptr);
    }
    EXPECT_EQ(file.fileBytes(), 0U);
}

// A limit on the length of files stands for a full disk.
TEST(SpillFile, WithoutRoomTheOtherBlocksStay) {
    SpillFile file;
    const auto kept = file.write(noise(5000, 1));
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit low = before;
    low.rlim_cur = 20000;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &low), 0);
    EXPECT_THROW(file.write(noise(100000, 2)), WriteError);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(file.fileBytes(), 5000U);
    EXPECT_EQ(file.read(kept), noise(5000, 1));
    EXPECT_EQ(file.read(file.write(noise(100000, 2))), noise(100000, 2));
}

} // namespace
} // namespace vs::studio
