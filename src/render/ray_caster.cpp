// SPDX-License-Identifier: Apache-2.0
#include "render/ray_caster.h"

#include "base/check.h"
#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "gl/pass.h"

#include <cmath>

namespace vs::render {

namespace {

constexpr int kTile = 128; // pixels; about 3 ms on two cores of a software renderer
constexpr glm::vec2 kCentre{0.5F, 0.5F};

// Evenly spread places in a pixel: the R2 sequence (Roberts 2018, "The unreasonable effectiveness of
// quasirandom sequences"), starting at the centre so that one sample is the plain picture.
glm::vec2 placeInPixel(int sample) {
    constexpr double g = 1.32471795724474602596;
    const double n = sample;
    return glm::vec2(glm::fract(glm::dvec2(0.5 + n / g, 0.5 + n / (g * g))));
}

// Side of the square of pixels whose rays share a beam.
constexpr int kBeam = 8;

glm::ivec2 tileCount(glm::ivec2 size) { return (size + kTile - 1) / kTile; }

} // namespace

const char* name(Mode mode) {
    constexpr const char* names[] = {"surface", "mip", "xray", "overlay", "segment"};
    return names[static_cast<int>(mode)];
}

Mode modeFromName(const std::string& text) {
    for (const Mode mode : kModes) {
        if (text == name(mode)) {
            return mode;
        }
    }
    throw UsageError("mode '{}' does not exist; choose surface, mip, xray, overlay or segment", text);
}

ViewBlock viewBlock(const ViewRays& rays, const volume::GridGeometry& geometry) {
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    const auto direction = [&](glm::dvec3 world, double scale) {
        return glm::vec4(glm::dmat3(voxelFromWorld) * (world * scale), 0.0);
    };
    // Directions are per step, except the picture's half width and height of an orthographic view, which are
    // lengths.
    const double step = geometry.stepMm();
    const double offset = rays.isOrthographic ? 1.0 : step;
    ViewBlock block;
    block.forward = glm::vec4(rays.forward, rays.isOrthographic ? 1.0 : 0.0);
    block.right = glm::vec4(glm::normalize(rays.right), 0.0);
    block.up = glm::vec4(glm::normalize(rays.up), 0.0);
    block.eyeVoxel = glm::vec4(voxelFromWorld * glm::dvec4(rays.eye, 1.0));
    block.forwardVoxel = direction(rays.forward, step);
    block.rightVoxel = direction(rays.right, offset);
    block.upVoxel = direction(rays.up, offset);
    block.viewport = {glm::vec2(rays.size), float(glm::length(rays.right)), float(glm::length(rays.up))};
    return block;
}

RayCaster::RayCaster()
    : resolve_("render/shaders/resolve_picture.comp"), findBeams_("render/shaders/find_beams.comp"),
      view_(sizeof(ViewBlock), "view") {}

gl::Program& RayCaster::programFor(const Frame& frame) {
    const bool isSculpted =
        frame.scene.sculpture != nullptr || frame.scene.view == field::SculptureView::Probe;
    const int key = 2 * static_cast<int>(frame.mode) + (isSculpted ? 1 : 0);
    auto& program = programs_[key];
    if (!program) {
        const int content = frame.mode == Mode::Overlay ? 1 : frame.mode == Mode::Segment ? 2 : 0;
        gl::Defines defines{{"MODE", std::to_string(static_cast<int>(frame.mode))},
                            {"CONTENT", std::to_string(content)}};
        if (isSculpted) {
            defines.emplace_back("SCULPTED", "1");
        }
        program = gl::Program("render/shaders/cast_rays.comp", defines);
    }
    return program;
}

void RayCaster::start(const Frame& frame) {
    VS_CHECK(frame.macrocells != nullptr);
    frame_ = frame;
    sample_ = 0;
    tile_ = 0;
    if (glm::ivec2(accumulation_.size()) != frame.rays.size) {
        accumulation_ =
            gl::Texture(frame.rays.size, gl::Format::RGBA32F, gl::Filter::Nearest, "accumulation");
        picture_ = gl::Texture(frame.rays.size, gl::Format::RGBA8, gl::Filter::Linear, "picture");
        beams_ = gl::Texture((frame.rays.size + kBeam - 1) / kBeam, gl::Format::RG32F, gl::Filter::Nearest, "beams");
    }
}

bool RayCaster::isComplete() const { return sample_ >= frame_.samples; }

void RayCaster::findBeams() {
    const gl::Pass pass("find beams");
    beams_.bindImage(0, gl::Access::Write);
    findBeams_.set(0, kBeam);
    findBeams_.dispatchOver(beams_.size(), gl::Barrier::Texture);
}

bool RayCaster::renderSome(double budgetMs) {
    const Timer timer;
    gl::Program& program = programFor(frame_);
    sceneBinding_.bind(frame_.scene);
    view_.writeValue(viewBlock(frame_.rays, frame_.scene.data->geometry));
    view_.bindUniform(1);
    frame_.macrocells->bind();
    if (sample_ == 0 && tile_ == 0) {
        findBeams();
    }
    beams_.bindTexture(5);
    accumulation_.bindImage(0, gl::Access::ReadWrite);
    const auto& geometry = frame_.scene.data->geometry;
    program.set(3, glm::vec2(float(frame_.xrayGain), float(geometry.diagonalMm() / geometry.stepMm())))
        .set(4, frame_.segmentColour)
        .set(5, float(frame_.sampleStep))
        .set(6, kBeam);
    const glm::ivec2 tiles = tileCount(frame_.rays.size);
    while (!isComplete()) {
        const gl::Pass pass("cast rays");
        program.set(0, glm::ivec2(tile_ % tiles.x, tile_ / tiles.x) * kTile)
            .set(1, sample_ == 0 ? kCentre : placeInPixel(sample_))
            .set(2, sample_ > 0 ? 1 : 0);
        const glm::ivec2 left = frame_.rays.size - glm::ivec2(tile_ % tiles.x, tile_ / tiles.x) * kTile;
        program.dispatchOver(glm::ivec3(glm::min(left, glm::ivec2(kTile)), 1), gl::Barrier::Image);
        if (++tile_ == tiles.x * tiles.y) {
            tile_ = 0;
            ++sample_;
        }
        gl::Context::finish(); // or the budget would count only submissions
        if (timer.milliseconds() >= budgetMs) {
            break;
        }
    }
    return isComplete();
}

void RayCaster::render(const Frame& frame) {
    start(frame);
    renderSome(1e9);
}

const gl::Texture& RayCaster::picture() {
    const gl::Pass pass("resolve picture");
    accumulation_.bindImage(0, gl::Access::Read);
    picture_.bindImage(1, gl::Access::Write);
    resolve_.dispatchOver(picture_.size(), gl::Barrier::All);
    return picture_;
}

image::Image RayCaster::readPicture() {
    image::Image out(frame_.rays.size.x, frame_.rays.size.y);
    const auto texels = picture().download({glm::ivec3(0), picture_.size()});
    std::transform(texels.begin(), texels.end(), out.rgba.begin(),
                   [](std::byte b) { return std::uint8_t(b); });
    return out;
}

} // namespace vs::render
