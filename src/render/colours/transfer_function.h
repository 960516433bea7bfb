// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "base/math.h"
#include "field/landmarks.h"
#include "field/scene.h"
#include "render/colours/colour.h"
#include "render/colours/colour_map.h"
#include "render/colours/mode.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::render {

// What colour and opacity depend on: intensity, gradient magnitude, or both.
enum class FunctionKind { Intensity, Gradient, TwoD };
inline constexpr std::array<const char*, 3> kFunctionKinds{"intensity", "gradient", "two-dimensional"};
constexpr const auto& namesOf(FunctionKind) { return kFunctionKinds; }

// What positions are measured in.
// Absolute: the volume's unit (HU, grey level), gradient magnitudes in that unit per mm.
// Relative: intensities from 0 to 1 over all of the volume's values. Robust: from 0 to 1 between its 0.1st
// and its 99.9th percentile, so that a few odd voxels do not matter. For both of these gradient magnitudes
// run from 0 to 1 between none and their 99.9th percentile.
// Landmarks: intensities are 0 at the peak of air in the histogram, 1 where tissue begins, 2 at the darker
// peak of tissue, 3 at the brighter one, 4 at the 99.9th percentile (field/landmarks.h), linear between them;
// gradient magnitudes are 1 where a step leads from air to the brighter peak.
// Hounsfield: Hounsfield units, also where a CT scan's values are others: then its air is -1000, and its soft
// tissue 40; gradient magnitudes are those units per mm, or per step where voxels are larger than that, in
// which edges are as much weaker.
enum class Positions { Absolute, Relative, Robust, Landmarks, Hounsfield };
inline constexpr std::array<const char*, 5> kPositions{"absolute", "relative", "robust", "landmarks",
                                                       "hounsfield"};
constexpr const auto& namesOf(Positions) { return kPositions; }

inline constexpr Rule kPosition{.least = -1e12, .most = 1e12};
inline constexpr Rule kPart{.least = 0, .most = 1};
inline constexpr Rule kColour{.unit = "#rrggbb (display sRGB)"};

// Opacity is linear between points, colour linear in OKLab; beyond the ends both stay as they are there.
// Two points may share a position: a step.
struct ControlPoint {
    static constexpr const char* kName = "control point";

    double position = 0;
    double opacity = 0;
    Colour colour{255}; // without meaning when a colour map is used

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("at", &ControlPoint::position, kPosition, "two may share a place: a step"),
                          required("opacity", &ControlPoint::opacity, kPart),
                          required("colour", &ControlPoint::colour, kColour)};
    }

    bool operator==(const ControlPoint&) const = default;
};

// A named colour map (render/colours/colour_map.h) spread over a range of positions.
struct SpreadColours {
    static constexpr const char* kName = "colour map";

    std::string map = "grey";
    Range range{0, 1};

    template <typename = void>
    static auto fields() {
        return std::tuple{required("name", &SpreadColours::map, {.choices = colourMapNames()}),
                          required("range", &SpreadColours::range, kPosition, "where it begins and ends")};
    }

    bool operator==(const SpreadColours&) const = default;
};

// A quadrilateral over intensity (across) and gradient magnitude (upwards): a box if base and top are the
// same, a triangle if one of them is a single value (Kniss, Kindlmann, Hansen 2002, "Multidimensional
// transfer functions for interactive volume rendering").
struct Trapezoid {
    Range base;      // intensities at gradients.lo
    Range top;       // intensities at gradients.hi
    Range gradients; // magnitudes
    // How much of the way from edge to middle is spent on fading in, 0 (hard) to 1: x across, y upwards.
    glm::dvec2 soft{0.5, 0.5};

    bool operator==(const Trapezoid&) const = default;
};

// A painted grid of parts of the opacity, 0 to 255, between whose cells' centres they are linear.
struct Painting {
    Range values;
    Range gradients;
    glm::ivec2 size{0};              // cells along intensity and gradient
    std::vector<std::uint8_t> cells; // intensity fastest, lowest gradient first

    bool operator==(const Painting&) const = default;
};

struct ShapeInFiles; // render/colours/function_values.h

struct Shape {
    using InFiles = ShapeInFiles;

    std::variant<Trapezoid, Painting> form;
    Colour colour{255};
    double opacity = 0.5;

    bool operator==(const Shape&) const = default;
};

// How shapes that overlap combine: the first one lies in front, or the most opaque one counts alone.
enum class Combine { Over, Max };
inline constexpr std::array<const char*, 2> kCombines{"over", "max"};
constexpr const auto& namesOf(Combine) { return kCombines; }

// How what is seen is lit in volume mode.
struct Lighting {
    double amount = 1;   // 0: glows by itself, 1: lit as a surface
    double gloss = 0.12; // strength of highlights

    bool operator==(const Lighting&) const = default;
};

// How a function is best looked at; what it does not say stays as it is. The window takes it along when a
// person chooses the function, sessions and the command line say it themselves.
struct SuitedView {
    static constexpr const char* kName = "suited view";

    std::optional<Mode> mode;
    std::optional<bool> shadows; // ambient occlusion and soft shadows
    std::optional<field::Sampling> sampling;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("mode", &SuitedView::mode),
                          sparse("shadows", &SuitedView::shadows, {}, "ambient occlusion and soft shadows"),
                          sparse("sampling", &SuitedView::sampling)};
    }

    bool operator==(const SuitedView&) const = default;
};

inline constexpr Rule kShapes{
    .leastCount = 1, .mostCount = 256, .wrongCount = "has {0} shapes; {1} to {2} are allowed"};
inline constexpr Rule kPoints{
    .leastCount = 1, .mostCount = 4096, .wrongCount = "has {0} points; {1} to {2} are allowed"};
inline constexpr Rule kPointsWithoutColour{.leastCount = kPoints.leastCount,
                                           .mostCount = kPoints.mostCount,
                                           .wrongCount = kPoints.wrongCount,
                                           .without = "colour"};

// Colour and opacity of every value of a volume. A value type: what panels edit, files hold
// (doc/transfer_functions.md) and Classification takes to the device.
struct TransferFunction {
    static constexpr const char* kName = "transfer function";
    static constexpr FileFormat kFormat{"volumeStudioTransferFunction", 1};

    std::string name;
    std::string description;
    FunctionKind kind = FunctionKind::Intensity;
    Positions positions = Positions::Absolute;
    // Opacities are per this many mm; nothing: per step (the volume's smallest spacing).
    std::optional<double> unitMm;
    Lighting lighting;
    SuitedView suits;

    // The points of a function over intensity or over gradient magnitude: at least one, in ascending order.
    std::vector<ControlPoint> points;
    std::optional<SpreadColours> colours; // instead of the points' own

    // The shapes of a function over both.
    std::vector<Shape> shapes;
    Combine combine = Combine::Over;

    template <typename = void>
    static auto fields() {
        using T = TransferFunction;
        constexpr auto isCurve = [](const T& f) { return f.kind != FunctionKind::TwoD; };
        constexpr auto isPlane = [](const T& f) { return f.kind == FunctionKind::TwoD; };
        constexpr auto isPlain = [](const T& f) { return f.kind != FunctionKind::TwoD && !f.colours; };
        constexpr auto isMapped = [](const T& f) { return f.kind != FunctionKind::TwoD && f.colours; };
        return std::tuple{
            written("name", &T::name, {}, "for people"),
            written("description", &T::description, {}, "for people"),
            required("kind", &T::kind, {},
                     "what colour and opacity depend on: intensity, the gradient's magnitude, or both")
                .deciding(),
            written("positions", &T::positions, {}, "what positions are measured in"),
            sparse("unitMm", &T::unitMm, {.least = 1e-6, .most = 1e6, .unit = "mm"},
                   "opacities are per this length; without: per step (the volume's smallest spacing)"),
            group("lighting", std::tuple{written("amount", through(&T::lighting, &Lighting::amount), kPart,
                                                 "0: glows by itself, 1: lit as a surface"),
                                         written("gloss", through(&T::lighting, &Lighting::gloss), kPart,
                                                 "strength of highlights")}),
            sparse("suits", &T::suits, {}, "how it is best looked at"),
            written("combine", &T::combine, {},
                    "where shapes overlap: the first lies in front, or the most opaque one counts")
                .onlyWhen(isPlane),
            required("shapes", &T::shapes, kShapes, "areas over intensity and gradient magnitude")
                .onlyWhen(isPlane),
            sparse("colourMap", &T::colours, {}, "instead of the points' colours")
                .onlyWhen(isCurve)
                .deciding(),
            required("points", &T::points, kPoints, "in ascending order").onlyWhen(isPlain),
            required("points", &T::points, kPointsWithoutColour, "in ascending order").onlyWhen(isMapped)};
    }
    // Points that do not ascend.
    [[nodiscard]] Fault faultOf() const;

    bool operator==(const TransferFunction&) const = default;
};

// What positions that are not absolute are measured against; each is asked for by some of them.
struct Anchors {
    Range values;           // of all voxels
    Range robustValues;     // 0.1st to 99.9th percentile
    double gradientTop = 0; // 99.9th percentile of gradient magnitudes, unit per mm
    field::Landmarks landmarks;
    Range airAndWater; // -1000 and 0 HU
    double stepMm = 1;
};

// A function with its positions made absolute.
TransferFunction resolve(const TransferFunction& function, const Anchors& anchors);

// Evaluates a function whose positions are absolute, at any place: what tables are made from and tests
// compare with.
class FunctionSampler {
public:
    explicit FunctionSampler(TransferFunction absolute);

    // xyz linear colour, not multiplied by opacity; w opacity per the function's own unit. `value` has no
    // influence on the Gradient kind, `gradient` none on the Intensity kind.
    [[nodiscard]] glm::dvec4 at(double value, double gradient) const;

private:
    [[nodiscard]] glm::dvec4 alongPoints(double position) const;
    [[nodiscard]] glm::dvec4 amongShapes(double value, double gradient) const;

    TransferFunction function_;
    const ColourMap* map_ = nullptr; // if the function uses one
    std::vector<glm::dvec3> oklab_;  // of the points
    std::vector<glm::dvec3> linear_; // of the shapes
};

// Opacity of a length of `steps` when it is `opacity` over a length of one.
double opacityOver(double opacity, double steps);

} // namespace vs::render
