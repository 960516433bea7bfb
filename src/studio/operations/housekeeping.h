// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/marks/background.h"
#include "studio/operations/drawing.h"

#include <array>
#include <variant>

namespace vs::studio {

// The operations that go through the history, remark on it, and write what there is into files.

struct Undo {
    static constexpr About kAbout{VS_TEXT("library", "undo"), Effect::Travels, "one edit back"};
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{};
    }
};

struct Redo {
    static constexpr About kAbout{VS_TEXT("library", "redo"), Effect::Travels, "one edit forward"};
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{};
    }
};

// Clears all cuts.
struct UnCut {
    static constexpr About kAbout{VS_TEXT("library", "un-cut"), Effect::ClearsCuts, "clears all cuts",
                                  "uncut"};
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{};
    }
};

inline constexpr int kMostNote = 1000; // bytes of UTF-8

// A line of text for those who read the history: why something was done, what to look at. Changes nothing
// else.
struct Note {
    static constexpr About kAbout{VS_TEXT("library", "note"), Effect::Remarks,
                                  "stands in the history to be read; changes nothing", "note"};

    std::string text;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("text", &Note::text, {.leastCount = 1, .mostCount = kMostNote})};
    }
    [[nodiscard]] std::vector<Phrase> details() const { return {{"%1", {text}}}; }
};

inline constexpr Rule kOutputFile{.isOutputFile = true};

// Which strokes a picture shows over what it shows.
enum class ShownStrokes { None, Next, Last };
inline constexpr std::array<const char*, 3> kShownStrokes{"none", "next", "last"};
constexpr const auto& namesOf(ShownStrokes) { return kShownStrokes; }

// Writes the view as a PNG into the output folder, with a scale bar and an orientation marker if asked for.
// Does not change the document.
struct SavePicture {
    static constexpr About kAbout{VS_TEXT("library", "picture"), Effect::Writes, "writes the view as PNG"};

    std::string file;
    glm::ivec2 size{1230, 870};
    int samples = 8;
    render::Background background = {};
    bool annotations = false;
    ShownStrokes strokes = ShownStrokes::None;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SavePicture::file, kOutputFile),
                          written("size", &SavePicture::size, kPictureSize),
                          written("samples", &SavePicture::samples, {.least = 1, .most = 256}, "a pixel"),
                          written("background", &SavePicture::background),
                          written("annotations", &SavePicture::annotations),
                          sparse("strokes", &SavePicture::strokes, {},
                                 "what the pen drew last, or draws next in the session, over it")};
    }
    [[nodiscard]] Fault faultOf() const;
};

// Writes the segments as a label map (uint8, numbered in the order they were made, 0 = none) into the output
// folder; a name that ends in .zarr makes a store with levels, here and of the sculpture.
struct SaveLabels {
    static constexpr About kAbout{
        VS_TEXT("library", "labels"), Effect::Writes,
        "writes the segments as a label map (uint8, numbered in the order they were made)"};

    std::string file;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SaveLabels::file, kOutputFile)};
    }
};

// Writes the sculpture volume (float, 0 untouched .. 1 cut away) into the output folder; into a store at the
// finest level of the scan.
struct SaveSculpture {
    static constexpr About kAbout{VS_TEXT("library", "sculpture"), Effect::Writes,
                                  "writes the sculpture volume (float, 0 untouched to 1 cut away)"};

    std::string file;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SaveSculpture::file, kOutputFile)};
    }
};

using HousekeepingOperations = std::variant<Undo, Redo, UnCut, Note, SavePicture, SaveLabels, SaveSculpture>;

} // namespace vs::studio
