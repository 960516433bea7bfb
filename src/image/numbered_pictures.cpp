// SPDX-License-Identifier: Apache-2.0
#include "image/film_sink.h"

#include "base/error.h"
#include "base/folder.h"

#include <algorithm>

namespace vs::image {

namespace {

// The folder that a name asks for: "turn" for "turn", "turn/" and "turn.png". Links are followed, so that
// they stay.
std::filesystem::path pictureFolder(std::filesystem::path path) {
    if (path.has_filename()) {
        path.replace_extension(); // there is none but .png
    } else {
        path = path.parent_path();
    }
    return std::filesystem::weakly_canonical(path);
}

// Whether a file is called "turn_0001.png", with more digits where four are too few.
bool isNumbered(const std::filesystem::path& file, const std::string& name) {
    const std::string text = file.filename().string();
    const std::string begin = name + "_";
    const std::string end = ".png";
    return text.size() >= begin.size() + 4 + end.size() && text.starts_with(begin) && text.ends_with(end) &&
           std::all_of(text.begin() + long(begin.size()), text.end() - long(end.size()),
                       [](char c) { return c >= '0' && c <= '9'; });
}

// Throws WriteError unless there is nothing at `folder` or a folder of numbered pictures of that name, which
// may be replaced: nothing else may be lost.
void checkReplaceable(const std::filesystem::path& folder, const std::filesystem::path& path) {
    std::error_code fault;
    const auto status = std::filesystem::status(folder, fault);
    if (!std::filesystem::exists(status)) {
        return;
    }
    if (!std::filesystem::is_directory(status)) {
        throw WriteError("{}: is no folder, which numbered pictures need; give another name", path.string());
    }
    const std::string name = folder.filename().string();
    for (const auto& entry : entriesOf(folder, fault)) {
        if (!isNumbered(entry, name) || !std::filesystem::is_regular_file(entry)) {
            throw WriteError("{}: has something else in it ({}) than numbered pictures; choose a folder that "
                             "is empty or new",
                             path.string(), entry.filename().string());
        }
    }
    if (fault) {
        refuseToWrite(path, fault.message());
    }
}

class NumberedPictures : public FilmSink {
public:
    explicit NumberedPictures(const std::filesystem::path& path)
        : path_(path), target_(pictureFolder(path)), unfinished_(temporaryBeside(target_, path)) {
        checkReplaceable(target_, path);
        removeAll(unfinished_.path()); // of a program that broke down
        std::error_code fault;
        std::filesystem::create_directory(unfinished_.path(), fault);
        if (fault) {
            refuseToWrite(path, fault.message());
        }
    }

    void add(const Image& frame) override {
        const std::string file = fmt::format("{}_{:04}.png", target_.filename().string(), ++count_);
        try {
            writePng(unfinished_.path() / file, frame);
        } catch (const WriteError& error) {
            throw WriteError("{}", replaced(error.what(), unfinished_.path().string(), target_.string()));
        }
    }

    // A folder with something in it cannot be replaced in one go. The old one steps aside first, and comes
    // back if the new one cannot take its place.
    void finish() override {
        checkReplaceable(target_, path_);
        const std::filesystem::path old = unfinished_.path().string() + ".old";
        std::error_code none;
        std::filesystem::rename(target_, old, none);
        std::error_code fault;
        std::filesystem::rename(unfinished_.path(), target_, fault);
        if (fault) {
            std::filesystem::rename(old, target_, none);
            refuseToWrite(path_, fault.message());
        }
        removeAll(old);
    }

private:
    std::filesystem::path path_;   // as the person calls it
    std::filesystem::path target_; // the folder
    Leftover unfinished_;
    int count_ = 0;
};

} // namespace

std::unique_ptr<FilmSink> openNumberedPictures(const std::filesystem::path& path) {
    return std::make_unique<NumberedPictures>(path);
}

} // namespace vs::image
