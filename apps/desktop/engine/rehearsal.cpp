// SPDX-License-Identifier: Apache-2.0
#include "engine/rehearsal.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/context.h"
#include "phantom/phantom.h"
#include "render/slices/slice_renderer.h"
#include "studio/document/live_growth.h"
#include "studio/document/live_mark.h"
#include "studio/document/live_stroke.h"

#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <bit>
#include <csignal>
#include <limits>

namespace vs::desktop {

namespace {

using namespace studio;

// At every scale that drafts have, neither it nor its squares of 4 and 8 pixels are a power of two wide or
// high: what windows are like but for one in twenty.
constexpr glm::ivec2 kViewport{328, 296};
constexpr glm::dvec2 kMiddle = glm::dvec2(kViewport) / 2.0; // the ball's, too
constexpr double kUnlimitedMs = std::numeric_limits<double>::max();
constexpr double kInside = 100;
constexpr double kOutside = 0;

volume::Volume scanLike(const ScanKind& kind) {
    field::limitQuads(kind.isLarge ? 0 : field::kMostQuadBytes);
    // Cells and bricks are counted by halves, quarters and eighths of these, which are powers of two or not
    // as they are themselves.
    const glm::ivec3 dims = glm::mix(glm::ivec3(80), glm::ivec3(64), kind.isPowerOfTwo);
    return phantom::makeBall(dims, glm::dvec3(dims) / 2.0, 26, kInside, kOutside, 6, kind.type);
}

Sketch circleAt(glm::dvec2 centre, double radius) {
    return {Shape::Circle, {centre, centre + glm::dvec2(radius, 0)}};
}

} // namespace

ScanKind kindOf(const field::Field& field) {
    using volume::ScalarType;
    const gl::Format format = field.texels.format();
    ScanKind kind{format == gl::Format::R8    ? ScalarType::UInt8
                  : format == gl::Format::R16 ? ScalarType::Int16
                                              : ScalarType::Float32};
    for (int axis = 0; axis < 3; ++axis) {
        kind.isPowerOfTwo[axis] = std::has_single_bit(unsigned(field.geometry.dims[axis]));
    }
    kind.isLarge = !field.quads;
    return kind;
}

std::string toText(const ScanKind& kind) {
    return fmt::format("{}:{:d}{:d}{:d}:{}", volume::name(kind.type), kind.isPowerOfTwo.x,
                       kind.isPowerOfTwo.y, kind.isPowerOfTwo.z, kind.isLarge ? "large" : "small");
}

std::optional<ScanKind> kindFromText(const std::string& text) {
    for (const auto type : volume::kScalarTypes) {
        for (int bits = 0; bits < 16; ++bits) {
            const ScanKind kind{type, {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}, (bits & 8) != 0};
            if (toText(kind) == text) {
                return kind;
            }
        }
    }
    return std::nullopt;
}

Rehearsal::Rehearsal(const ScanKind& kind)
    : document_(scanLike(kind)),
      pictures_(gl::Context::isSoftware(), [](const std::function<void()>& work) { work(); }) {
    pictures_.setViewport(kViewport);
    pictures_.setDocument(&document_);
    planStrokes();
    planGrowth();
    planMarks();
    planCutsAndParts();
    planSegments();
    planModes();
}

bool Rehearsal::doNext() {
    if (done_ == steps_.size()) {
        return false;
    }
    steps_[done_++]();
    return true;
}

// --- what is done, in the order in which a person is likely to

void Rehearsal::planStrokes() {
    PenCut cut;
    cut.mask = circleAt(kMiddle, 12);
    cut.canvas = canvas();
    const auto draw = [](LiveStroke& stroke) {
        stroke.drawAt({kMiddle, 0.5});
        stroke.drawAt({kMiddle + glm::dvec2(15, 8), 1});
    };
    addStroke(Drill{cut}, draw);
    addStroke(Drill{cut}, draw); // on what is cut already
    Laser laser;
    static_cast<PenCut&>(laser) = cut;
    addStroke(laser, draw);
    addStroke(Peel{.mask = cut.mask, .canvas = cut.canvas}, [](LiveStroke& stroke) { stroke.peelTo(2); });
    addOperation(Undo{});
}

void Rehearsal::planGrowth() {
    addSeed();
    addView([](View& view) { view.mode = render::Mode::Segment; });
    add([this] {
        document_.growing().begin();
        document_.growing().growFor(kUnlimitedMs, 5);
        showDraft();
    });
    add([this] {
        document_.growing().growFor(kUnlimitedMs, 20);
        document_.growing().end();
        showFull();
    });
    add([this] {
        document_.growing().scrub(10);
        showDraft();
        document_.growing().endScrub();
    });
    addOperation(Rewind{4});
    addOperation(Undo{});
    addSeed(); // where segments are seen
    add([this] { document_.visibleHistogram(kUnlimitedMs); });
}

void Rehearsal::addSeed() {
    add([this] {
        Seed seed;
        seed.strokes = {{Shape::FreeForm, {kMiddle, kMiddle + glm::dvec2(8, 3)}}};
        seed.canvas = canvas();
        document_.apply(seed);
    });
}

// A line on the surface, and segments beside it.
void Rehearsal::planMarks() {
    addView([](View& view) { view.mode = render::Mode::Surface; });
    add([this] {
        Mark line;
        line.canvas = canvas();
        document_.mark().begin(line);
        document_.mark().drawAt({kMiddle, 1});
        showDraft();
        document_.mark().drawAt({kMiddle + glm::dvec2(15, 8), 1});
        document_.mark().commit();
        showFull();
    });
    addView([](View& view) { view.mode = render::Mode::Segment; });
    addOperation(Undo{});
}

void Rehearsal::planCutsAndParts() {
    addView([](View& view) { view.mode = render::Mode::Surface; });
    Scissors scissors{circleAt(kMiddle + glm::dvec2(60, 0), 30)};
    scissors.canvas = canvas();
    addOperation(scissors);
    const glm::dvec3 middle = glm::dvec3(document_.volume().geometry.dims) / 2.0;
    Clip clip;
    clip.planes = {
        {document_.volume().geometry.worldFromVoxel * glm::dvec4(middle.x, middle.y, middle.z + 16, 1),
         {0, 0, -1}}};
    addStroke(clip, [clip](LiveStroke& stroke) { stroke.clipTo(clip); });
    addOperation(Undo{});
    addOperation(Paste{{{80, 0, 5}}});
    addOperation(MovePart{0, {{-80, 10, 0}}});
    addOperation(Undo{});
    addOperation(Undo{});
    Sweep sweep;
    sweep.mask = circleAt({0, 0}, 6);
    sweep.path.kind = SweepPath::Kind::Surface;
    sweep.path.stroke = {kMiddle - glm::dvec2(20, 0), kMiddle, kMiddle + glm::dvec2(20, 5)};
    sweep.canvas = canvas();
    addOperation(sweep);
    KeepConnected keep;
    keep.pixel = kMiddle + glm::dvec2(0, 30);
    keep.canvas = canvas();
    addOperation(keep);
}

void Rehearsal::planSegments() {
    PaintSegment paint;
    const glm::dvec3 middle = glm::dvec3(document_.volume().geometry.dims) / 2.0;
    paint.trail.points = {middle, middle + glm::dvec3(6, 2, 0)};
    paint.trail.radiusMm = 3;
    addOperation(paint);
    Absorb absorb;
    absorb.strokes = {{Shape::FreeForm, {kMiddle, kMiddle + glm::dvec2(8, 3)}}};
    absorb.expansions = 2;
    absorb.canvas = canvas();
    addOperation(absorb);
    addOperation(PullOut{std::nullopt, {{60, 0, 0}}});
    addOperation(Undo{});
    addOperation(CutSegment{});
    addOperation(Undo{});
}

void Rehearsal::planModes() {
    for (const render::Mode mode : render::kModes) {
        addView([mode](View& view) { view.mode = mode; });
    }
    add([this] { showSlice(); });
    addOperation(UnCut{});
    addOperation(ReSeed{});
    planMarks(); // on what is whole
    for (const render::Mode mode : render::kModes) {
        addView([mode](View& view) { view.mode = mode; });
    }
    addView([](View& view) {
        view.mode = render::Mode::Surface;
        view.sampling = field::Sampling::Tricubic;
    });
    addView([](View& view) { view.shadows = true; });
}

void Rehearsal::addOperation(const Operation& operation) {
    add([this, operation] {
        document_.apply(operation);
        showDraft();
    });
}

void Rehearsal::addStroke(const Operation& operation, const Leading& lead) {
    add([this, operation, lead] {
        document_.stroke().begin(operation);
        lead(document_.stroke());
        showDraft();
    });
    add([this] {
        document_.stroke().commit();
        showFull();
    });
}

void Rehearsal::addView(const std::function<void(View&)>& change) {
    add([this, change] {
        View view = document_.view();
        change(view);
        document_.showView(view);
        showFull();
    });
}

// --- pictures, as the window makes them

Canvas Rehearsal::canvas() const { return {document_.view(), kViewport}; }

void Rehearsal::showDraft() {
    pictures_.interact();
    while (pictures_.step(kUnlimitedMs) == PictureLoop::State::Busy) {
    }
}

void Rehearsal::showFull() {
    showDraft();
    pictures_.rest();
    while (pictures_.step(kUnlimitedMs) != PictureLoop::State::Complete) {
    }
}

void Rehearsal::showSlice() {
    render::SliceView view;
    view.index = document_.volume().geometry.dims.z / 2;
    view.size = kViewport;
    render::SliceRenderer slices;
    slices.render(document_.slice(view));
    gl::Context::finish();
}

// --- a process of its own

void standBack() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const sched_param none{};
    sched_setscheduler(0, SCHED_IDLE, &none);
    constexpr int least = 19;
    setpriority(PRIO_PROCESS, 0, least); // where that policy is refused
}

namespace {

void doAll(Rehearsal& rehearsal) {
    for (bool isMore = true; isMore;) {
        try {
            isMore = rehearsal.doNext();
        } catch (const Error& error) { // the steps after it are of use all the same
            logNotice(error.what());
        }
    }
}

} // namespace

int rehearse(const std::string& renderer, const std::string& text) {
    try {
        const auto kind = kindFromText(text);
        if (!kind) {
            throw Error("--rehearse {} {}: no such kind of scan; an example is {}", renderer, text,
                        toText(ScanKind()));
        }
        const auto context = gl::Context::createHeadless();
        if (context.device().renderer == renderer) { // else nothing that is compiled would be of use
            Rehearsal rehearsal(*kind);
            doAll(rehearsal);
        }
        return 0;
    } catch (const std::exception& error) {
        logNotice(error.what());
        return 1;
    }
}

} // namespace vs::desktop
