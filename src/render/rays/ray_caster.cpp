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
#include <utility>

namespace vs::render {

namespace {

constexpr int kFewSquares = 256;     // no submission is shorter, but for what is left
constexpr double kSubmissionMs = 25; // nor much longer than this
constexpr glm::vec2 kCentre{0.5F, 0.5F};

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
    : findBeams_("render/shaders/find_beams.comp"), fillFilm_("render/shaders/fill_film.comp"),
      segmentColours_(sizeof(SegmentColours), "segment colours") {}

void RayCaster::start(const Frame& frame) {
    VS_CHECK(frame.macrocells != nullptr);
    VS_CHECK(frame.mode != Mode::Volume || frame.classification != nullptr);
    frame_ = frame;
    frame_.isInverted = frame.isInverted && (frame.mode == Mode::Mip || frame.mode == Mode::XRay);
    if (frame_.isInverted) {
        // The whole picture is complemented when it is resolved.
        frame_.background = complement(forInverted(frame.background));
    }
    begin();
    const glm::ivec2 size = frame.rays.size;
    if (glm::ivec2(accumulation_.size()) != size) {
        // Each time last what is asked for: where it is, the others are.
        squares_.resize(size);
        picture_ = gl::Texture(size, gl::Format::RGBA8, gl::Filter::Linear, "picture");
        accumulation_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "accumulation");
    }
    const bool hasParts = !frame.pasted.empty() || !frame.pulled.empty();
    if (hasParts && glm::ivec2(seenFront_.size()) != size) {
        seenBehind_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen behind");
        seenFront_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen in front");
    }
    if (hasParts && drawsTranslucent(frame) && glm::ivec2(seenGlass_.size()) != size) {
        seenGlassDepth_ = gl::Texture(size, gl::Format::R32F, gl::Filter::Nearest, "depth of seen glass");
        seenGlass_ = gl::Texture(size, gl::Format::RGBA32F, gl::Filter::Nearest, "seen glass");
    }
    chooseLevel();
    segmentColours_.writeValue(frame.segmentColours);
    arrangeParts();
}

void RayCaster::begin() {
    sample_ = 0;
    stage_ = 0;
    square_ = 0;
    hasBegunSample_ = false;
    awaited_ = 0;
    squaresAtOnce_ = kAllSquares;
    groupEnd_ = 0;
}

double RayCaster::share() const {
    if (isInGroups()) {
        const double ofGroups = double(groupBegin_) / std::max(squares_.active(), 1);
        return glm::mix(double(kSettling), double(frame_.samples), ofGroups) / frame_.samples;
    }
    double done = square_;
    double all = 0;
    for (std::size_t stage = 0; stage < stages(); ++stage) {
        all += squaresOfStage(stage);
        done += stage < stage_ ? squaresOfStage(stage) : 0;
    }
    return std::min((sample_ + (all > 0 ? done / all : 0)) / std::max(frame_.samples, 1), 1.0);
}

bool RayCaster::isComplete() const { return sample_ >= frame_.samples; }

void RayCaster::findBeams() {
    const gl::Pass pass("find beams");
    for (const Part& part : parts_) {
        bindPart(part);
        part.beams.bindImage(kBeamsImage, gl::Access::Write);
        findBeams_.set("beamPixels", beamPixels(frame_)).set("window", glm::vec4(window().lo, window().hi));
        findBeams_.dispatchOver(part.beams.size(), gl::Barrier::Texture);
    }
}

void RayCaster::listSquares() {
    squares_.forget();
    for (const Part& part : parts_) {
        squares_.mark(part.beams, beamPixels(frame_));
    }
    squares_.list(window());
    listPartSquares();
}

void RayCaster::listPartSquares() {
    for (Part& part : parts_) {
        if (hasParts()) {
            squares_.listPart(part.beams, beamPixels(frame_), part.squares);
        }
    }
}

void RayCaster::boundSlabs() {
    if (frame_.mode != Mode::Mip) {
        return;
    }
    for (Part& part : parts_) {
        bindPart(part);
        part.slabs.update(*part.macrocells, part.beams, beamPixels(frame_), float(sampleStep()));
    }
}

// Whether squares where nothing can be seen show more than the background: see behindFilm() in shading.glsl.
bool RayCaster::hasFilm() const {
    const bool isSeenAgainstFilm =
        frame_.mode == Mode::Mip || frame_.mode == Mode::XRay || frame_.mode == Mode::Overlay;
    const glm::vec3 brightest = glm::max(frame_.background.top, frame_.background.bottom);
    return isSeenAgainstFilm && glm::any(glm::greaterThan(brightest, Background{}.bottom));
}

// Samples of one place follow each other in the accumulated picture (an image) and its contrasts (storage).
void RayCaster::fillFilm() {
    const gl::Pass pass("fill film");
    bindPart(parts_.back());
    squares_.bind();
    const int empty = squares_.empty();
    fillFilm_.set("squareRange", glm::ivec2(squares_.all() - empty, empty))
        .set("pixelOffset", sample_ == 0 ? kCentre : placeInPixel(sample_))
        .set("addToPrevious", sample_ > 0 ? 1 : 0)
        .set("backgroundTop", glm::vec4(frame_.background.top, 0.0F))
        .set("backgroundBottom", glm::vec4(frame_.background.bottom, 0.0F));
    fillFilm_.dispatch(SquareLists::groupsFor(empty), gl::Barrier::All);
}

// What is the same for all parts.
void RayCaster::bindPicture() {
    if (frame_.classification != nullptr) {
        frame_.classification->bind();
    }
    accumulation_.bindImage(kAccumulationImage, gl::Access::ReadWrite);
    if (hasParts()) {
        seenFront_.bindImage(kSeenFrontImage, gl::Access::ReadWrite);
        seenBehind_.bindImage(kSeenBehindImage, gl::Access::ReadWrite);
    }
    if (hasParts() && drawsTranslucent(frame_)) {
        seenGlass_.bindImage(kSeenGlassImage, gl::Access::ReadWrite);
        seenGlassDepth_.bindImage(kSeenGlassDepthImage, gl::Access::ReadWrite);
    }
    segmentColours_.bindUniform(kSegmentColoursBlock);
}

// What a program that shows something needs to know of the picture.
void RayCaster::setPicture(gl::Program& program) {
    const auto& geometry = frame_.scene.data->geometry;
    program
        .set("exposure", glm::vec2(float(frame_.xrayGain), float(geometry.diagonalMm() / geometry.stepMm())))
        .set("backgroundTop", glm::vec4(frame_.background.top, frame_.background.isTransparent ? 1.0F : 0.0F))
        .set("backgroundBottom", glm::vec4(frame_.background.bottom, 0.0F));
    if (frame_.mode == Mode::Mip || frame_.mode == Mode::XRay) {
        program.set("isInverted", frame_.isInverted ? 1 : 0);
    }
}

void RayCaster::setSample(gl::Program& program, int count) const {
    program
        .set("squareRange", glm::ivec2(goesBackwards() ? endOfSquares() - square_ - count : square_, count))
        .set("pixelOffset", sample_ == 0 ? kCentre : placeInPixel(sample_))
        .set("addToPrevious", sample_ > 0 ? 1 : 0)
        .set("measuresContrast", frame_.endsEarly && sample_ == 1 ? 1 : 0);
}

void RayCaster::castSquares(const Part& part, int count) {
    const gl::Pass pass("cast rays");
    const Lattice lattice = latticeOf(sample_, frame_.samples, sampleStep());
    gl::Program& program = castRays_.with(part.defines);
    setPicture(program);
    setSample(program, count);
    program.set("corners", 8).set("sampleStep", float(sampleStep())).set("beamShift", beamShift(frame_));
    if (frame_.detail != nullptr) {
        rounds_.bindImage(kRoundsImage, gl::Access::ReadWrite);
        program.set("castRound", castRound());
    }
    if (hasParts()) {
        program.set("partScale", part.scale);
    }
    if (frame_.mode == Mode::Mip) {
        program.set("beamsAcross", part.beams.size().x);
    }
    if (frame_.mode == Mode::XRay || frame_.mode == Mode::Overlay) {
        program.set("lattice", glm::vec2(lattice.step, lattice.shift));
    }
    if (part.pulled) {
        program.set("pulled", *part.pulled);
    }
    if (showsMarks(frame_)) {
        const glm::dvec2 mm = part.rays.pixelWidths();
        program.set("pixelWidth", glm::vec2(mm.x / frame_.scene.data->geometry.stepMm(), mm.y));
    }
    program.dispatch(SquareLists::groupsFor(count), gl::Barrier::All);
}

gl::Program& RayCaster::showParts(bool clears) {
    gl::Defines defines = definesFor(frame_);
    const gl::Defines more = gl::switchesOn({{"CLEARS", clears}});
    defines.insert(defines.end(), more.begin(), more.end());
    return showParts_.with(defines);
}

void RayCaster::clearSeen() {
    const gl::Pass pass("clear parts");
    bindPart(parts_.back());
    squares_.bind();
    const int count = squares_.active();
    gl::Program& program = showParts(true);
    setSample(program, count);
    program.dispatch(SquareLists::groupsFor(count), gl::Barrier::All);
}

void RayCaster::showSeen(int count) {
    const gl::Pass pass("show parts");
    gl::Program& program = showParts(false);
    setPicture(program);
    setSample(program, count);
    program.dispatch(SquareLists::groupsFor(count), gl::Barrier::All);
}

int RayCaster::squaresOfStage(std::size_t stage) const {
    return hasParts() && stage < parts_.size() ? parts_[stage].squares.count : squares_.active();
}

void RayCaster::beginSample() {
    if (sample_ == 0) {
        findBeams();
        listSquares();
        boundSlabs();
        bindPicture();
    }
    if (hasFilm()) {
        fillFilm();
    }
    if (hasParts()) {
        clearSeen();
    }
}

void RayCaster::beginStage() {
    if (hasParts() && !isLastStage()) {
        bindPart(parts_[stage_]);
        squares_.bind(parts_[stage_].squares);
    } else {
        bindPart(parts_.back());
        squares_.bind();
    }
}

// Some squares of the current stage from the present one on.
void RayCaster::castSome(double milliseconds) {
    const bool shows = hasParts() && isLastStage();
    const bool isRepeated = awaited_ > 0;
    if (isRepeated) {
        if (!haveBricksCome(milliseconds)) {
            return;
        }
        beginStage(); // where there was no room for what came, the pool is another one now
    }
    double& pace = shows ? shownSquaresPerMs_ : parts_[stage_].squaresPerMs;
    const int left = endOfSquares() - square_;
    const int wanted = std::max(int(pace * std::min(milliseconds, kSubmissionMs)), kFewSquares);
    const int count = std::min({isRepeated ? awaited_ : wanted, left, squaresAtOnce_});
    const Timer submission;
    if (shows) {
        showSeen(count);
    } else {
        castSquares(parts_[stage_], count);
    }
    gl::Context::finish(); // or the budget would count only submissions
    pace = isRepeated ? pace : count / std::max(submission.milliseconds(), 1e-3);
    if (shows || frame_.detail == nullptr || !missesBricks(parts_[stage_], count)) {
        square_ += count;
    }
}

void RayCaster::endStage() {
    if (isInGroups()) {
        endSampleOfGroup();
        return;
    }
    square_ = 0;
    if (!isLastStage()) {
        ++stage_;
        return;
    }
    stage_ = 0;
    ++sample_;
    hasBegunSample_ = false;
    if (frame_.endsEarly && sample_ == kSettling) {
        squares_.setSettledAside();
        listPartSquares();
    }
    if (frame_.detail != nullptr && !hasParts() && sample_ == kSettling && sample_ < frame_.samples) {
        beginGroups();
    }
}

bool RayCaster::renderSome(double budgetMs) {
    const Timer timer;
    bindPicture();
    while (!isComplete()) {
        const int sample = sample_;
        if (!std::exchange(hasBegunSample_, true)) {
            beginSample();
        }
        beginStage();
        castSome(budgetMs - timer.milliseconds());
        if (square_ == endOfSquares()) {
            endStage();
        }
        // While pixels wait for bricks others have a sample more: a picture is shown of whole samples.
        const bool isWhole = frame_.detail != nullptr && sample_ > sample && !isInGroups();
        if (timer.milliseconds() >= budgetMs || isWhole) {
            break;
        }
    }
    return isComplete();
}

void RayCaster::render(const Frame& frame) {
    start(frame);
    while (!renderSome(1e9)) {
    }
}

const gl::Texture& RayCaster::picture() {
    resolve(resolve_.with({}));
    return picture_;
}

void RayCaster::resolve(gl::Program& program) {
    const gl::Pass pass("resolve picture");
    accumulation_.bindImage(kAccumulationImage, gl::Access::Read);
    picture_.bindImage(kPictureImage, gl::Access::Write);
    const Background& background = frame_.background;
    squares_.bindPlaces();
    const int shown = isLastStage() ? square_ : 0;
    program.set("window", glm::vec4(window().lo, window().hi))
        .set("progress", glm::ivec3(sample_, shown, squares_.occupied()))
        .set("isFilmAhead", stage_ > 0 || square_ > 0 ? 1 : 0)
        .set("isTransparent", background.isTransparent ? 1 : 0)
        .set("isFlat", background.top == background.bottom ? 1 : 0)
        .set("isBare", hasFilm() ? 0 : 1)
        .set("isInverted", frame_.isInverted ? 1 : 0)
        .set("settled", glm::ivec2(squares_.active(), kSettling))
        .set("backgroundTop", glm::vec4(background.top, 0.0F))
        .set("backgroundBottom", glm::vec4(background.bottom, 0.0F));
    program.dispatchOver({window().size(), 1}, gl::Barrier::All);
}

image::Image RayCaster::readPicture() {
    picture();
    return downloaded();
}

image::Image RayCaster::readPixelsDone() {
    rounds_.bindImage(kRoundsImage, gl::Access::Read);
    resolve(resolve_.with({{"PIXELS_DONE", "1"}}));
    return downloaded();
}

image::Image RayCaster::downloaded() const {
    const Box2 window = this->window();
    image::Image out(window.size().x, window.size().y);
    const auto texels = picture_.download({glm::ivec3(window.lo, 0), glm::ivec3(window.hi, 1)});
    std::transform(texels.begin(), texels.end(), out.rgba.begin(),
                   [](std::byte b) { return std::uint8_t(b); });
    return out;
}

} // namespace vs::render
