// SPDX-License-Identifier: Apache-2.0
#include "film_folder.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <vector>

namespace vs::image {
namespace {

// Films made by the real ffmpeg, looked at by ffprobe and by decoding them again.
class RealFilm : public FilmFolder {
protected:
    void SetUp() override {
        FilmFolder::SetUp();
        if (std::system("ffmpeg -version >/dev/null 2>&1 && ffprobe -version >/dev/null 2>&1") != 0) {
            if (std::getenv("CI") != nullptr) {
                FAIL() << "ffmpeg is not installed";
            }
            GTEST_SKIP() << "skipped: ffmpeg is not installed (Debian: apt install ffmpeg)";
        }
    }

    // What ffprobe says of the first stream of a film: "name=value" lines.
    static std::string streamOf(const std::filesystem::path& path) {
        return outputOf("ffprobe -v error -count_frames -show_entries stream:format=duration -of "
                        "default=noprint_wrappers=1 '" +
                        path.string() + "'");
    }
    static bool says(const std::string& stream, const std::string& line) {
        return ("\n" + stream).find("\n" + line + "\n") != std::string::npos;
    }
    static double durationOf(const std::string& stream) {
        return std::stod(stream.substr(stream.rfind("duration=") + 9));
    }

    // The first frame of a film, as a player shows it: by what the film says of its colours.
    [[nodiscard]] Image decoded(const std::filesystem::path& path, glm::ivec2 size) const {
        const std::filesystem::path raw = folder_ / "frame";
        outputOf("ffmpeg -v error -y -sws_flags accurate_rnd+full_chroma_int -i '" + path.string() +
                 "' -frames:v 1 -f rawvideo -pix_fmt rgba '" + raw.string() + "' 2>&1");
        const std::string bytes = contentOf(raw);
        Image image(size.x, size.y);
        EXPECT_EQ(bytes.size(), image.rgba.size());
        std::copy(bytes.begin(), bytes.end(), image.rgba.begin());
        return image;
    }
};

constexpr int kPatch = 64; // pixels
constexpr std::array<glm::u8vec3, 16> kPatches{{{0, 0, 0},
                                                {255, 255, 255},
                                                {255, 0, 0},
                                                {0, 255, 0},
                                                {0, 0, 255},
                                                {255, 255, 0},
                                                {0, 255, 255},
                                                {255, 0, 255},
                                                {8, 8, 8},
                                                {16, 16, 20},
                                                {64, 64, 64},
                                                {128, 128, 128},
                                                {230, 159, 0},
                                                {0, 114, 178},
                                                {213, 94, 0},
                                                {204, 121, 167}}};

Image patches() {
    Image image(4 * kPatch, 4 * kPatch);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::u8vec3 colour = kPatches[std::size_t(y / kPatch * 4 + x / kPatch)];
            const std::array<std::uint8_t, 4> bytes{colour.x, colour.y, colour.z, 255};
            std::copy(bytes.begin(), bytes.end(), image.pixel(x, y));
        }
    }
    return image;
}

// Something that moves: a bright ball on a dark gradient.
Image ball(glm::ivec2 size, int frame) {
    Image image(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const bool isBall = std::hypot(x - 20 - 3 * frame, y - 0.5 * size.y) < 15;
            const auto grey = std::uint8_t(isBall ? 200 : 40 * x / size.x);
            const std::array<std::uint8_t, 4> bytes{grey, grey, std::uint8_t(isBall ? 150 : grey), 255};
            std::copy(bytes.begin(), bytes.end(), image.pixel(x, y));
        }
    }
    return image;
}

TEST_F(RealFilm, HasTheSizeTheFramesAndTheRateThatWereAskedFor) {
    struct Asked {
        const char* name;
        glm::ivec2 size;
        double framesPerSecond;
        int frames;
        std::vector<std::string> lines;
    };
    const std::vector<Asked> films{
        {"a.webm", {161, 121}, 25, 50, {"codec_name=vp9", "width=161", "height=121", "r_frame_rate=25/1"}},
        {"b.mp4", {161, 121}, 24, 30, {"codec_name=h264", "width=160", "height=120", "r_frame_rate=24/1"}},
        {"c.webm", {160, 120}, 30000 / 1001.0, 31, {"width=160", "avg_frame_rate=30000/1001"}},
        {"d.mp4", {160, 120}, 60, 1, {"width=160", "r_frame_rate=60/1"}},
        {"it's 5%d: a film.mp4", {160, 120}, 12.5, 5, {"width=160", "r_frame_rate=25/2"}}};
    for (const Asked& asked : films) {
        FilmWriter writer(film(asked.name), asked.size, {asked.framesPerSecond});
        for (int n = 0; n < asked.frames; ++n) {
            writer.add(ball(asked.size, n));
        }
        writer.finish();
        std::filesystem::rename(film(asked.name), film("looked at")); // quotes need not pass the shell
        const std::string stream = streamOf(film("looked at"));
        for (const std::string& line : asked.lines) {
            EXPECT_TRUE(says(stream, line)) << asked.name << " lacks " << line << "\n" << stream;
        }
        EXPECT_TRUE(says(stream, "nb_read_frames=" + std::to_string(asked.frames))) << stream;
        for (const char* line : {"pix_fmt=yuv420p", "color_range=tv", "color_space=bt709",
                                 "color_transfer=bt709", "color_primaries=bt709"}) {
            EXPECT_TRUE(says(stream, line)) << asked.name << " lacks " << line << "\n" << stream;
        }
        // WebM counts in milliseconds.
        EXPECT_NEAR(durationOf(stream), asked.frames / asked.framesPerSecond, 0.0015) << asked.name;
        std::filesystem::remove(film("looked at"));
        EXPECT_EQ(entries(), 0);
    }
}

// Limited range has 219 levels for 255, and rounds three times: in YCbCr, by the codec, and back.
TEST_F(RealFilm, ColoursComeBack) {
    for (const std::string name : {"a.webm", "a.mp4"}) {
        const Image frame = patches();
        FilmWriter writer(film(name), {frame.width, frame.height});
        for (int n = 0; n < 3; ++n) {
            writer.add(frame);
        }
        writer.finish();
        const Image back = decoded(film(name), {frame.width, frame.height});
        int most = 0;
        for (std::size_t n = 0; n < kPatches.size(); ++n) {
            const glm::ivec2 middle{int(n % 4) * kPatch + kPatch / 2, int(n / 4) * kPatch + kPatch / 2};
            const std::uint8_t* seen = back.pixel(middle.x, middle.y);
            for (int channel = 0; channel < 3; ++channel) {
                const int off = std::abs(int(seen[channel]) - int(kPatches[n][channel]));
                EXPECT_LE(off, 3) << name << ", patch " << n << ", channel " << channel;
                most = std::max(most, off);
            }
        }
        RecordProperty(name, most);
    }
}

// A background from black to a dark grey shows no steps that the picture has not: its levels are there.
TEST_F(RealFilm, DarkBackgroundsKeepTheirLevels) {
    for (const std::string name : {"a.webm", "a.mp4"}) {
        const glm::ivec2 size{640, 128};
        FilmWriter writer(film(name), size);
        for (int n = 0; n < 10; ++n) {
            writer.add(ball(size, n));
        }
        writer.finish();
        const Image back = decoded(film(name), size);
        const Image given = ball(size, 0);
        for (int x = 100; x < size.x; ++x) {
            EXPECT_LE(std::abs(int(back.pixel(x, 100)[1]) - int(given.pixel(x, 100)[1])), 2)
                << name << ", column " << x;
        }
    }
}

TEST_F(RealFilm, CancelledItLeavesNothingBehind) {
    for (const std::string name : {"a.webm", "a.mp4"}) {
        FilmWriter writer(film(name), {160, 120});
        for (int n = 0; n < 5; ++n) {
            writer.add(ball({160, 120}, n));
        }
        EXPECT_FALSE(std::filesystem::exists(film(name)));
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(RealFilm, OnAFullDiskTheOldOneStays) {
    for (const std::string name : {"a.webm", "a.mp4"}) {
        std::ofstream(film(name)) << "old";
        // A limit on the size of files, which the encoder inherits, ends writing as a full disk does.
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit full{3000, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &full);
        const std::string text = errorOf([&] {
            FilmWriter writer(film(name), {160, 120});
            for (int n = 0; n < 60; ++n) {
                writer.add(ball({160, 120}, n));
            }
            writer.finish();
        });
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        EXPECT_TRUE(text.starts_with(film(name).string() + ": cannot be written (File too large)")) << text;
        EXPECT_EQ(contentOf(film(name)), "old");
        std::filesystem::remove(film(name));
    }
    EXPECT_EQ(entries(), 0);
}

} // namespace
} // namespace vs::image
