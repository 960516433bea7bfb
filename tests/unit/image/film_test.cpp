// SPDX-License-Identifier: Apache-2.0
#include "film_folder.h"

#include <cmath>
#include <limits>

namespace vs::image {
namespace {

using Film = FilmFolder;

Image noise(glm::ivec2 size, unsigned seed) {
    Image image(size.x, size.y);
    for (auto& byte : image.rgba) {
        seed = seed * 1664525 + 1013904223;
        byte = std::uint8_t(seed >> 24);
    }
    return image;
}

TEST_F(Film, TheEndingSaysTheFormat) {
    EXPECT_EQ(filmFormatOf("a/turn.webm"), FilmFormat::WebM);
    EXPECT_EQ(filmFormatOf("turn.WebM"), FilmFormat::WebM);
    EXPECT_EQ(filmFormatOf("turn.mp4"), FilmFormat::Mp4);
    EXPECT_EQ(filmFormatOf("turn.png"), FilmFormat::Pngs);
    EXPECT_EQ(filmFormatOf("turn"), FilmFormat::Pngs);
    EXPECT_EQ(filmFormatOf("a.b/turn/"), FilmFormat::Pngs);
    const std::string text = errorOf([] { filmFormatOf("turn.avi"); });
    EXPECT_TRUE(text.starts_with("turn.avi: ")) << text;
    EXPECT_NE(text.find(".webm or .mp4"), std::string::npos) << text;
}

TEST_F(Film, OnlyH264LeavesOutOddColumnsAndRows) {
    EXPECT_EQ(filmSize(FilmFormat::Mp4, {641, 480}), glm::ivec2(640, 480));
    EXPECT_EQ(filmSize(FilmFormat::WebM, {641, 479}), glm::ivec2(641, 479));
    EXPECT_EQ(filmSize(FilmFormat::Pngs, {641, 479}), glm::ivec2(641, 479));
}

TEST_F(Film, WhatCannotBeAFilmIsRefusedInOneLine) {
    const auto refusal = [&](glm::ivec2 size, double framesPerSecond) {
        return errorOf([&] { FilmWriter(film("a.mp4"), size, {framesPerSecond}); });
    };
    EXPECT_NE(refusal({1, 40}, 30).find("2 x 2"), std::string::npos);
    EXPECT_NE(refusal({40, -3}, 30).find("2 x 2"), std::string::npos);
    for (const double rate : {0.0, -1.0, 1000.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_NE(refusal({40, 40}, rate).find("give 1 to 240"), std::string::npos);
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(Film, NumberedPicturesComeBackToTheBit) {
    for (const std::string name : {"turn", "turn.png", "turn/"}) {
        FilmWriter writer(film(name), {33, 17});
        for (unsigned n = 0; n < 3; ++n) {
            writer.add(noise({33, 17}, n));
        }
        EXPECT_EQ(entries(), 1) << "before it is finished: the old folder or a hidden one";
        writer.finish();
        EXPECT_EQ(writer.frameCount(), 3);
        for (unsigned n = 0; n < 3; ++n) {
            const Image back = readPng(film("turn") / ("turn_000" + std::to_string(n + 1) + ".png"));
            EXPECT_EQ(back.rgba, noise({33, 17}, n).rgba);
        }
        EXPECT_EQ(entries(), 1);
        std::filesystem::remove_all(film("turn"));
    }
}

TEST_F(Film, AFolderOfNumberedPicturesIsReplacedAsAWhole) {
    for (const int count : {5, 2}) {
        FilmWriter writer(film("turn"), {8, 8});
        for (int n = 0; n < count; ++n) {
            writer.add(plain({8, 8}, {count, n, 0, 255}));
        }
        writer.finish();
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(film("turn")), {}), 2);
    EXPECT_EQ(readPng(film("turn") / "turn_0002.png").pixel(3, 3)[0], 2);
    EXPECT_EQ(entries(), 1);
}

TEST_F(Film, AFolderWithAnythingElseInItStaysAsItIs) {
    std::filesystem::create_directories(film("turn"));
    std::ofstream(film("turn") / "turn_0001.png") << "old";
    std::ofstream(film("turn") / "notes.txt") << "mine";
    const std::string text = errorOf([&] { FilmWriter(film("turn"), {8, 8}); });
    EXPECT_TRUE(text.starts_with(film("turn").string())) << text;
    EXPECT_NE(text.find("notes.txt"), std::string::npos) << text;
    EXPECT_EQ(contentOf(film("turn") / "turn_0001.png"), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(Film, AFolderThatFillsWhileTheFilmIsMadeStaysToo) {
    FilmWriter writer(film("turn"), {8, 8});
    writer.add(plain({8, 8}, {1, 2, 3, 255}));
    std::filesystem::create_directories(film("turn"));
    std::ofstream(film("turn") / "notes.txt") << "mine";
    errorOf([&] { writer.finish(); });
    EXPECT_EQ(contentOf(film("turn") / "notes.txt"), "mine");
    EXPECT_EQ(entries(), 1);
}

TEST_F(Film, CancelledPicturesLeaveNothingBehind) {
    {
        FilmWriter writer(film("turn"), {8, 8});
        writer.add(plain({8, 8}, {1, 2, 3, 255}));
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(Film, AFrameOfAnotherSizeIsRefusedAndTheFilmGoesOn) {
    FilmWriter writer(film("turn"), {8, 8});
    writer.add(plain({8, 8}, {1, 2, 3, 255}));
    const std::string text = errorOf([&] { writer.add(plain({8, 9}, {1, 2, 3, 255})); });
    EXPECT_NE(text.find("frame 2 has 8 x 9 pixels, the film 8 x 8"), std::string::npos) << text;
    writer.add(plain({8, 8}, {1, 2, 3, 255}));
    writer.finish();
    EXPECT_EQ(writer.frameCount(), 2);
}

TEST_F(Film, WithoutFramesThereIsNoFilm) {
    FilmWriter writer(film("turn"), {8, 8});
    EXPECT_NE(errorOf([&] { writer.finish(); }).find("at least one frame"), std::string::npos);
    EXPECT_EQ(entries(), 0);
}

TEST_F(Film, AMissingFolderIsNamed) {
    for (const std::string name : {"gone/turn", "gone/turn.webm"}) {
        EXPECT_THROW(FilmWriter(film(name), {8, 8}), WriteError);
        const std::string text = errorOf([&] { FilmWriter(film(name), {8, 8}); });
        EXPECT_TRUE(text.starts_with(film(name).string())) << text;
        EXPECT_NE(text.find("gone does not exist"), std::string::npos) << text;
    }
}

TEST_F(Film, AFileIsNoFolderAndAFolderNoFile) {
    std::ofstream(film("turn")) << "a file";
    std::filesystem::create_directories(film("turn.webm"));
    EXPECT_NE(errorOf([&] { FilmWriter(film("turn"), {8, 8}); }).find("is no folder"), std::string::npos);
    EXPECT_NE(errorOf([&] { FilmWriter(film("turn.webm"), {8, 8}); }).find("is a folder"), std::string::npos);
}

TEST_F(Film, WhereNothingCanBeWrittenThisIsSaidAtOnce) {
    if (geteuid() == 0) {
        GTEST_SKIP() << "skipped: root may write everywhere";
    }
    std::filesystem::permissions(folder_ / "films",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    for (const std::string name : {"turn", "turn.webm"}) {
        EXPECT_NE(errorOf([&] {
                      FilmWriter(film(name), {8, 8});
                  }).find("Permission denied"),
                  std::string::npos);
    }
    std::filesystem::permissions(folder_ / "films", std::filesystem::perms::owner_all);
}

} // namespace
} // namespace vs::image
