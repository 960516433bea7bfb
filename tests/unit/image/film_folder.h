// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "image/film.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

namespace vs::image {

// Tests that write films into a folder of their own, with the real encoder or with one that is a script.
class FilmFolder : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("vs_film_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_ / "films");
    }
    void TearDown() override {
        unsetenv("VOLUME_STUDIO_FFMPEG");
        std::filesystem::remove_all(folder_);
    }

    [[nodiscard]] std::filesystem::path film(const std::string& name) const {
        return folder_ / "films" / name;
    }
    // The number of files and folders beside the films, hidden ones too.
    [[nodiscard]] long entries() const {
        return std::distance(std::filesystem::directory_iterator(folder_ / "films"), {});
    }

    // From here on films are made by a program of these lines, for the shell. "$film" is what it is to write.
    void encodeBy(const std::string& lines) const {
        const std::filesystem::path script = folder_ / "encoder";
        std::ofstream(script) << "#!/bin/sh\nfor last; do :; done\nfilm=${last#file:}\n" << lines << "\n";
        std::filesystem::permissions(script, std::filesystem::perms::owner_all);
        setenv("VOLUME_STUDIO_FFMPEG", script.c_str(), 1);
    }

    static std::string contentOf(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }

    // What a command prints.
    static std::string outputOf(const std::string& command) {
        std::string output;
        FILE* pipe = popen(command.c_str(), "r");
        for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
            output += char(c);
        }
        pclose(pipe);
        return output;
    }

    // The text of the error that `work` throws, which must be one line.
    static std::string errorOf(const std::function<void()>& work) {
        try {
            work();
        } catch (const Error& error) {
            std::string text = error.what();
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            return text;
        }
        ADD_FAILURE() << "no error";
        return {};
    }

    static Image plain(glm::ivec2 size, glm::u8vec4 colour) {
        Image image(size.x, size.y);
        for (std::size_t n = 0; n < image.rgba.size(); ++n) {
            image.rgba[n] = colour[int(n % 4)];
        }
        return image;
    }

    std::filesystem::path folder_;
};

} // namespace vs::image
