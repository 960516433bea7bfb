// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "sculpt/mask/mask.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace vs::studio {

// Elements lo to hi (exclusive) of a raster.
struct ElementBox {
    glm::ivec2 lo{0};
    glm::ivec2 hi{0};

    [[nodiscard]] bool isEmpty() const { return hi.x <= lo.x || hi.y <= lo.y; }
    [[nodiscard]] glm::ivec2 size() const { return glm::max(hi - lo, glm::ivec2(0)); }
    void include(glm::ivec2 e) {
        lo = glm::min(lo, e);
        hi = glm::max(hi, e + 1);
    }
};

// What a stroke has covered of the picture so far, and how deep: at each place the greatest depth that the
// mask has passed with. So it does not matter how slowly, in how many reports or how often the pen went there
// (doc/behaviour.md, "Tools"). Elements lie at pitch * (i, j), in pixels; memory follows what was covered.
class StrokeRaster {
public:
    explicit StrokeRaster(double pitch) : pitch_(pitch) {}

    // Where the pen is, how deep its mask goes there (steps) and which way (unit, world).
    struct Place {
        glm::dvec2 pixel{0};
        double depth = 0;
        glm::dvec3 direction{0, 0, 1};
    };
    // A mask (centred on the origin, of the same pitch; `flat` is its sculpt::flatness()) goes straight from
    // one place to another, depth and direction changing evenly. What lies beyond `within` is left alone.
    // Returns the elements that changed.
    ElementBox cover(const sculpt::MaskRaster& mask, const std::vector<std::uint16_t>& flat,
                     const Place& from, const Place& to, const ElementBox& within);
    // The elements in a window of pixels, and those next to them.
    [[nodiscard]] ElementBox elementsIn(const sculpt::MaskWindow& pixels) const;

    // Asks for the surface points in `box` and next to it that are not known yet: pixels to points.
    using Pick = std::function<std::vector<field::SurfacePoint>(const std::vector<glm::vec2>& pixels)>;
    void lookUnder(const ElementBox& box, const Pick& pick);
    // The part in a box of elements, all in the same order.
    struct Part {
        sculpt::MaskRaster mask;
        std::vector<float> depths;
        std::vector<glm::vec3> directions;
        std::vector<field::SurfacePoint> surface;
    };
    Part part(const ElementBox& box);

private:
    static constexpr int kChunk = 32; // elements along a side

    struct Element {
        float mask = 0;
        float core = 0;   // greatest depth where the mask is at least a half
        float fringe = 0; // and where it is less, which counts where it never was more
        bool isPicked = false;
        glm::vec3 direction{0};
        field::SurfacePoint surface;
    };
    struct Chunk {
        std::vector<Element> elements{std::size_t(kChunk) * kChunk};
    };

    Element& at(glm::ivec2 e);
    bool cover(glm::ivec2 e, float covered, float depth, glm::vec3 direction);

    double pitch_;
    std::map<std::pair<int, int>, Chunk> chunks_;
    Chunk* last_ = nullptr; // the one used before, most likely again
    glm::ivec2 lastPlace_{0};
};

} // namespace vs::studio
