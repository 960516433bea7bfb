// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/value_json.h"
#include "render/colours/transfer_function.h"

namespace vs::render {

// A shape as it stands in files: by the name of its form, a trapezoid with the same base and top as a box.
struct ShapeInFiles {
    enum class Form { Box, Trapezoid, Painting };
    static constexpr const char* kName = "shape";
    static constexpr std::array<const char*, 3> kForms{"box", "trapezoid", "painting"};
    static constexpr Rule kCells{.least = 0,
                                 .most = 255,
                                 .leastCount = 1,
                                 .mostCount = 256,
                                 .wrongCount = "has {0} entries; {1} to {2} are allowed"};

    Form form = Form::Box;
    Range values;
    Range base;
    Range top;
    Range gradients;
    glm::dvec2 soft = Trapezoid().soft;
    std::vector<std::vector<int>> cells; // rows
    Colour colour{255};
    double opacity = 0;

    ShapeInFiles() = default;
    explicit ShapeInFiles(const Shape& shape);
    [[nodiscard]] Shape value() &&;

    template <typename = void>
    static constexpr auto fields() {
        using T = ShapeInFiles;
        constexpr auto isTrapezoid = [](const T& shape) { return shape.form == Form::Trapezoid; };
        constexpr auto isUpright = [](const T& shape) { return shape.form != Form::Trapezoid; };
        constexpr auto isPainting = [](const T& shape) { return shape.form == Form::Painting; };
        constexpr auto isFading = [](const T& shape) { return shape.form != Form::Painting; };
        return std::tuple{
            required("shape", &T::form).deciding(),
            required("values", &T::values, kPosition, "intensities: from, to").onlyWhen(isUpright),
            required("base", &T::base, kPosition, "intensities at the lower end of `gradients`")
                .onlyWhen(isTrapezoid),
            required("top", &T::top, kPosition, "intensities at their upper end").onlyWhen(isTrapezoid),
            required("gradients", &T::gradients, kPosition, "magnitudes: from, to"),
            written("soft", &T::soft, kPart,
                    "how much of the way to the middle is spent on fading in: across, upwards; 0.5 each if "
                    "not given")
                .onlyWhen(isFading),
            required("cells", &T::cells, kCells,
                     "parts of the opacity in rows of the same length, lowest gradient first")
                .onlyWhen(isPainting),
            required("colour", &T::colour, kColour),
            required("opacity", &T::opacity, kPart)};
    }
    // Rows of cells that differ in length.
    [[nodiscard]] Fault faultOf() const;
};
constexpr const auto& namesOf(ShapeInFiles::Form) { return ShapeInFiles::kForms; }

} // namespace vs::render

namespace vs {

// A colour as transfer functions' files have it: #rrggbb.
void read(const JsonReader& reader, render::Colour& value, const Rule& rule);
Json write(const render::Colour& value, const Rule& rule);
Json schemaOf(Type<render::Colour>, const Rule& rule, Json& definitions);

} // namespace vs
