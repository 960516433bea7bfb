// SPDX-License-Identifier: Apache-2.0
#include "render/rays/ray_caster.h"

#include "base/check.h"
#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace vs::render {

namespace {

constexpr int kSquare = 8;           // pixels; a work group's
constexpr int kFewSquares = 256;     // no submission is shorter, but for what is left
constexpr double kSubmissionMs = 25; // nor much longer than this
constexpr glm::vec2 kCentre{0.5F, 0.5F};
constexpr int kSettling = 2; // samples, after which some squares may take no more

// Evenly spread places in a pixel: the R2 sequence (Roberts 2018, "The unreasonable effectiveness of
// quasirandom sequences"), starting at the centre so that one sample is the plain picture.
glm::vec2 placeInPixel(int sample) {
    constexpr double g = 1.32471795724474602596;
    const double n = sample;
    return glm::vec2(glm::fract(glm::dvec2(0.5 + n / g, 0.5 + n / (g * g))));
}

// Where along its rays a sample of the picture looks at the data in X-ray: places `step` apart, shifted by a
// part of that.
struct Lattice {
    float step = 0; // steps
    float shift = 0.5F;
};

// Samples of a pixel are averaged, so each after the first may be coarser where they lie between one another:
// together they are as close as the first alone, which is seen on its own.
Lattice latticeOf(int sample, int samples, double sampleStep) {
    constexpr int mostCoarse = 4;
    if (sample == 0) {
        return {float(sampleStep)};
    }
    const int others = samples - 1;
    const double golden = 0.61803398874989485; // any few in a row are spread evenly
    return {float(std::min(others, mostCoarse) * sampleStep), float(glm::fract(0.5 + sample * golden))};
}

glm::ivec2 squareCount(glm::ivec2 size) { return (size + kSquare - 1) / kSquare; }

// Work groups for so many squares: as many rows as a software renderer has threads; see squares.glsl.
glm::ivec3 groupsFor(int squares) {
    const int rows = std::clamp(int(std::thread::hardware_concurrency()), 1, 64);
    return {(squares + rows - 1) / rows, rows, 1};
}

} // namespace

Mode modeFromName(const std::string& text) {
    if (const auto mode = enumeratorOf<Mode>(text)) {
        return *mode;
    }
    throw UsageError("mode '{}' does not exist; choose surface, mip, xray, overlay, segment or volume", text);
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
    block.viewForward = glm::vec4(rays.forward, rays.isOrthographic ? 1.0 : 0.0);
    block.viewRight = glm::vec4(glm::normalize(rays.right), 0.0);
    block.viewUp = glm::vec4(glm::normalize(rays.up), 0.0);
    block.eyeVoxel = glm::vec4(voxelFromWorld * glm::dvec4(rays.eye, 1.0));
    block.forwardVoxel = direction(rays.forward, step);
    block.rightVoxel = direction(rays.right, offset);
    block.upVoxel = direction(rays.up, offset);
    block.viewport = {glm::vec2(rays.size), float(glm::length(rays.right)), float(glm::length(rays.up))};
    return block;
}

RayCaster::RayCaster()
    : resolve_("render/shaders/resolve_picture.comp"), findBeams_("render/shaders/find_beams.comp"),
      listSquares_("render/shaders/list_squares.comp"), fillFilm_("render/shaders/fill_film.comp"),
      squareCounts_(2 * sizeof(std::uint32_t), "square counts"),
      segmentColours_(glm::ivec2(256, 1), gl::Format::RGBA32F, gl::Filter::Nearest, "segment colours") {}

void RayCaster::start(const Frame& frame) {
    VS_CHECK(frame.macrocells != nullptr);
    VS_CHECK(frame.mode != Mode::Volume || frame.classification != nullptr);
    frame_ = frame;
    frame_.isInverted = frame.isInverted && (frame.mode == Mode::Mip || frame.mode == Mode::XRay);
    if (frame_.isInverted) {
        // The whole picture is complemented when it is resolved.
        frame_.background = complement(forInverted(frame.background));
    }
    sample_ = 0;
    square_ = 0;
    const glm::ivec2 size = frame.rays.size;
    if (glm::ivec2(accumulation_.size()) != size) {
        accumulation_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "accumulation");
        picture_ = gl::Texture(size, gl::Format::RGBA8, gl::Filter::Linear, "picture");
        const glm::ivec2 squares = squareCount(size);
        const std::size_t bytes = std::size_t(squares.x * squares.y) * sizeof(std::uint32_t);
        squares_.reserve(bytes);
        placeOfSquare_.reserve(bytes);
        contrasts_.reserve(bytes);
        unsettled_.reserve(bytes);
    }
    const bool hasParts = !frame.pasted.empty() || !frame.pulled.empty();
    if (hasParts && glm::ivec2(seenFront_.size()) != size) {
        seenFront_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen in front");
        seenBehind_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen behind");
    }
    if (hasParts && drawsTranslucent(frame) && glm::ivec2(seenGlass_.size()) != size) {
        seenGlass_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen glass");
        seenGlassDepth_ = gl::Texture(size, gl::Format::R32F, gl::Filter::Nearest, "depth of seen glass");
    }
    segmentColours_.upload({glm::ivec3(0), segmentColours_.size()},
                           std::as_bytes(std::span(frame.segmentColours.entries)));
    arrangeParts();
}

double RayCaster::share() const {
    const double ofSample = activeSquares_ > 0 ? double(square_) / activeSquares_ : 0;
    return std::min((sample_ + ofSample) / std::max(frame_.samples, 1), 1.0);
}

bool RayCaster::isComplete() const { return sample_ >= frame_.samples; }

void RayCaster::findBeams() {
    const gl::Pass pass("find beams");
    for (const Part& part : parts_) {
        bindPart(part);
        part.beams.bindImage(kBeamsImage, gl::Access::Write);
        findBeams_.set("beamPixels", beamPixels(frame_));
        findBeams_.dispatchOver(part.beams.size(), gl::Barrier::Texture);
    }
}

void RayCaster::listSquares() {
    const gl::Pass pass("list squares");
    const glm::ivec2 count = squareCount(frame_.rays.size);
    parts_.back().beams.bindTexture(kBeamsTexture);
    squares_.bindStorage(kSquaresStorage);
    placeOfSquare_.bindStorage(kPlacesStorage);
    squareCounts_.clear();
    squareCounts_.bindStorage(kSquareCountsStorage);
    // Where parts are drawn beside one another, their beams differ.
    listSquares_.set("squareCount", count)
        .set("beamPixels", beamPixels(frame_))
        .set("takeAll", parts_.size() > 1 ? 1 : 0);
    listSquares_.dispatchOver({count, 1}, gl::Barrier::Storage);
    occupiedSquares_ = activeSquares_ = int(squareCounts_.readValue<std::uint32_t>());
    contrasts_.clear();
}

// After two samples: squares where they agree take no more.
void RayCaster::setSettledAside() {
    const gl::Pass pass("set settled squares aside");
    squares_.bindStorage(kSquaresStorage);
    squareCounts_.clear();
    squareCounts_.bindStorage(kSquareCountsStorage);
    placeOfSquare_.bindStorage(kPlacesStorage);
    contrasts_.bindStorage(kContrastsStorage);
    unsettled_.bindStorage(kOrderedStorage);
    gl::Program& program = setAside_.with({});
    program.set("squareCount", squareCount(frame_.rays.size)).set("occupied", occupiedSquares_);
    const glm::ivec2 all = squareCount(frame_.rays.size);
    program.dispatchOverList(std::size_t(all.x) * std::size_t(all.y), gl::Barrier::Storage);
    activeSquares_ = int(squareCounts_.readValue<std::uint32_t>());
    std::swap(squares_, unsettled_);
}

void RayCaster::boundSlabs() {
    if (frame_.mode != Mode::Mip) {
        return;
    }
    for (Part& part : parts_) {
        bindPart(part);
        part.slabs.update(*part.macrocells, part.beams, beamPixels(frame_), float(frame_.sampleStep));
    }
}

// Whether squares where nothing can be seen show more than the background: see behindFilm() in shading.glsl.
bool RayCaster::hasFilm() const {
    const bool isSeenAgainstFilm =
        frame_.mode == Mode::Mip || frame_.mode == Mode::XRay || frame_.mode == Mode::Overlay;
    const glm::vec3 brightest = glm::max(frame_.background.top, frame_.background.bottom);
    return isSeenAgainstFilm && glm::any(glm::greaterThan(brightest, Background{}.bottom));
}

void RayCaster::fillFilm() {
    const gl::Pass pass("fill film");
    const glm::ivec2 all = squareCount(frame_.rays.size);
    const int empty = all.x * all.y - occupiedSquares_;
    fillFilm_.set("squareRange", glm::ivec2(occupiedSquares_, empty))
        .set("pixelOffset", sample_ == 0 ? kCentre : placeInPixel(sample_))
        .set("addToPrevious", sample_ > 0 ? 1 : 0)
        .set("backgroundTop", glm::vec4(frame_.background.top, 0.0F))
        .set("backgroundBottom", glm::vec4(frame_.background.bottom, 0.0F));
    fillFilm_.dispatch(groupsFor(empty), gl::Barrier::Image);
}

int RayCaster::squaresFor(double milliseconds) const {
    const double squares = squaresPerMs_ * std::min(milliseconds, kSubmissionMs);
    return std::min(std::max(int(squares), kFewSquares), activeSquares_ - square_);
}

// What is the same for all parts.
void RayCaster::bindPicture() {
    if (frame_.classification != nullptr) {
        frame_.classification->bind();
    }
    accumulation_.bindImage(kAccumulationImage, gl::Access::ReadWrite);
    if (parts_.size() > 1) {
        seenFront_.bindImage(kSeenFrontImage, gl::Access::ReadWrite);
        seenBehind_.bindImage(kSeenBehindImage, gl::Access::ReadWrite);
    }
    if (parts_.size() > 1 && drawsTranslucent(frame_)) {
        seenGlass_.bindImage(kSeenGlassImage, gl::Access::ReadWrite);
        seenGlassDepth_.bindImage(kSeenGlassDepthImage, gl::Access::ReadWrite);
    }
    segmentColours_.bindTexture(kSegmentColoursTexture);
    squares_.bindStorage(kSquaresStorage);
    contrasts_.bindStorage(kContrastsStorage);
}

void RayCaster::setPicture(gl::Program& program) {
    const auto& geometry = frame_.scene.data->geometry;
    program
        .set("exposure", glm::vec2(float(frame_.xrayGain), float(geometry.diagonalMm() / geometry.stepMm())))
        .set("corners", 8)
        .set("sampleStep", float(frame_.sampleStep))
        .set("beamShift", beamShift(frame_))
        .set("backgroundTop", glm::vec4(frame_.background.top, frame_.background.isTransparent ? 1.0F : 0.0F))
        .set("backgroundBottom", glm::vec4(frame_.background.bottom, 0.0F));
    if (frame_.mode == Mode::Mip) {
        program.set("beamsAcross", parts_.back().beams.size().x);
    }
    if (frame_.mode == Mode::Mip || frame_.mode == Mode::XRay) {
        program.set("isInverted", frame_.isInverted ? 1 : 0);
    }
}

// One sample of so many squares from the present one on, part by part.
void RayCaster::castSquares(int count) {
    const Lattice lattice = latticeOf(sample_, frame_.samples, frame_.sampleStep);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        gl::Program& program = castRays_.with(part.defines);
        if (parts_.size() > 1) {
            bindPart(part);
        }
        program.set("squareRange", glm::ivec2(square_, count))
            .set("pixelOffset", sample_ == 0 ? kCentre : placeInPixel(sample_))
            .set("addToPrevious", sample_ > 0 ? 1 : 0)
            .set("measuresContrast", frame_.endsEarly && sample_ == 1 ? 1 : 0);
        if (frame_.mode == Mode::XRay || frame_.mode == Mode::Overlay) {
            program.set("lattice", glm::vec2(lattice.step, lattice.shift));
        }
        if (parts_.size() > 1) {
            program.set("partOfPicture", glm::ivec2(int(i), int(parts_.size()))).set("partScale", part.scale);
        }
        if (part.pulled) {
            program.set("pulled", *part.pulled);
        }
        program.dispatch(groupsFor(count), gl::Barrier::Image);
    }
}

bool RayCaster::renderSome(double budgetMs) {
    const Timer timer;
    if (sample_ == 0 && square_ == 0) {
        findBeams();
        listSquares();
        boundSlabs();
    }
    bindPicture();
    bindPart(parts_.back());
    for (const Part& part : parts_) {
        setPicture(castRays_.with(part.defines));
    }
    while (!isComplete()) {
        if (square_ == 0 && hasFilm()) {
            fillFilm();
        }
        const gl::Pass pass("cast rays");
        const Timer submission;
        const int count = squaresFor(budgetMs - timer.milliseconds());
        castSquares(count);
        gl::Context::finish(); // or the budget would count only submissions
        squaresPerMs_ = count / std::max(submission.milliseconds(), 1e-3);
        square_ += count;
        if (square_ == activeSquares_) {
            square_ = 0;
            ++sample_;
            if (frame_.endsEarly && sample_ == kSettling) {
                setSettledAside();
                squares_.bindStorage(kSquaresStorage);
            }
        }
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
    accumulation_.bindImage(kAccumulationImage, gl::Access::Read);
    picture_.bindImage(kPictureImage, gl::Access::Write);
    const Background& background = frame_.background;
    placeOfSquare_.bindStorage(kPlacesStorage);
    resolve_.set("progress", glm::ivec3(sample_, square_, occupiedSquares_))
        .set("isTransparent", background.isTransparent ? 1 : 0)
        .set("isFlat", background.top == background.bottom ? 1 : 0)
        .set("isBare", hasFilm() ? 0 : 1)
        .set("isInverted", frame_.isInverted ? 1 : 0)
        .set("settled", glm::ivec2(activeSquares_, kSettling))
        .set("backgroundTop", glm::vec4(background.top, 0.0F))
        .set("backgroundBottom", glm::vec4(background.bottom, 0.0F));
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
