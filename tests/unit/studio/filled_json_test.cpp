// SPDX-License-Identifier: Apache-2.0
// What is filled, in the state of a session: it comes back as it was, and what no program would have written
// is refused.
#include "studio/json/filled_json.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

namespace vs::studio {
namespace {

using Numbers = std::vector<std::uint64_t>;

class FilledJsonTest : public ::testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(file_); }

    template <typename Write>
    Filled again(Write write) {
        StateWriter writer(file_);
        writer.finish({{"filled", write(writer)}});
        StateReader reader(file_);
        return readFilled(reader, reader.contents().member("filled"), kDims);
    }
    void expectRefused(const Numbers& begin, const field::FillBrick& brick, int materials = 2) {
        const auto write = [&](StateWriter& writer) {
            const auto block = writer.list(std::vector<field::FillBrick>{brick});
            Numbers numbers = begin;
            for (int i = 0; i < 3; ++i) {
                numbers.push_back(block.at(std::size_t(i)).get<std::uint64_t>());
            }
            nlohmann::ordered_json said = stored(writer, filledWith(nullptr, materials));
            said["fill"] = writer.list(numbers);
            return said;
        };
        EXPECT_THROW(again(write), SessionError);
    }
    static field::FillBrick someBrick(std::uint8_t material = 2) {
        field::FillBrick brick;
        brick.filled[5] = 40000;
        brick.material[5] = material;
        return brick;
    }
    static Filled filledWith(const std::shared_ptr<const field::FillBrick>& brick, int materials) {
        Filled filled(kDims);
        std::vector<Material> list;
        for (int n = 0; n < materials; ++n) {
            list.push_back({"m" + std::to_string(n), glm::dvec3(0.25), 100.0 * n, n % 2 == 0});
        }
        filled.materials = std::make_shared<const std::vector<Material>>(std::move(list));
        if (brick != nullptr) {
            filled.fill = std::make_shared<const field::Fill>(filled.fill->with({{3, brick}, {4, brick}}));
        }
        return filled;
    }

    static constexpr glm::ivec3 kDims{40, 30, 20};
    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("vs_filled_" + std::to_string(getpid()) + ".state");
};

TEST_F(FilledJsonTest, ComesBackAsItWasAndIsWrittenOnce) {
    const Filled filled = filledWith(std::make_shared<const field::FillBrick>(someBrick()), 2);
    const auto write = [&](StateWriter& writer) {
        auto said = stored(writer, filled);
        EXPECT_EQ(stored(writer, filled), said);
        return said;
    };
    const Filled read = again(write);
    EXPECT_TRUE(read.isAlike(filled));
    EXPECT_EQ(read.fill->bricks().entries()[0].second, read.fill->bricks().entries()[1].second)
        << "one brick in two places is one";
    const Filled nothing = filledWith(nullptr, 1);
    EXPECT_TRUE(again([&](StateWriter& writer) { return stored(writer, nothing); }).isAlike(nothing));
}

TEST_F(FilledJsonTest, RefusesWhatWouldBeWrong) {
    expectRefused({1000000}, someBrick());  // there is no such place
    expectRefused({}, someBrick());         // a number is missing
    expectRefused({0}, field::FillBrick()); // in which nothing is filled
    expectRefused({0}, someBrick(3));       // with what there is not
    expectRefused({0}, someBrick(0));       // with nothing
    expectRefused({0}, someBrick(1), 0);
    field::FillBrick hollow = someBrick();
    hollow.material[7] = 1; // of which nothing is filled
    expectRefused({0}, hollow);
    expectRefused({0}, someBrick(), field::kMostMaterials + 1);
}

} // namespace
} // namespace vs::studio
