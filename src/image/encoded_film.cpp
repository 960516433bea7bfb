// SPDX-License-Identifier: Apache-2.0
#include "image/film_sink.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "image/encoder_process.h"

#include <fcntl.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace vs::image {

namespace {

using Words = std::vector<std::string>;

std::string encoderProgram() {
    const char* given = std::getenv("VOLUME_STUDIO_FFMPEG");
    return given != nullptr && *given != '\0' ? given : "ffmpeg";
}

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

// Frames are sRGB from 0 to 255; films are YCbCr from 16 to 235 by BT.709, and say so, or players would guess
// by the film's size. Unless it is told, ffmpeg takes colours from every second pixel only and rounds fast:
// thin coloured lines would break up and flat colours be off.
std::string colourFilter() {
    return "scale=in_range=full:out_range=limited:out_color_matrix=bt709"
           ":flags=bicubic+accurate_rnd+full_chroma_inp+full_chroma_int,format=yuv420p"
           ",setparams=range=limited:color_primaries=bt709:color_trc=bt709:colorspace=bt709";
}

// The quality that an encoder keeps constant, less for better ones. Good: the smallest at which smooth dark
// backgrounds show no steps and a turning skull none of its texture lost, by eye and by SSIM (0.994).
std::string rateFactor(FilmFormat format, FilmQuality quality) {
    constexpr std::array<int, 3> vp9{32, 24, 16};
    constexpr std::array<int, 3> h264{23, 18, 13};
    return std::to_string((format == FilmFormat::WebM ? vp9 : h264)[std::size_t(quality)]);
}

Words encoderOptions(FilmFormat format, FilmQuality quality) {
    const std::string factor = rateFactor(format, quality);
    if (format == FilmFormat::WebM) {
        return {"-c:v", "libvpx-vp9", "-crf", factor,      "-b:v", "0",  "-row-mt",
                "1",    "-deadline",  "good", "-cpu-used", "4",    "-f", "webm"};
    }
    // The mode 3 of adaptive quantisation spends more on dark areas; the index goes to the file's beginning,
    // so that it plays while it is loaded.
    return {"-c:v", "libx264",  "-preset", "medium",    "-crf",       factor, "-profile:v",
            "high", "-aq-mode", "3",       "-movflags", "+faststart", "-f",   "mp4"};
}

Words encoderCommand(const std::filesystem::path& file, FilmFormat format, glm::ivec2 size,
                     const FilmSettings& settings) {
    // Two seconds between frames that can be jumped to.
    const long jumps = std::max(1L, std::lround(2 * settings.framesPerSecond));
    Words command{encoderProgram(), "-hide_banner", "-nostdin", "-nostats",
                  "-loglevel",      "error",        "-xerror",  "-y"};
    append(command,
           {"-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size", fmt::format("{}x{}", size.x, size.y),
            "-framerate", fmt::format("{}", settings.framesPerSecond), "-i", "pipe:0"});
    append(command, {"-vf", colourFilter(), "-color_range", "tv", "-color_primaries", "bt709", "-color_trc",
                     "bt709", "-colorspace", "bt709", "-g", std::to_string(jumps)});
    append(command, encoderOptions(format, settings.quality));
    command.push_back("file:" + file.string()); // or a colon in the name would be taken for a protocol
    return command;
}

// The frame's red, green and blue bytes as it looks on white paper, of its first `size` columns and rows.
void layOnWhite(const Image& frame, glm::ivec2 size, std::vector<std::uint8_t>& rgb) {
    rgb.resize(3 * std::size_t(size.x) * std::size_t(size.y));
    std::uint8_t* to = rgb.data();
    for (int y = 0; y < size.y; ++y) {
        const std::uint8_t* from = frame.pixel(0, y);
        for (int x = 0; x < size.x; ++x, from += 4, to += 3) {
            const int alpha = from[3];
            for (int channel = 0; channel < 3; ++channel) {
                to[channel] = std::uint8_t((from[channel] * alpha + 255 * (255 - alpha) + 127) / 255);
            }
        }
    }
}

// So that what cannot be written is known before the first frame, and in the words of all files.
void makeEmptyFile(const std::filesystem::path& file, const std::filesystem::path& path) {
    const Descriptor made(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (made.number() < 0) {
        refuseToWrite(path, std::strerror(errno));
    }
}

class EncodedFilm : public FilmSink {
public:
    EncodedFilm(const std::filesystem::path& path, FilmFormat format, glm::ivec2 size,
                const FilmSettings& settings)
        : path_(path), size_(size), unfinished_(temporaryBeside(outputFile(path), path)) {
        makeEmptyFile(unfinished_.path(), path);
        const Words command = encoderCommand(unfinished_.path(), format, size, settings);
        try {
            encoder_ = EncoderProcess::start(command);
        } catch (const Error& error) {
            throw Error("{}: {}", path.string(), error.what());
        }
        if (encoder_ == nullptr) {
            throw Error("{}: films need the program {}, which is not installed (Debian: apt install ffmpeg); "
                        "numbered pictures (a folder) need none",
                        path.string(), command[0]);
        }
    }

    void add(const Image& frame) override {
        layOnWhite(frame, size_, rgb_);
        if (!encoder_->give(rgb_)) {
            fail(encoder_->finish(std::chrono::seconds(3)).said); // it has failed, and is about to end
        }
    }

    void finish() override {
        const EncoderProcess::Ending ending = encoder_->finish();
        std::error_code ignored;
        if (!ending.isGood || std::filesystem::file_size(unfinished_.path(), ignored) == 0) {
            fail(ending.said);
        }
        writeAtomically(path_, [&](const std::filesystem::path& temporary) {
            std::filesystem::rename(unfinished_.path(), temporary);
        });
    }

private:
    [[noreturn]] void fail(const std::string& said) const {
        const std::string hidden = unfinished_.path().string();
        if (const auto reason = reasonNotFilled(hidden, ""); !reason.empty()) {
            refuseToWrite(path_, reason);
        }
        const std::string bare = replaced(said, "file:" + hidden, hidden);
        throw WriteError("{}: ffmpeg failed: {}", path_.string(), replaced(bare, hidden, path_.string()));
    }

    std::filesystem::path path_;
    glm::ivec2 size_;
    Leftover unfinished_; // outlives the encoder, which might write it again
    std::unique_ptr<EncoderProcess> encoder_;
    std::vector<std::uint8_t> rgb_; // the frame that is given
};

} // namespace

std::unique_ptr<FilmSink> openEncodedFilm(const std::filesystem::path& path, FilmFormat format,
                                          glm::ivec2 size, const FilmSettings& settings) {
    return std::make_unique<EncodedFilm>(path, format, size, settings);
}

} // namespace vs::image
