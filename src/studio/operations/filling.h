// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/housekeeping.h"
#include "studio/operations/sculpting.h"
#include "studio/operations/sweeping.h"

#include <optional>
#include <string>
#include <variant>

namespace vs::studio {

// The operations that add material to a scan, and take it away. What is filled is later than the cuts before
// it: tools that cut take it away too, and `un-cut` leaves it.

inline constexpr Rule kMaterial{.least = 1, .most = 31};
inline constexpr Rule kMaterialName{.leastCount = 1, .mostCount = 200};

// Adds a material to the document's list, whose number is the next one, or changes one.
struct SetMaterial {
    static constexpr About kAbout{VS_TEXT("library", "material"), Effect::Fills,
                                  "adds a material that can be filled in, with the next number, or changes "
                                  "one",
                                  "fill"};

    int number = 1;
    std::optional<std::string> name = {};
    std::optional<glm::dvec3> colour = {}; // sRGB
    std::optional<double> value = {};
    std::optional<bool> isVisible = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("number", &SetMaterial::number, kMaterial),
            sparse("name", &SetMaterial::name, kMaterialName),
            sparse("colour", &SetMaterial::colour, {.least = 0, .most = 1}, "sRGB"),
            sparse(
                "value", &SetMaterial::value, {.least = -1e30, .most = 1e30},
                "its intensity, in the scan's unit; of a new one without: the middle of the displayed range"),
            sparse("visible", &SetMaterial::isVisible, {}, "whether it is seen")};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Fills by a stroke: what tools would cut inward from the surface is filled outward from it; what a sweep or
// a clip with `inside` would cut is filled as it is. Material takes the place of what is there.
struct Fill {
    static constexpr About kAbout{
        VS_TEXT("library", "fill"), Effect::Fills,
        "adds material: of a `stroke` (a whole `peel`, `drill` or `laser`) as high as "
        "that is deep, outward from the surface; of a `sweep` or a `clip` what that "
        "would cut",
        "fill"};

    int material = 1;
    std::variant<Peel, Drill, Laser, Sweep, Clip> stroke;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("material", &Fill::material, kMaterial),
                          required("stroke", &Fill::stroke)};
    }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Fills a hole up to the surface around it, whose tangents the filling goes on with: what is empty within the
// outline, below the surface that closes it, and hangs together with what is seen of the hole.
struct FillHole {
    static constexpr About kAbout{VS_TEXT("library", "fill hole"), Effect::Fills,
                                  "fills the hole that an outline encloses up to the surface around it, as a "
                                  "dentist does",
                                  "fill"};

    int material = 1;
    Sketch outline;
    std::optional<double> depth = {};
    int radius = 3;
    std::optional<Canvas> canvas = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple_cat(
            std::tuple{
                required("material", &FillHole::material, kMaterial),
                required("outline", &FillHole::outline, {},
                         "drawn around the hole, on the surface beside it"),
                sparse("depth", &FillHole::depth, kDepth,
                       "how deep below the closed surface is filled at most; without: as deep as the hole "
                       "is wide"),
                written("radius", &FillHole::radius, kRadius, "of the filling's soft edge")},
            canvasOf<FillHole>());
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Takes material away that a stroke reaches, and leaves the scan as it was before it was filled.
struct Unfill {
    static constexpr About kAbout{VS_TEXT("library", "unfill"), Effect::Fills,
                                  "takes away what is filled where a `stroke` (a whole `peel`, `drill`, "
                                  "`laser`, `scissors`, `sweep` or `clip`) would cut; the scan stays",
                                  "unfill"};

    std::variant<Peel, Drill, Laser, Scissors, Sweep, Clip> stroke;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("stroke", &Unfill::stroke)};
    }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Takes all of a material away, or all that is filled.
struct RemoveFill {
    static constexpr About kAbout{VS_TEXT("library", "remove fill"), Effect::Fills,
                                  "takes all of a material away, or all that is filled", "unfill"};

    std::optional<int> material = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("material", &RemoveFill::material, kMaterial, "without: all of them")};
    }
};

// Makes a segment of material, or a part of one.
struct SegmentFill {
    static constexpr About kAbout{VS_TEXT("library", "segment material"), Effect::Segments,
                                  "adds what is filled with a material to the segment at work"};

    int material = 1;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("material", &SegmentFill::material, kMaterial)};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

// Writes which voxels are filled with which material.
struct SaveFill {
    static constexpr About kAbout{VS_TEXT("library", "filled"), Effect::Writes,
                                  "writes a label map of what is filled: of each voxel the number of its "
                                  "material, 0 where none is",
                                  "save"};

    std::string file;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SaveFill::file, kOutputFile)};
    }
};

// Writes the surfaces of materials, for printers and other programs.
struct SaveFillSurface {
    static constexpr About kAbout{VS_TEXT("library", "material surface"), Effect::Writes,
                                  "writes the surface of a material alone, or of each, as a mesh (STL, OBJ, "
                                  "PLY or glTF by the file's name)",
                                  "save"};

    std::string file;
    std::optional<int> material = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &SaveFillSurface::file, kOutputFile),
                          sparse("material", &SaveFillSurface::material, kMaterial, "without: all of them")};
    }
};

using FillingOperations =
    std::variant<SetMaterial, Fill, FillHole, Unfill, SegmentFill, RemoveFill, SaveFill, SaveFillSurface>;

} // namespace vs::studio
