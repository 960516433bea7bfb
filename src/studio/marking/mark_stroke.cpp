// SPDX-License-Identifier: Apache-2.0
#include "studio/marking/mark_stroke.h"

#include "base/error.h"
#include "marking/pen_letters.h"
#include "studio/operations/sketch.h"
#include "studio/strokes/tool_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vs::studio {

namespace {

constexpr double kUsualDepthSteps = 2;
constexpr double kPiecePixels = 16; // of a way that are laid together
constexpr double kLeastPressure = 0.05;
constexpr std::size_t kPixelsAtOnce = 1 << 17; // that are looked under in one go

field::MarkGrid gridFor(const field::Marks& before, const volume::GridGeometry& geometry) {
    return before.isEmpty() ? field::markGridOf(geometry) : before.grid();
}

// Where something may be marked: where the volume appears in the picture, and a little around it.
sculpt::MaskWindow markedWindow(const volume::GridGeometry& geometry, const render::ViewRays& rays) {
    sculpt::MaskWindow window = pictureOf(geometry, rays);
    const glm::dvec2 size(rays.size);
    constexpr double around = 0.25; // of the picture
    window.lo = glm::max(window.lo, -around * size);
    window.hi = glm::min(window.hi, (1 + around) * size);
    return window;
}

bool contains(const sculpt::MaskWindow& window, glm::dvec2 pixel) {
    return glm::all(glm::greaterThanEqual(pixel, window.lo)) &&
           glm::all(glm::lessThanEqual(pixel, window.hi));
}

std::uint8_t byteOf(double part) { return std::uint8_t(std::lround(std::clamp(part, 0.0, 1.0) * 255)); }

} // namespace

MarkStroke::MarkStroke(Cutter& cutter, MakeFrame makeFrame, field::SharedMarks before, const Mark& operation)
    : cutter_(&cutter), makeFrame_(std::move(makeFrame)), operation_(operation), rays_(makeFrame_().rays),
      picture_(markedWindow(*cutter.scene, rays_)), before_(std::move(before)), now_(before_),
      layer_(gridFor(*before_, *cutter.scene)), texelMm_(layer_.grid().texelMm(*cutter.scene)),
      dashMm_(operation.dashMm >= texelMm_ ? operation.dashMm : 0) {}

marking::Ground MarkStroke::ground() const {
    return {&relief_, cutter_->scene, [this](const glm::dvec3& world) { return rays_.project(world); }};
}

marking::Rim MarkStroke::rim() const {
    const double depth = operation_.depthMm.value_or(kUsualDepthSteps * cutter_->scene->stepMm());
    // An eraser reaches what a pen has left at the end of its own depth.
    return {depth + (operation_.erases ? field::kMarkRamp * texelMm_ : 0), operation_.softMm};
}

marking::Ink MarkStroke::ink() const {
    const glm::dvec3 c = operation_.colour;
    return {{byteOf(c.x), byteOf(c.y), byteOf(c.z)}, operation_.erases};
}

std::vector<std::optional<marking::ReliefPoint>> MarkStroke::pick(const std::vector<glm::dvec2>& pixels) {
    // In overlay mode segments are seen through the rest, and they are what one marks.
    const render::Frame frame = makeFrame_();
    const auto meets =
        frame.mode == render::Mode::Overlay ? render::Picker::Meets::Segment : render::Picker::Meets::Surface;
    std::vector<std::optional<marking::ReliefPoint>> found;
    found.reserve(pixels.size());
    for (std::size_t begin = 0; begin < pixels.size(); begin += kPixelsAtOnce) {
        const std::size_t end = std::min(begin + kPixelsAtOnce, pixels.size());
        const std::vector<glm::vec2> positions(pixels.begin() + std::ptrdiff_t(begin),
                                               pixels.begin() + std::ptrdiff_t(end));
        for (const field::SurfacePoint& point : cutter_->picker.pickPoints(frame, positions, meets)) {
            const glm::dvec3 world(cutter_->scene->worldFromVoxel * glm::dvec4(glm::dvec3(point.voxel), 1));
            const bool isHit = point.voxel.w > 0;
            found.push_back(isHit ? std::optional(marking::ReliefPoint{world, glm::dvec3(point.normal)})
                                  : std::nullopt);
        }
    }
    return found;
}

void MarkStroke::show() { now_ = std::make_shared<const field::Marks>(layer_.on(*before_, *now_, ink())); }

// --- lines

marking::PathPoint MarkStroke::pathPoint(const glm::dvec3& world, double pressure) const {
    const double pressed = std::max(pressure, kLeastPressure);
    // Thinner lines than this have no texel that they cover.
    const double thinnest = 0.75 * texelMm_;
    const double width =
        operation_.widthMm * (operation_.pressureSets == Mark::Pressure::Width ? pressed : 1);
    const double opacity =
        operation_.opacity * (operation_.pressureSets == Mark::Pressure::Opacity ? pressed : 1);
    return {world, std::max(0.5 * width, thinnest), opacity};
}

// The surface is looked for at each pixel of the way. Where it jumps, as behind an edge, the way ends and
// begins anew.
MarkStroke::Paths MarkStroke::pathsAlong(const Line& piece) {
    constexpr double farthestPixels = 8; // from one pixel of the way to the next, on the surface
    std::vector<glm::dvec2> pixels{piece.front().pixel};
    std::vector<double> pressures{piece.front().pressure};
    for (std::size_t n = 1; n < piece.size(); ++n) {
        const Place& from = piece[n - 1];
        const Place& to = piece[n];
        const int count = std::max(int(std::ceil(glm::distance(from.pixel, to.pixel))), 1);
        for (int i = 1; i <= count; ++i) {
            pixels.push_back(glm::mix(from.pixel, to.pixel, double(i) / count));
            pressures.push_back(glm::mix(from.pressure, to.pressure, double(i) / count));
        }
    }
    const auto points = pick(pixels);
    Paths paths;
    const marking::ReliefPoint* before = nullptr;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& point = points[i];
        if (point) {
            const bool goesOn = before != nullptr && glm::distance(before->world, point->world) <
                                                         farthestPixels * rays_.pixelMm(point->world);
            if (!goesOn) {
                paths.emplace_back();
            }
            paths.back().push_back(pathPoint(point->world, pressures[i]));
        }
        before = point ? &*point : nullptr;
    }
    return paths;
}

// Dashes end round, within their length.
MarkStroke::Paths MarkStroke::dashed(const Paths& paths) {
    if (dashMm_ <= 0) {
        return paths;
    }
    const double dash = dashMm_;
    Paths dashes;
    for (const auto& path : paths) {
        bool isOn = false;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const auto& a = path[i];
            const auto& b = path[i + 1];
            const double length = glm::distance(a.world, b.world);
            const double round = std::min(a.radiusMm, 0.499 * dash);
            double at = 0; // along this stretch
            while (at < length) {
                const double place = std::fmod(travelledMm_ + at, 2 * dash);
                const bool isInDash = place >= round && place < dash - round;
                const double next = place < round ? round : isInDash ? dash - round : 2 * dash + round;
                const double end = std::min(length, at + std::max(next - place, 1e-6 * dash));
                if (isInDash) {
                    const auto pointAt = [&](double t) {
                        const double part = t / length;
                        return marking::PathPoint{glm::mix(a.world, b.world, part),
                                                  glm::mix(a.radiusMm, b.radiusMm, part),
                                                  glm::mix(a.opacity, b.opacity, part)};
                    };
                    if (!isOn) {
                        dashes.push_back({pointAt(at)});
                    }
                    dashes.back().push_back(pointAt(end));
                }
                isOn = isInDash;
                at = end;
            }
            travelledMm_ += length;
        }
    }
    return dashes;
}

void MarkStroke::layPaths(const Paths& paths) {
    constexpr double most = 1e4; // pixels
    const marking::Rim rim = this->rim();
    glm::dvec2 lo(most);
    glm::dvec2 hi(-most);
    for (const auto& path : paths) {
        for (const marking::PathPoint& point : path) {
            const double reach = point.radiusMm + rim.depthMm + field::kMarkRamp * texelMm_;
            const double pixels = reach / std::max(rays_.pixelMm(point.world), 1e-9) + 2;
            const glm::dvec2 pixel = rays_.project(point.world);
            lo = glm::min(lo, pixel - pixels);
            hi = glm::max(hi, pixel + pixels);
        }
    }
    lo = glm::max(lo, picture_.lo - 2.0);
    hi = glm::min(hi, picture_.hi + 2.0);
    if (!(lo.x < hi.x && lo.y < hi.y)) {
        return;
    }
    const glm::ivec2 first(glm::floor(lo));
    const glm::ivec2 end = glm::ivec2(glm::ceil(hi)) + 1;
    relief_.lookUnder(first, end, [this](const auto& pixels) { return pick(pixels); });
    const marking::Shape shape = [&](const glm::dvec3& onSurface, glm::dvec2) {
        marking::OnLine found;
        for (const auto& path : paths) {
            const marking::OnLine on = marking::onLine(path, onSurface);
            found = on.insideMm > found.insideMm ? on : found;
        }
        return found;
    };
    marking::lay(layer_, ground(), shape, rim, first, end);
}

void MarkStroke::layPiece(const Line& piece) {
    const bool isNear = std::any_of(piece.begin(), piece.end(),
                                    [&](const Place& place) { return contains(picture_, place.pixel); });
    if (isNear) {
        layPaths(dashed(pathsAlong(piece)));
    }
}

void MarkStroke::goTo(const Place& from, const Place& to) {
    const int pieces = std::max(int(std::ceil(glm::distance(from.pixel, to.pixel) / kPiecePixels)), 1);
    const auto placeAt = [&](int i) {
        const double part = double(i) / pieces;
        return Place{glm::mix(from.pixel, to.pixel, part), glm::mix(from.pressure, to.pressure, part)};
    };
    for (int i = 0; i < pieces; ++i) {
        layPiece({placeAt(i), placeAt(i + 1)});
    }
}

// As the pen does it: it is put down, and then goes on.
void MarkStroke::followPen(const Line& line) {
    travelledMm_ = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        goTo(line[i == 0 ? 0 : i - 1], line[i]);
    }
}

// As a whole: corners that are near one another are laid together.
void MarkStroke::drawLine(const Line& line) {
    travelledMm_ = 0;
    Line piece;
    double length = 0;
    for (const Place& place : line) {
        const double way = piece.empty() ? 0 : glm::distance(piece.back().pixel, place.pixel);
        if (way > kPiecePixels) {
            layPiece(piece);
            goTo(piece.back(), place);
            piece.clear();
            length = -way;
        }
        piece.push_back(place);
        length += way;
        if (length > kPiecePixels) {
            layPiece(piece);
            piece = {place};
            length = 0;
        }
    }
    if (!piece.empty()) {
        layPiece(piece);
    }
}

void MarkStroke::drawAt(const sculpt::PenPoint& pen) {
    const Place place{pen.pixel, pen.pressure};
    operation_.sketch.points.push_back(pen.pixel);
    operation_.pressures.push_back(pen.pressure);
    goTo(last_.value_or(place), place);
    last_ = place;
    show();
}

// --- what is drawn at once

// How far places lie inside the outline is worked out near its edge only, as far as the rim goes; where that
// is many pixels wide, for fewer of them.
void MarkStroke::drawArea() {
    constexpr double mostReach = 64; // of those
    const auto outline = outlineOf(operation_.sketch);
    if (outline.empty()) {
        return;
    }
    const auto middle = pick({centreOf(outline)}).front();
    const double pixelMm =
        rays_.pixelMm(middle ? middle->world
                             : glm::dvec3(cutter_->scene->worldFromVoxel *
                                          glm::dvec4(0.5 * glm::dvec3(cutter_->scene->dims), 1)));
    // Where the surface is farther away than in the middle, pixels are wider.
    const double reachMm = 1.5 * (operation_.softMm + field::kMarkRamp * texelMm_);
    const double reach = reachMm / std::max(pixelMm, 1e-9) + 2;
    const double pitch = std::max(reach / mostReach, 1.0); // pixels
    std::array<marking::AreaDistances::Outline, 1> outlines{
        sculpt::clipToBox(outline, picture_.lo - 2 * reach, picture_.hi + 2 * reach)};
    for (glm::dvec2& corner : outlines[0]) {
        corner /= pitch;
    }
    const marking::AreaDistances area(outlines, reach / pitch);
    const glm::dvec2 lo = glm::max(pitch * glm::dvec2(area.lo()), picture_.lo) - 2.0;
    const glm::dvec2 hi = glm::min(pitch * glm::dvec2(area.lo() + area.size()), picture_.hi) + 2.0;
    if (outlines[0].empty() || !(lo.x < hi.x && lo.y < hi.y)) {
        return;
    }
    const glm::ivec2 first(glm::floor(lo));
    const glm::ivec2 end(glm::ceil(hi));
    relief_.lookUnder(first, end, [this](const auto& pixels) { return pick(pixels); });
    const marking::Shape shape = [&](const glm::dvec3& onSurface, glm::dvec2 pixel) {
        return marking::OnLine{pitch * area.insidePixels(pixel / pitch) * rays_.pixelMm(onSurface),
                               operation_.opacity};
    };
    marking::lay(layer_, ground(), shape, rim(), first, end);
}

// Two strokes back from the tip.
void MarkStroke::drawArrow() {
    constexpr double barbWidths = 6;
    constexpr double barbAngle = 0.45; // radians from the shaft
    const auto& points = operation_.sketch.points;
    const glm::dvec2 tip = points.back();
    const auto under = pick({tip});
    if (!under.front()) {
        return;
    }
    const double barb = barbWidths * operation_.widthMm / rays_.pixelMm(under.front()->world);
    glm::dvec2 back = points.front();
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
        if (glm::distance(*point, tip) >= barb) {
            back = *point;
            break;
        }
    }
    const glm::dvec2 way = back - tip;
    if (glm::length(way) < 1) {
        return;
    }
    const glm::dvec2 unit = way / glm::length(way);
    dashMm_ = 0; // the head is whole
    for (const double angle : {barbAngle, -barbAngle}) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const glm::dvec2 turned(c * unit.x - s * unit.y, s * unit.x + c * unit.y);
        drawLine({{tip, 1}, {tip + barb * turned, 1}});
    }
}

void MarkStroke::writeText() {
    glm::dvec2 lo = operation_.sketch.points.front();
    glm::dvec2 hi = lo;
    for (const glm::dvec2& point : operation_.sketch.points) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    const glm::dvec2 middle = 0.5 * (lo + hi);
    const auto under = pick({middle});
    if (!under.front()) {
        throw Error("there is no surface at {:.0f}, {:.0f} to write \"{}\" on", middle.x, middle.y,
                    operation_.text);
    }
    const double scale = operation_.sizeMm / rays_.pixelMm(under.front()->world);
    for (const auto& letter : marking::penLetters(operation_.text)) {
        Line line;
        for (const glm::dvec2& place : letter) {
            line.push_back({middle + scale * place, 1});
        }
        drawLine(line);
    }
}

void MarkStroke::replay() {
    if (operation_.kind == Mark::Kind::Area) {
        drawArea();
    } else if (operation_.kind == Mark::Kind::Text) {
        writeText();
    } else {
        const Sketch& sketch = operation_.sketch;
        const bool isOpen = sketch.shape == Shape::FreeForm || sketch.shape == Shape::Polyline;
        auto points = isOpen ? sketch.points : outlineOf(sketch);
        if (!isOpen && !points.empty()) {
            points.push_back(points.front());
        }
        Line line;
        for (std::size_t i = 0; i < points.size(); ++i) {
            line.push_back({points[i], i < operation_.pressures.size() ? operation_.pressures[i] : 1});
        }
        sketch.shape == Shape::FreeForm ? followPen(line) : drawLine(line);
        if (operation_.kind == Mark::Kind::Arrow) {
            drawArrow();
        }
    }
    show();
}

} // namespace vs::studio
