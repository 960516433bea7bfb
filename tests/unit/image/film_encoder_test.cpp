// SPDX-License-Identifier: Apache-2.0
#include "film_folder.h"

#include "base/progress.h"
#include "image/encoder_process.h"

#include <sys/resource.h>

#include <cerrno>
#include <chrono>
#include <csignal>

namespace vs::image {
namespace {

using FilmEncoder = FilmFolder;
using Seconds = std::chrono::duration<double>;

constexpr glm::ivec2 kSize{320, 240};

// Adds more frames than the way to an encoder has room for, and finishes.
void writeFilm(const std::filesystem::path& path, const Image& frame) {
    FilmWriter writer(path, kSize);
    for (int n = 0; n < 10; ++n) {
        writer.add(frame);
    }
    writer.finish();
}

TEST_F(FilmEncoder, WithoutOneTheErrorSaysWhatIsMissing) {
    setenv("VOLUME_STUDIO_FFMPEG", "vs-no-such-program", 1);
    const std::string text = errorOf([&] { FilmWriter(film("clip.webm"), kSize); });
    EXPECT_EQ(text, film("clip.webm").string() +
                        ": films need the program vs-no-such-program, which is not installed (Debian: apt "
                        "install ffmpeg); numbered pictures (a folder) need none");
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, OneThatCannotBeRunIsNamed) {
    encodeBy("exit 0");
    std::filesystem::permissions(folder_ / "encoder", std::filesystem::perms::owner_read);
    const std::string text = errorOf([&] { FilmWriter(film("clip.webm"), kSize); });
    EXPECT_NE(text.find("cannot be started (Permission denied)"), std::string::npos) << text;
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, WhatItWroteIsTheFilm) {
    encodeBy("cat >$film");
    writeFilm(film("clip.webm"), plain(kSize, {10, 20, 30, 255}));
    EXPECT_EQ(std::filesystem::file_size(film("clip.webm")), 10U * 320 * 240 * 3);
    EXPECT_EQ(contentOf(film("clip.webm")).substr(0, 3), "\x0a\x14\x1e");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FilmEncoder, WhatIsTransparentLiesOnWhite) {
    encodeBy("cat >$film");
    FilmWriter writer(film("clip.mp4"), {3, 2});
    EXPECT_EQ(writer.size(), glm::ivec2(2, 2));
    Image frame = plain({3, 2}, {100, 0, 255, 0});
    frame.pixel(1, 0)[3] = 51; // a fifth
    writer.add(frame);
    writer.finish();
    EXPECT_EQ(contentOf(film("clip.mp4")), "\xff\xff\xff\xe0\xcc\xff\xff\xff\xff\xff\xff\xff");
}

TEST_F(FilmEncoder, WhenItFailsItsLastLineIsSaidAndTheOldFilmStays) {
    std::ofstream(film("clip.webm")) << "old";
    encodeBy("echo first >&2; cat >/dev/null; echo half >$film\n"
             "echo \"[vp9 @ 0x5600] $film: it broke\" >&2; echo 'Conversion failed!' >&2; exit 1");
    const std::string text = errorOf([&] { writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})); });
    const std::string name = film("clip.webm").string();
    EXPECT_EQ(text, name + ": ffmpeg failed: " + name + ": it broke");
    EXPECT_EQ(contentOf(film("clip.webm")), "old");
    EXPECT_EQ(entries(), 1);
}

// An encoder that ends while it is sent frames would end this program by SIGPIPE if nobody cared.
TEST_F(FilmEncoder, OneThatEndsEarlyEndsNobodyElse) {
    ASSERT_NE(std::signal(SIGPIPE, SIG_DFL), SIG_ERR);
    encodeBy("head -c 1000 >/dev/null; echo 'no room for thoughts' >&2; exit 3");
    const std::string text = errorOf([&] { writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})); });
    EXPECT_NE(text.find("ffmpeg failed: no room for thoughts"), std::string::npos) << text;
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, OneThatSaysNothingIsKnownByItsStatus) {
    encodeBy("exit 7");
    EXPECT_NE(errorOf([&] {
                  writeFilm(film("a.webm"), plain(kSize, {1, 2, 3, 255}));
              }).find("status 7"),
              std::string::npos);
    encodeBy("kill -9 $$");
    EXPECT_NE(errorOf([&] {
                  writeFilm(film("a.webm"), plain(kSize, {1, 2, 3, 255}));
              }).find("signal 9"),
              std::string::npos);
}

// One small frame has room on the way to the encoder, so that adding it does not fail. The encoder takes a
// byte, or it might have ended before the frame was sent.
TEST_F(FilmEncoder, ASuccessThatLeftFramesUnreadIsNone) {
    encodeBy("echo half >$film; dd bs=1 count=1 of=/dev/null 2>/dev/null; exit 0");
    FilmWriter writer(film("clip.webm"), {8, 8});
    writer.add(plain({8, 8}, {1, 2, 3, 255}));
    const std::string text = errorOf([&] { writer.finish(); });
    EXPECT_NE(text.find("it ended before the film did"), std::string::npos) << text;
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, ASuccessThatWroteNothingIsNone) {
    encodeBy("cat >/dev/null; exit 0");
    errorOf([&] { writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})); });
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, OneThatTalksALotIsListenedTo) {
    encodeBy(
        "head -c 1000000 /dev/zero | tr '\\0' 'x' >&2; echo >&2; cat >$film; echo 'the end' >&2; exit 1");
    const std::string text = errorOf([&] { writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})); });
    EXPECT_TRUE(text.ends_with("ffmpeg failed: the end")) << text;
}

// Both while it is given frames and while it is waited for, one that hangs is ended by whoever gives up, with
// the programs that it has started.
TEST_F(FilmEncoder, OneThatHangsIsEndedByGivingUp) {
    for (const std::string reads : {"", "cat >/dev/null; "}) {
        encodeBy("echo half >$film; " + reads + "sleep 1000 & echo $! $$ >" + (folder_ / "ids").string() +
                 "; wait");
        const auto begin = std::chrono::steady_clock::now();
        const auto lasts = [&] { return Seconds(std::chrono::steady_clock::now() - begin).count(); };
        const ProgressListener listener([&](std::optional<double>) { return lasts() < 0.5; });
        EXPECT_THROW(writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})), GivenUp);
        EXPECT_LT(lasts(), 10) << "seconds: on a busy machine";
        EXPECT_EQ(entries(), 0);
        std::ifstream ids(folder_ / "ids");
        pid_t child = 0;
        pid_t encoder = 0;
        ids >> child >> encoder;
        ASSERT_GT(child, 0);
        EXPECT_EQ(kill(encoder, 0), -1) << "it was not reaped";
        // Its child has been killed too, and dies as soon as it gets a processor; left alone it would sleep
        // on for a quarter of an hour. Nobody may have reaped it yet, for it has become an orphan.
        const auto state = [&] { return contentOf("/proc/" + std::to_string(child) + "/stat"); };
        const auto isDead = [&] { return state().empty() || state().find(") Z ") != std::string::npos; };
        while (!isDead() && lasts() < 60) {
            usleep(1000);
        }
        EXPECT_TRUE(isDead()) << state();
    }
}

TEST_F(FilmEncoder, CancellingEndsOneThatHangs) {
    encodeBy("echo half >$film; echo $$ >" + (folder_ / "ids").string() + "; exec sleep 1000");
    {
        FilmWriter writer(film("clip.webm"), {8, 8});
        writer.add(plain({8, 8}, {1, 2, 3, 255}));
        while (contentOf(folder_ / "ids").empty()) {
            usleep(1000);
        }
    }
    EXPECT_EQ(kill(std::stoi(contentOf(folder_ / "ids")), 0), -1);
    EXPECT_EQ(errno, ESRCH);
    EXPECT_EQ(entries(), 0);
}

// One that closes its input says that it has failed; one that then does not end is not waited for.
TEST_F(FilmEncoder, OneThatHangsAfterItFailedIsEnded) {
    encodeBy("exec <&-; echo 'it broke' >&2; exec sleep 1000");
    const std::string text = errorOf([&] { writeFilm(film("clip.webm"), plain(kSize, {1, 2, 3, 255})); });
    EXPECT_TRUE(text.ends_with("ffmpeg failed: it broke")) << text;
}

// A limit on the size of files ends writing as a full disk does.
TEST_F(FilmEncoder, NumberedPicturesOnAFullDiskNameTheFile) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit full{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    Image frame(64, 64);
    for (std::size_t n = 0; n < frame.rgba.size(); ++n) {
        frame.rgba[n] = std::uint8_t((n * n * 2654435761U) >> 13); // does not compress
    }
    const std::string text = errorOf([&] {
        FilmWriter writer(film("turn"), {64, 64});
        writer.add(frame);
    });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_NE(text.find("turn/turn_0001.png: cannot be written"), std::string::npos) << text;
    EXPECT_EQ(text.find(".part"), std::string::npos) << text;
    EXPECT_EQ(entries(), 0);
}

TEST_F(FilmEncoder, TheTellingLineIsFound) {
    EXPECT_EQ(lastTellingLine(""), "");
    EXPECT_EQ(lastTellingLine("\n\r\n"), "");
    EXPECT_EQ(lastTellingLine("one\ntwo"), "two");
    EXPECT_EQ(lastTellingLine("[libx264 @ 0x55d0] width not divisible\nConversion failed!\n"),
              "width not divisible");
    EXPECT_EQ(lastTellingLine("[out#0] stays\n"), "[out#0] stays");
}

} // namespace
} // namespace vs::image
