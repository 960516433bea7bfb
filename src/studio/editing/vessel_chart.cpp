// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/vessel_chart.h"

#include "image/drawing.h"

#include <fmt/format.h>

#include <algorithm>

namespace vs::studio {

namespace {

constexpr image::Colour kCard{0.04, 0.05, 0.06, 0.8};
constexpr image::Colour kCurve{0.18, 0.86, 0.48};
constexpr image::Colour kNarrow{0.98, 0.45, 0.32};
constexpr image::Colour kWriting{0.97, 0.97, 0.95};
constexpr image::Colour kAxis{0.97, 0.97, 0.95, 0.45};

constexpr double kTextSize = 12; // pixels at scale 1

class Plot {
public:
    Plot(glm::ivec2 size, double scale, double mostAlongMm, double mostDiameterMm)
        : drawing_(size), lo_(34 * scale, 20 * scale), hi_(glm::dvec2(size) - glm::dvec2(10, 20) * scale),
          scale_(scale), most_(mostAlongMm, mostDiameterMm) {
        drawing_.fillBox({0, 0}, size, kCard);
        drawing_.line({{lo_.x, lo_.y}, {lo_.x, hi_.y}, {hi_.x, hi_.y}}, scale_, kAxis);
    }
    [[nodiscard]] glm::dvec2 at(double alongMm, double diameterMm) const {
        return {lo_.x + (hi_.x - lo_.x) * alongMm / most_.x, hi_.y - (hi_.y - lo_.y) * diameterMm / most_.y};
    }
    void curve(const std::vector<double>& alongMm, const std::vector<double>& diametersMm) {
        image::Outline points;
        for (std::size_t n = 0; n < alongMm.size(); ++n) {
            points.push_back(at(alongMm[n], diametersMm[n]));
        }
        drawing_.line(points, 1.6 * scale_, kCurve);
    }
    void dashes(double diameterMm) {
        const glm::dvec2 begin = at(0, diameterMm);
        for (double x = begin.x; x < hi_.x; x += 8 * scale_) {
            drawing_.line({{x, begin.y}, {std::min(x + 4 * scale_, hi_.x), begin.y}}, scale_, kAxis);
        }
    }
    void mark(glm::dvec2 place, const std::string& said) {
        const double r = 3.5 * scale_;
        drawing_.fill({place + glm::dvec2(r, 0), place + glm::dvec2(0, r), place - glm::dvec2(r, 0),
                       place - glm::dvec2(0, r)},
                      kNarrow);
        // Below the mark, within the plot.
        const double half = 0.5 * image::textWidth(said, kTextSize * scale_);
        const double x = std::clamp(place.x, lo_.x + half + 3 * scale_, std::max(lo_.x + half, hi_.x - half));
        write(said, {x, std::min(place.y + 17 * scale_, hi_.y - 3 * scale_)}, image::Align::Centre, kNarrow);
    }
    void label(const std::string& along, const std::string& diameter) {
        write("0", {lo_.x, hi_.y + 14 * scale_}, image::Align::Left);
        write(along, {hi_.x, hi_.y + 14 * scale_}, image::Align::Right);
        write(diameter, {5 * scale_, lo_.y - 6 * scale_}, image::Align::Left);
    }
    [[nodiscard]] image::Image picture() const { return drawing_.picture(); }

private:
    void write(const std::string& said, glm::dvec2 place, image::Align align,
               image::Colour colour = kWriting) {
        drawing_.text({.text = said, .place = place, .size = kTextSize * scale_, .align = align}, colour);
    }

    image::Drawing drawing_;
    glm::dvec2 lo_;
    glm::dvec2 hi_;
    double scale_;
    glm::dvec2 most_;
};

} // namespace

image::Image vesselChart(const Measured& vessel, const volume::GridGeometry& geometry, glm::ivec2 size,
                         double scale) {
    const auto& diameters = vessel.diametersMm;
    const double widest = *std::max_element(diameters.begin(), diameters.end());
    Plot plot(size, scale, std::max(vessel.value, 1e-12), std::max(1.15 * widest, 1e-12));
    if (vessel.isNarrowed()) {
        plot.dashes(vessel.narrowest->referenceDiameterMm);
    }
    plot.curve(vessel.alongMm, diameters);
    if (vessel.isNarrowed()) {
        const std::size_t n = vessel.narrowest->index;
        plot.mark(plot.at(vessel.alongMm[n], diameters[n]), narrowestOf(vessel, geometry));
    }
    plot.label(lengthText(vessel.value, geometry), fmt::format("⌀ {}", lengthText(widest, geometry)));
    return plot.picture();
}

} // namespace vs::studio
