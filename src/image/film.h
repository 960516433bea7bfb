// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

#include <glm/glm.hpp>

#include <array>
#include <filesystem>
#include <memory>

namespace vs::image {

// What a film is kept as: VP9 in WebM, H.264 in MP4, or a folder of PNGs that are numbered from 1. The
// program ffmpeg makes the first two.
enum class FilmFormat { WebM, Mp4, Pngs };
inline constexpr std::array<const char*, 3> kFilmFormats{"webm", "mp4", "pngs"};
constexpr const auto& namesOf(FilmFormat) { return kFilmFormats; }

// How much of fine structure and of dark, smooth backgrounds a film keeps. Good ones look like their
// pictures; small ones are about half as large, fine ones about twice. PNGs keep everything.
enum class FilmQuality { Small, Good, Fine };
inline constexpr std::array<const char*, 3> kFilmQualities{"small", "good", "fine"};
constexpr const auto& namesOf(FilmQuality) { return kFilmQualities; }

struct FilmSettings {
    double framesPerSecond = 30; // 1 to 240; PNGs have none
    FilmQuality quality = FilmQuality::Good;
};

// The format that a name asks for by its ending: .webm, .mp4, and for PNGs .png or none. Throws Error naming
// the file for any other.
FilmFormat filmFormatOf(const std::filesystem::path& path);

// The size in pixels that a film has whose frames have `size`. H.264 keeps colours of two by two pixels, so
// that an odd last column or row is left out there; the others keep every size.
glm::ivec2 filmSize(FilmFormat format, glm::ivec2 size);

// Writes a film frame by frame. Nothing stands at `path` (or what stood there stays) until finish(), and
// without finish() nothing is left behind. Numbered PNGs called "turn" or "turn.png" are turn/turn_0001.png
// and so on; such a folder is replaced when it has nothing else in it.
//
// Waiting for ffmpeg reports progress (base/progress.h) without a share, so that whoever listens can end a
// film whose encoder hangs: GivenUp is thrown then. To be used from one thread at a time.
class FilmWriter {
public:
    // Throws Error when the name, the size or the settings cannot be a film's, or when there is no ffmpeg;
    // WriteError when nothing can be written there. Each names the file in one line. The environment variable
    // VOLUME_STUDIO_FFMPEG names another ffmpeg.
    FilmWriter(const std::filesystem::path& path, glm::ivec2 size, const FilmSettings& settings = {});
    ~FilmWriter(); // without finish(): gives the film up and ends the encoder
    FilmWriter(FilmWriter&&) noexcept;
    FilmWriter& operator=(FilmWriter&&) noexcept;

    // Adds a frame. Films have no transparency, so what is transparent lies on white there; PNGs keep it.
    // Throws Error for a frame of another size, and leaves the film as it was; WriteError when the film
    // cannot be written any more; nothing can be added then.
    void add(const Image& frame);
    // Puts the film in its place; nothing can be added any more. Throws Error when no frame was added, and
    // WriteError when the film could not be written.
    void finish();

    [[nodiscard]] int frameCount() const { return frameCount_; }
    // The size of the film in pixels: filmSize() of the frames' size.
    [[nodiscard]] glm::ivec2 size() const { return filmSize(format_, frameSize_); }

private:
    std::filesystem::path path_;
    FilmFormat format_;
    glm::ivec2 frameSize_;
    int frameCount_ = 0;
    std::unique_ptr<class FilmSink> sink_; // null once the film is whole or has failed
};

} // namespace vs::image
