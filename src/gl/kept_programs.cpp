// SPDX-License-Identifier: Apache-2.0
#include "gl/kept_programs.h"

#include "base/atomic_file.h"
#include "base/folder.h"
#include "base/hash.h"
#include "base/user_folders.h"

#include <epoxy/gl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <initializer_list>
#include <numeric>
#include <string_view>
#include <vector>

namespace vs::gl {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstWord = "volume-studio-program-1";
constexpr std::uintmax_t kMostBytes = std::uintmax_t(64) << 20;

std::string hashOf(std::initializer_list<std::string_view> texts) {
    Hash64 hash;
    for (const std::string_view text : texts) {
        hash.add(std::as_bytes(std::span(text)));
    }
    return hash.text();
}

std::string driver() {
    std::string names;
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
        const auto* said = reinterpret_cast<const char*>(glGetString(name));
        names += fmt::format("{}\n", said != nullptr ? said : "");
    }
    return names;
}

fs::path folder() { return cacheFolder() / "volume-studio" / "programs"; }

// A program's file begins with this line, and is as long as it says: what stands in a file of that name from
// another driver, from another text, or cut short, is not taken.
struct Heading {
    std::string made; // hash of text and driver, the other way round than in the file's name
    GLenum format = 0;
    std::size_t bytes = 0;
    std::string content; // hash of the bytes

    [[nodiscard]] std::string line() const {
        return fmt::format("{} {} {} {} {}\n", kFirstWord, made, format, bytes, content);
    }
};

struct Place {
    fs::path file;
    std::string made;
};

Place placeOf(const std::string& text) {
    const std::string by = driver();
    return {folder() / hashOf({by, text}), hashOf({text, by})};
}

bool isTaken(GLenum format) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    std::vector<GLint> formats(std::size_t(std::max(count, 0)));
    if (count > 0) {
        glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    }
    return std::find(formats.begin(), formats.end(), GLint(format)) != formats.end();
}

// Removes the oldest files where all together have become too many: texts and drivers change, and what was
// made of old ones is asked for no more.
void makeRoom() {
    struct Kept {
        fs::path file;
        time_t changed;
        std::uintmax_t bytes;
    };
    std::vector<Kept> all;
    for (const auto& file : entriesOf(folder())) {
        struct stat status {};
        if (::stat(file.c_str(), &status) == 0) {
            all.push_back({file, status.st_mtime, std::uintmax_t(status.st_size)});
        }
    }
    auto bytes = std::accumulate(all.begin(), all.end(), std::uintmax_t(0),
                                 [](std::uintmax_t sum, const Kept& kept) { return sum + kept.bytes; });
    if (bytes <= kMostBytes) {
        return;
    }
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.changed < b.changed; });
    for (std::size_t i = 0; i < all.size() && bytes > kMostBytes / 2; ++i) {
        removeAll(all[i].file);
        bytes -= all[i].bytes;
    }
}

// Under another name first, so that nobody reads half a file; not synced, since what is torn is not taken.
void write(const fs::path& file, const std::string& content) {
    static std::atomic<int> count = 0;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (static std::atomic_flag isRoomy; !isRoomy.test_and_set()) {
        makeRoom();
    }
    const Leftover part(fmt::format("{}.{}.{}", file.string(), getpid(), ++count));
    std::ofstream(part.path(), std::ios::binary) << content;
    if (fs::file_size(part.path(), error) == content.size()) {
        fs::rename(part.path(), file, error);
    }
}

} // namespace

unsigned int loadKeptProgram(const std::string& text) {
    const Place place = placeOf(text);
    std::ifstream file(place.file, std::ios::binary);
    std::string first;
    Heading heading;
    if (!(file >> first >> heading.made >> heading.format >> heading.bytes >> heading.content) ||
        first != kFirstWord || heading.made != place.made || heading.bytes > kMostBytes ||
        !isTaken(heading.format)) {
        return 0;
    }
    std::string content(heading.bytes, '\0');
    file.ignore(1);
    if (!file.read(content.data(), std::streamsize(content.size())) || hashOf({content}) != heading.content) {
        return 0;
    }
    const GLuint program = glCreateProgram();
    glProgramBinary(program, heading.format, content.data(), GLsizei(content.size()));
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (isLinked != GL_TRUE) {
        glDeleteProgram(program);
        return 0;
    }
    return program;
}

void keepProgram(unsigned int program, const std::string& text) {
    GLint bytes = 0;
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &bytes);
    if (bytes <= 0) {
        return;
    }
    std::string content(std::size_t(bytes), '\0');
    GLenum format = 0;
    glGetProgramBinary(program, bytes, &bytes, &format, content.data());
    content.resize(std::size_t(std::max(bytes, 0)));
    const Place place = placeOf(text);
    const Heading heading{place.made, format, content.size(), hashOf({content})};
    write(place.file, heading.line() + content);
}

} // namespace vs::gl
