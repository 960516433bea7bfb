// SPDX-License-Identifier: Apache-2.0
#include "render/colours/transfer_function.h"

#include "base/check.h"
#include "render/colours/colour_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::render {

namespace {

// The volume's own values from positions.
class Places {
public:
    Places(Positions positions, const Anchors& anchors) {
        switch (positions) {
        case Positions::Absolute:
            break;
        case Positions::Relative:
            at_ = {{0, anchors.values.lo}, {1, anchors.values.hi}};
            gradientUnit_ = anchors.gradientTop;
            break;
        case Positions::Robust:
            at_ = {{0, anchors.robustValues.lo}, {1, anchors.robustValues.hi}};
            gradientUnit_ = anchors.gradientTop;
            break;
        case Positions::Landmarks: {
            const field::Landmarks& marks = anchors.landmarks;
            at_ = {{0, marks.air}, {1, marks.tissue}, {2, marks.darker}, {3, marks.brighter}, {4, marks.top}};
            gradientUnit_ = (marks.brighter - marks.air) / anchors.stepMm;
            break;
        }
        case Positions::Hounsfield:
            at_ = {{-1000, anchors.airAndWater.lo}, {0, anchors.airAndWater.hi}};
            gradientUnit_ = anchors.airAndWater.width() / 1000 / std::max(1.0, anchors.stepMm);
            break;
        }
    }

    // Linear between two anchors, and beyond the outermost as between them and their neighbours.
    [[nodiscard]] double value(double position) const {
        if (at_.empty()) {
            return position;
        }
        std::size_t i = 1;
        while (i + 1 < at_.size() && position > at_[i].first) {
            ++i;
        }
        const auto [from, lo] = at_[i - 1];
        const auto [to, hi] = at_[i];
        return lo + (position - from) / (to - from) * (hi - lo);
    }
    [[nodiscard]] Range values(const Range& positions) const {
        return {value(positions.lo), value(positions.hi)};
    }
    [[nodiscard]] double gradient(double position) const { return position * gradientUnit_; }
    [[nodiscard]] Range gradients(const Range& positions) const {
        return {gradient(positions.lo), gradient(positions.hi)};
    }

private:
    std::vector<std::pair<double, double>> at_; // positions and their values, ascending
    double gradientUnit_ = 1;
};

} // namespace

TransferFunction resolve(const TransferFunction& function, const Anchors& anchors) {
    TransferFunction out = function;
    out.positions = Positions::Absolute;
    const Places places(function.positions, anchors);
    const bool isOfGradients = function.kind == FunctionKind::Gradient;
    for (ControlPoint& point : out.points) {
        point.position = isOfGradients ? places.gradient(point.position) : places.value(point.position);
    }
    if (out.colours) {
        Range& spread = out.colours->range;
        spread = isOfGradients ? places.gradients(spread) : places.values(spread);
    }
    for (Shape& shape : out.shapes) {
        if (auto* trapezoid = std::get_if<Trapezoid>(&shape.form)) {
            trapezoid->base = places.values(trapezoid->base);
            trapezoid->top = places.values(trapezoid->top);
            trapezoid->gradients = places.gradients(trapezoid->gradients);
        } else {
            auto& painting = std::get<Painting>(shape.form);
            painting.values = places.values(painting.values);
            painting.gradients = places.gradients(painting.gradients);
        }
    }
    return out;
}

double opacityOver(double opacity, double steps) { return 1 - std::pow(1 - opacity, steps); }

namespace {

// How far a place is inside a range: 1 in the middle, 0 at its ends, negative outside.
double depthIn(const Range& range, double value) {
    const double half = 0.5 * range.width();
    const double off = std::abs(value - 0.5 * (range.lo + range.hi));
    return half > 0 ? 1 - off / half : (off == 0 ? 1 : -std::numeric_limits<double>::max());
}

// Smooth from 0 at an edge to 1 where the soft part ends.
double fade(double depth, double soft) {
    if (depth < 0) {
        return 0;
    }
    const double t = soft > 0 ? std::min(depth / soft, 1.0) : 1;
    return t * t * (3 - 2 * t);
}

// A shape's part at a place: x of its opacity, 0 to 1; y how far inside it is (negative: outside), for
// colours near the shape.
glm::dvec2 partOf(const Trapezoid& shape, double value, double gradient) {
    const double height = shape.gradients.width();
    const double s = height > 0 ? std::clamp((gradient - shape.gradients.lo) / height, 0.0, 1.0) : 0;
    const Range across{glm::mix(shape.base.lo, shape.top.lo, s), glm::mix(shape.base.hi, shape.top.hi, s)};
    const double x = depthIn(across, value);
    const double y = depthIn(shape.gradients, gradient);
    return {fade(x, shape.soft.x) * fade(y, shape.soft.y), std::min(x, y)};
}

glm::dvec2 partOf(const Painting& painting, double value, double gradient) {
    const double x = depthIn(painting.values, value);
    const double y = depthIn(painting.gradients, gradient);
    if (std::min(x, y) < 0) {
        return {0, std::min(x, y)};
    }
    const auto cell = [&](int i, int j) {
        i = std::clamp(i, 0, painting.size.x - 1);
        j = std::clamp(j, 0, painting.size.y - 1);
        return painting.cells[std::size_t(j) * std::size_t(painting.size.x) + std::size_t(i)] / 255.0;
    };
    const glm::dvec2 place(
        (value - painting.values.lo) / std::max(painting.values.width(), 1e-300) * painting.size.x - 0.5,
        (gradient - painting.gradients.lo) / std::max(painting.gradients.width(), 1e-300) * painting.size.y -
            0.5);
    const glm::ivec2 c(glm::floor(place));
    const glm::dvec2 t = place - glm::dvec2(c);
    return {glm::mix(glm::mix(cell(c.x, c.y), cell(c.x + 1, c.y), t.x),
                     glm::mix(cell(c.x, c.y + 1), cell(c.x + 1, c.y + 1), t.x), t.y),
            std::min(x, y)};
}

} // namespace

FunctionSampler::FunctionSampler(TransferFunction absolute) : function_(std::move(absolute)) {
    VS_CHECK(function_.positions == Positions::Absolute);
    VS_CHECK(function_.kind == FunctionKind::TwoD || !function_.points.empty());
    map_ = function_.colours ? findColourMap(function_.colours->map) : nullptr;
    VS_CHECK(!function_.colours || map_ != nullptr);
    for (const ControlPoint& point : function_.points) {
        oklab_.push_back(oklabFromLinear(linearFromColour(point.colour)));
    }
    for (const Shape& shape : function_.shapes) {
        linear_.push_back(linearFromColour(shape.colour));
    }
}

glm::dvec4 FunctionSampler::at(double value, double gradient) const {
    switch (function_.kind) {
    case FunctionKind::Intensity:
        return alongPoints(value);
    case FunctionKind::Gradient:
        return alongPoints(gradient);
    case FunctionKind::TwoD:
        break;
    }
    return amongShapes(value, gradient);
}

glm::dvec4 FunctionSampler::alongPoints(double position) const {
    const auto& points = function_.points;
    const auto after =
        std::upper_bound(points.begin(), points.end(), position,
                         [](double p, const ControlPoint& point) { return p < point.position; });
    const std::size_t b = std::min(std::size_t(after - points.begin()), points.size() - 1);
    const std::size_t a = after == points.begin() ? 0 : std::size_t(after - points.begin()) - 1;
    const double width = points[b].position - points[a].position;
    const double t = width > 0 ? (position - points[a].position) / width : 0;
    glm::dvec3 oklab = glm::mix(oklab_[a], oklab_[b], t);
    if (map_ != nullptr) {
        const Range& range = function_.colours->range;
        const double place = range.width() > 0 ? (position - range.lo) / range.width() : 0;
        oklab = map_->at(place);
    }
    return {glm::clamp(linearFromOklab(oklab), 0.0, 1.0), glm::mix(points[a].opacity, points[b].opacity, t)};
}

glm::dvec4 FunctionSampler::amongShapes(double value, double gradient) const {
    glm::dvec4 front(0);   // premultiplied
    glm::dvec4 most(0);    // not premultiplied
    glm::dvec3 nearest(0); // colour where nothing is
    double nearestDepth = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < function_.shapes.size(); ++i) {
        const Shape& shape = function_.shapes[i];
        const glm::dvec2 part =
            std::visit([&](const auto& form) { return partOf(form, value, gradient); }, shape.form);
        const double opacity = shape.opacity * part.x;
        front += (1 - front.w) * opacity * glm::dvec4(linear_[i], 1.0);
        if (opacity > most.w) {
            most = {linear_[i], opacity};
        }
        if (part.y > nearestDepth) {
            nearestDepth = part.y;
            nearest = linear_[i];
        }
    }
    if (front.w <= 0) {
        return {nearest, 0};
    }
    return function_.combine == Combine::Max ? most : glm::dvec4(glm::dvec3(front) / front.w, front.w);
}

} // namespace vs::render
