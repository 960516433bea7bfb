// SPDX-License-Identifier: Apache-2.0
#include "image/film.h"

#include "base/check.h"
#include "base/error.h"
#include "image/film_sink.h"

#include <algorithm>
#include <utility>

namespace vs::image {

namespace {

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

void checkFilm(const std::filesystem::path& path, FilmFormat format, glm::ivec2 size,
               const FilmSettings& settings) {
    const glm::ivec2 kept = filmSize(format, size);
    if (kept.x < 1 || kept.y < 1) {
        throw Error("{}: a film of {} x {} pixels has no pictures; give it 2 x 2 or more", path.string(),
                    size.x, size.y);
    }
    // Written so that what is not a number is refused too.
    if (!(settings.framesPerSecond >= 1 && settings.framesPerSecond <= 240)) {
        throw Error("{}: {} frames per second are too few or too many; give 1 to 240", path.string(),
                    settings.framesPerSecond);
    }
}

} // namespace

FilmFormat filmFormatOf(const std::filesystem::path& path) {
    const std::string ending = lowerCase(path.extension().string());
    if (ending == ".webm") {
        return FilmFormat::WebM;
    }
    if (ending == ".mp4") {
        return FilmFormat::Mp4;
    }
    if (!path.empty() && (ending.empty() || ending == ".png")) {
        return FilmFormat::Pngs;
    }
    throw Error(
        "{}: a film's name ends in .webm or .mp4; one without an ending is a folder of numbered pictures",
        path.string());
}

glm::ivec2 filmSize(FilmFormat format, glm::ivec2 size) {
    return format == FilmFormat::Mp4 ? size / 2 * 2 : size;
}

FilmWriter::FilmWriter(const std::filesystem::path& path, glm::ivec2 size, const FilmSettings& settings)
    : path_(path), format_(filmFormatOf(path)), frameSize_(size) {
    checkFilm(path, format_, size, settings);
    sink_ = format_ == FilmFormat::Pngs ? openNumberedPictures(path)
                                        : openEncodedFilm(path, format_, this->size(), settings);
}

FilmWriter::~FilmWriter() = default;
FilmWriter::FilmWriter(FilmWriter&&) noexcept = default;
FilmWriter& FilmWriter::operator=(FilmWriter&&) noexcept = default;

void FilmWriter::add(const Image& frame) {
    VS_CHECK(sink_ != nullptr);
    if (frame.width != frameSize_.x || frame.height != frameSize_.y) {
        throw Error("{}: frame {} has {} x {} pixels, the film {} x {}; give all frames one size",
                    path_.string(), frameCount_ + 1, frame.width, frame.height, frameSize_.x, frameSize_.y);
    }
    // Out of its place while it works: it is gone when it throws.
    std::unique_ptr<FilmSink> sink = std::move(sink_);
    sink->add(frame);
    sink_ = std::move(sink);
    ++frameCount_;
}

void FilmWriter::finish() {
    VS_CHECK(sink_ != nullptr);
    const std::unique_ptr<FilmSink> sink = std::move(sink_);
    if (frameCount_ == 0) {
        throw Error("{}: a film needs at least one frame", path_.string());
    }
    sink->finish();
}

} // namespace vs::image
