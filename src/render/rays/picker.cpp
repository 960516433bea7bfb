// SPDX-License-Identifier: Apache-2.0
#include "render/rays/picker.h"

#include "base/progress.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <algorithm>

namespace vs::render {

namespace {

// Where maxima are looked for, their ranges are bound where the segments of finer levels would be.
field::Detail::Layers layersOf(const Frame& frame) {
    field::Detail::Layers layers;
    layers.hasCuts = frame.detail != nullptr && frame.scene.sculpture != nullptr && frame.scene.hasFinerCuts;
    layers.hasSegments = frame.detail != nullptr && frame.scene.segmentation != nullptr &&
                         frame.scene.hasFinerSegments && frame.mode != Mode::Mip;
    return layers;
}

gl::Defines definesFor(const Frame& frame, Picker::Meets meets) {
    const field::Scene& scene = frame.scene;
    const field::Field& searched = scene.smoothed != nullptr ? *scene.smoothed : *scene.data;
    // In overlay and segment mode a stroke lands on whatever surface is seen; in MIP and X-ray on the
    // displayed range's; in volume mode on what the transfer function makes opaque, or a segment's surface.
    const bool byFunction = frame.mode == Mode::Volume;
    const bool isOverlay = frame.mode == Mode::Overlay;
    const int content = isOverlay && meets == Picker::Meets::Segment ? 1
                        : isOverlay || frame.mode == Mode::Segment   ? 2
                        : byFunction                                 ? 3
                                                                     : 0;
    gl::Defines defines = gl::switchesOn({
        {"SCULPTED", field::hasHiddenSide(scene)},
        {"SMOOTHED", scene.smoothed != nullptr},
        {"TRICUBIC", scene.sampling == field::Sampling::Tricubic},
        {"QUADS", bool(searched.quads) && frame.detail == nullptr},
        {"BRICK_RANGES", frame.detail != nullptr && frame.detail->hasTellingRanges(field::kCell)},
        {"FETCHED", frame.detail != nullptr},
        {"SEGMENTS", byFunction && scene.segmentation != nullptr},
        {"PICK_MAXIMUM", frame.mode == Mode::Mip && meets != Picker::Meets::Surface},
    });
    if (frame.detail != nullptr) {
        frame.detail->addDefines(layersOf(frame), defines);
    }
    field::addFill(scene, defines);
    defines.emplace_back("CONTENT", std::to_string(content));
    if (byFunction) {
        frame.classification->addDefines(defines);
    }
    return defines;
}

} // namespace

// Places of the picture, some of them at a time, and where what lies under them goes.
struct Picker::Asked {
    std::span<const glm::vec2> positions;
    Meets meets = Meets::Surface;
    const gl::Buffer& points;
    std::size_t first = 0; // of the points, that belongs to the first position
};

Picker::Picker() : view_(sizeof(ViewBlock), "picker view") {}

field::SurfacePoints Picker::pick(const Frame& frame, std::span<const glm::vec2> positions, Meets meets) {
    const gl::Pass pass("pick surface points");
    field::SurfacePoints out;
    out.size = {int(positions.size()), 1};
    out.points = gl::Buffer(positions.size() * sizeof(field::SurfacePoint), "surface points");
    const Asked asked{positions, meets, out.points};
    // What fits is looked for where it was always looked for.
    const bool isInBricks =
        frame.detail != nullptr && frame.scene.smoothed == nullptr && frame.detail->grids().front().isFiner();
    if (!positions.empty() && isInBricks) {
        pickInBricks(frame, asked);
    } else if (!positions.empty()) {
        Frame plain = frame;
        plain.detail = nullptr;
        pickSome(plain, asked);
    }
    return out;
}

void Picker::pickSome(const Frame& frame, const Asked& asked) {
    gl::Program& program = pickPoints_.with(definesFor(frame, asked.meets));
    sceneBinding_.bind(frame.scene);
    view_.writeValue(viewBlock(frame.rays, frame.scene.data->geometry));
    view_.bindUniform(kViewBlock);
    frame.macrocells->bind();
    if (frame.detail != nullptr) {
        frame.detail->bind(layersOf(frame));
    }
    if (frame.mode == Mode::Volume) {
        frame.classification->bind();
    }
    positions_.reserve(asked.positions.size_bytes());
    positions_.write(asked.positions);
    positions_.bindStorage(kPositionsStorage);
    asked.points.bindStorage(kPointsStorage);
    program.set("count", int(asked.positions.size())).set("first", int(asked.first));
    // Read at once; and what was looked at as textures may be cut next.
    program.dispatchOverList(asked.positions.size(), gl::Barrier::All);
}

// Rays that met a place whose brick is not there are cast again when it has come; where there is no room for
// the bricks of all, for some of them at a time.
void Picker::pickInBricks(const Frame& frame, const Asked& asked) {
    constexpr std::size_t kFew = 64;
    constexpr double kLookMs = 25;
    field::Detail& detail = *frame.detail;
    detail.use(detail.finest());
    const glm::dvec3 viewer(frame.scene.data->geometry.voxelFromWorld() * glm::dvec4(frame.rays.eye, 1));
    std::size_t atOnce = asked.positions.size();
    for (std::size_t begin = 0; begin < asked.positions.size();) {
        const std::size_t count = std::min(atOnce, asked.positions.size() - begin);
        const Asked some{asked.positions.subspan(begin, count), asked.meets, asked.points,
                         asked.first + begin};
        pickSome(frame, some);
        if (detail.endRound(viewer) == 0) {
            begin += count;
            continue;
        }
        bool haveSomeCome = false;
        while (detail.coming() > 0 && !detail.isFull()) {
            reportProgress();
            haveSomeCome = detail.deliver(kLookMs) || haveSomeCome;
        }
        if (detail.isFull() && !haveSomeCome && count > kFew) {
            atOnce = count / 4;
        } else if (detail.isFull() && !haveSomeCome) {
            detail.tell("there is no room for the bricks that a few rays meet: tools meet surfaces at the "
                        "resolution that is worked on; give --device-memory more");
            Frame plain = frame;
            plain.detail = nullptr;
            pickSome(plain, some);
            begin += count;
        }
    }
}

std::vector<field::SurfacePoint> Picker::pickPoints(const Frame& frame, std::span<const glm::vec2> positions,
                                                    Meets meets) {
    return pick(frame, positions, meets).points.read<field::SurfacePoint>(positions.size());
}

} // namespace vs::render
