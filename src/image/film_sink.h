// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/atomic_file.h"
#include "image/film.h"

#include <string>

// What both kinds of films are made of; for the files that write them.
namespace vs::image {

// Takes the frames of one film, which all have the film's size. Destroyed without finish(), or when that has
// thrown, it leaves nothing behind.
class FilmSink {
public:
    FilmSink() = default;
    virtual ~FilmSink() = default;
    FilmSink(const FilmSink&) = delete;
    FilmSink& operator=(const FilmSink&) = delete;

    virtual void add(const Image& frame) = 0;
    virtual void finish() = 0;
};

// Frames may be larger than `size` (even for H.264) by a last column or row, which is left out.
std::unique_ptr<FilmSink> openEncodedFilm(const std::filesystem::path& path, FilmFormat format,
                                          glm::ivec2 size, const FilmSettings& settings);
std::unique_ptr<FilmSink> openNumberedPictures(const std::filesystem::path& path);

// The text with every `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to);

} // namespace vs::image
