// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/cut_editor.h"

#include "base/check.h"
#include "base/error.h"
#include "studio/strokes/keep_connected_stroke.h"
#include "studio/strokes/patch_stroke.h"
#include "studio/strokes/peel_stroke.h"
#include "studio/strokes/pen_stroke.h"
#include "studio/strokes/segment_stroke.h"
#include "studio/strokes/solid_strokes.h"
#include "studio/strokes/sweep_stroke.h"

#include <algorithm>

namespace vs::studio {

namespace {

const PenCut* penCutOf(const Operation& operation) {
    const Drill* drill = std::get_if<Drill>(&operation);
    return drill != nullptr ? static_cast<const PenCut*>(drill) : std::get_if<Laser>(&operation);
}

// The pen has not been anywhere: an operation that says so means the place where its mask was drawn.
bool isUndrawn(const Operation& operation) {
    const PenCut* cut = penCutOf(operation);
    return cut != nullptr && cut->stroke.empty();
}

} // namespace

Operation withoutDetours(Operation operation) {
    const auto straighten = [](auto& op) {
        if constexpr (std::is_base_of_v<PenCut, std::decay_t<decltype(op)>>) {
            op.stroke = op.keepsDigging ? op.stroke : sculpt::straightened(op.stroke);
        }
    };
    std::visit(straighten, operation);
    return operation;
}

void CutEditor::begin(const Operation& operation) { begin(cutter_, operation); }

void CutEditor::begin(Cutter& cutter, const Operation& operation) {
    const sculpt::Limits limits = limits_.find(contents_);
    open(cutter, operation);
    contents_.sculpture.limitTo(limits);
}

void CutEditor::beginInHand(const Operation& operation) {
    Cutter* rough = cutter_.rough();
    if (rough == nullptr) {
        begin(operation);
        return;
    }
    contents_.sculpture.setRough(true);
    try {
        begin(*rough, operation);
    } catch (...) {
        contents_.sculpture.setRough(false);
        throw;
    }
}

void CutEditor::settle(const Operation& operation) {
    if (!isRough()) {
        return;
    }
    discard();
    begin(operation);
    try {
        if (!isUndrawn(operation)) {
            stroke_->replay();
        }
    } catch (...) {
        discard();
        throw;
    }
}

// The stroke that fills, or takes what is filled away, and what it is to change.
template <typename Use>
bool useFilling(const Operation& operation, Use use) {
    if (const auto* fill = std::get_if<Fill>(&operation)) {
        std::visit(
            [&](const auto& op) {
                use(op, {Cutter::Aim::At::Fill, std::uint8_t(fill->material)});
            },
            fill->stroke);
        return true;
    }
    if (const auto* hole = std::get_if<FillHole>(&operation)) {
        use(*hole, {Cutter::Aim::At::Fill, std::uint8_t(hole->material)});
        return true;
    }
    if (const auto* unfill = std::get_if<Unfill>(&operation)) {
        std::visit([&](const auto& op) { use(op, Cutter::Aim{Cutter::Aim::At::Filled}); }, unfill->stroke);
        return true;
    }
    return false;
}

void CutEditor::open(Cutter& cutter, const Operation& operation, const Cutter::Aim& aim) {
    const auto aimAndOpen = [&](const auto& stroke, const Cutter::Aim& its) {
        checkFilling(its);
        open(cutter, stroke, its);
    };
    if (aim.at == Cutter::Aim::At::All && useFilling(operation, aimAndOpen)) {
        return;
    }
    cutter.aim = aim;
    const auto onCanvas = [this](const std::optional<Canvas>& canvas) {
        return [this, canvas] { return display_.frame(canvas->view, canvas->viewport); };
    };
    const auto make = [&](const auto& op) -> std::unique_ptr<CutStroke> {
        using Op = std::decay_t<decltype(op)>;
        if constexpr (std::is_same_v<Op, Peel>) {
            return std::make_unique<PeelStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Drill> || std::is_same_v<Op, Laser>) {
            return std::make_unique<PenStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Sweep>) {
            return std::make_unique<SweepStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Scissors>) {
            return std::make_unique<ScissorsStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Clip>) {
            return std::make_unique<ClipStroke>(cutter, op);
        } else if constexpr (std::is_same_v<Op, KeepConnected>) {
            return std::make_unique<KeepConnectedStroke>(cutter, onCanvas(op.canvas), contents_.region, op);
        } else if constexpr (std::is_same_v<Op, FillHole>) {
            return std::make_unique<PatchStroke>(cutter, onCanvas(op.canvas), contents_.scan.volume, op);
        } else if constexpr (std::is_same_v<Op, CutSegment>) {
            return std::make_unique<SegmentStroke>(cutter, contents_.region, contents_.scan.field,
                                                   contents_.segments.working(), op);
        } else {
            return nullptr;
        }
    };
    stroke_ = std::visit(make, operation);
    VS_CHECK(stroke_ != nullptr);
    aim_ = aim;
    contents_.cuttingSince.reset();
    if (stroke_->onlyCuts()) {
        contents_.cuttingSince = stroke_->sculptureVersion();
    }
}

void CutEditor::checkFilling(const Cutter::Aim& aim) const {
    if (cutter_.cutsFiner()) {
        throw Error("this scan is worked on at a coarser level than its finest, where nothing can be filled: "
                    "open it at its finest");
    }
    const std::size_t count = contents_.filled.materials->size();
    if (aim.at == Cutter::Aim::At::Fill && aim.material > count) {
        throw Error("material: {} must be one of the materials that there are ({}); `material` adds them",
                    aim.material, count);
    }
}

Operation CutEditor::operation() const {
    const Operation& drawn = stroke_->operation();
    if (aim_.at != Cutter::Aim::At::Fill && aim_.at != Cutter::Aim::At::Filled) {
        return drawn;
    }
    return std::visit(
        [&](const auto& op) -> Operation {
            if constexpr (std::is_constructible_v<decltype(Unfill::stroke), decltype(op)>) {
                if (aim_.at == Cutter::Aim::At::Filled) {
                    return Unfill{op};
                }
            }
            if constexpr (std::is_constructible_v<decltype(Fill::stroke), decltype(op)>) {
                return Fill{aim_.material, op};
            }
            return op;
        },
        drawn);
}

void CutEditor::forget() {
    stroke_.reset();
    contents_.sculpture.limitTo({});
    contents_.cuttingSince.reset();
}

void CutEditor::discard() {
    const bool wasRough = isRough();
    contents_.sculpture.setRough(false); // the macrocells become those of the finest level again
    try {
        stroke_->discard();
    } catch (...) {
        contents_.sculpture.setRough(wasRough);
        throw;
    }
    forget();
    ++contents_.version;
}

void CutEditor::remember(const Operation& operation, sculpt::SculptureDelta& cut, bool isLimited) {
    const bool isTrim = std::visit(
        [](const auto& op) {
            if constexpr (requires { op.isTrim(); }) {
                return op.isTrim();
            }
            return false;
        },
        operation);
    Edit edit{shared(operation), {}, {}};
    edit.isLimited = isLimited && !cut.isEmpty();
    contents_.history.makeRoom();
    if (auto trim = contents_.trimmed.follow(contents_.sculpture, cut, isTrim); !trim.isEmpty()) {
        contents_.sculpture.refresh(trim.box()); // parts that were drawn meanwhile were without it
        edit.trim = std::move(trim);
    }
    if (!cut.isEmpty()) {
        edit.cut = std::move(cut);
    }
    if (stroke_->fillBefore() != nullptr && stroke_->fillBefore() != contents_.filled.fill) {
        edit.filledAfter = contents_.filled;
        edit.filledBefore = contents_.filled;
        edit.filledBefore->fill = stroke_->fillBefore();
    }
    contents_.remember(std::move(edit));
}

Phrase CutEditor::saidOf(std::size_t changedVoxels) const {
    if (changedVoxels > 0) {
        return say(VS_TEXT("library", "%1 voxels changed"), changedVoxels);
    }
    if (aim_.at == Cutter::Aim::At::Fill) {
        return say(VS_TEXT("library", "nothing was filled: no surface is seen there"));
    }
    if (aim_.at == Cutter::Aim::At::Filled) {
        return say(VS_TEXT("library", "nothing was taken away: nothing is filled there"));
    }
    if (contents_.sculpture.isLimited()) {
        return say(
            VS_TEXT("library", "nothing has changed: what lies there is spared, or was as it would be"));
    }
    return stroke_->onlyCuts()
               ? say(VS_TEXT("library",
                             "nothing was cut: nothing visible lies there that was not cut already"))
               : say(VS_TEXT("library", "nothing was restored: nothing was cut away there"));
}

Outcome CutEditor::finish() {
    VS_CHECK(!contents_.sculpture.isRough());
    sculpt::SculptureDelta delta;
    try {
        delta = stroke_->finish();
    } catch (...) { // no memory to hold what would undo it
        discard();
        throw;
    }
    Outcome outcome;
    outcome.voxelsTouched = delta.changedVoxels();
    try {
        if (const field::SharedFill& before = stroke_->fillBefore();
            before != nullptr && before != contents_.filled.fill) {
            outcome.voxelsTouched += field::changedVoxels(*before, *contents_.filled.fill);
            if (!field::FillTexture::hasRoomFor(*contents_.filled.fill)) {
                throw Error("material would lie in more places than this device has room for: fill less");
            }
        }
        outcome.message = saidOf(outcome.voxelsTouched);
        if (outcome.voxelsTouched > 0) {
            remember(operation(), delta, contents_.sculpture.isLimited());
        }
    } catch (...) {
        stroke_->takeBack(delta);
        forget();
        ++contents_.version;
        throw;
    }
    forget();
    return outcome;
}

template <typename Filling>
Outcome CutEditor::fillAtOnce(Filling& op) {
    if (const Fault fault = op.faultOf(); !fault.wanted.empty()) {
        throw Error("{}: {}", fault.place, fault.wanted);
    }
    std::visit(
        [&](auto& stroke) {
            if constexpr (requires { stroke.canvas; }) {
                contents_.fillIn(stroke.canvas);
            }
        },
        op.stroke);
    return cutAtOnce(op);
}

Outcome CutEditor::run(Fill& op) { return fillAtOnce(op); }
Outcome CutEditor::run(FillHole& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Unfill& op) { return fillAtOnce(op); }

template <typename Cut>
Outcome CutEditor::cutAtOnce(Cut& op) {
    if constexpr (requires { op.canvas; }) {
        contents_.fillIn(op.canvas);
    }
    begin(op);
    try {
        stroke_->replay();
    } catch (...) {
        discard();
        throw;
    }
    op = std::get<Cut>(operation());
    return finish();
}

Outcome CutEditor::run(Peel& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Drill& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Laser& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Sweep& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Scissors& op) { return cutAtOnce(op); }
Outcome CutEditor::run(Clip& op) { return cutAtOnce(op); }
Outcome CutEditor::run(KeepConnected& op) { return cutAtOnce(op); }
Outcome CutEditor::run(CutSegment& op) { return cutAtOnce(op); }

// The voxels of a delta that are cut now and were not before it; of them, where a range is given, those with
// values in that. The sculpture is as before the delta afterwards.
segment::VoxelSet CutEditor::takeBackAndTell(sculpt::SculptureDelta& delta,
                                             const std::optional<Range>& seen) {
    segment::VoxelSet set = segment::emptySet(delta.box());
    std::vector<std::vector<float>> after;
    for (const Box3& brick : delta.bricks()) {
        after.push_back(contents_.sculpture.values(brick));
    }
    contents_.sculpture.swap(delta);
    for (std::size_t n = 0; n < delta.bricks().size(); ++n) {
        const segment::VoxelSet brick{delta.bricks()[n], {}};
        const auto before = contents_.sculpture.values(brick.box);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const glm::ivec3 voxel = brick.voxelAt(i);
            const bool isCut = before[i] < 0.5F && after[n][i] >= 0.5F;
            if (isCut && (!seen || seen->contains(contents_.scan.volume.at(voxel)))) {
                set.inside[set.indexOf(voxel)] = 1;
            }
        }
    }
    return set;
}

// Does that for voxels of the finest level, in whatever range.
segment::FineSet CutEditor::takeBackAndTellFinest(sculpt::SculptureDelta& delta) {
    static_assert(sculpt::kFineBrick == field::kBrick); // both number bricks alike
    const sculpt::FineSculpture& finer = *contents_.sculpture.finer();
    segment::FineSet set(finer.dims());
    const auto after = finer.reader(); // both stay as they are
    std::vector<std::uint32_t> places;
    for (const auto& [place, brick] : delta.finer.bricks) {
        places.push_back(std::uint32_t(place));
    }
    contents_.sculpture.swap(delta);
    const auto before = finer.reader();
    for (const std::uint32_t place : places) {
        const Box3 box = set.boxOf(place);
        const std::vector<float> valuesBefore = before(box);
        const std::vector<float> valuesAfter = after(box);
        std::vector<std::uint8_t> isCut(valuesAfter.size());
        std::transform(valuesBefore.begin(), valuesBefore.end(), valuesAfter.begin(), isCut.begin(),
                       [](float was, float is) { return std::uint8_t(was < 0.5F && is >= 0.5F ? 1 : 0); });
        set.add(box, box, isCut);
    }
    return set;
}

template <typename Tell>
auto CutEditor::cutAndTakeBack(const BrushSegment& op, Tell takeBackAndTell) {
    const std::uint64_t content = contents_.sculpture.contentVersion();
    const Cutter::Aim scanAlone{Cutter::Aim::At::Scan};
    std::visit([&](const auto& drawn) { open(cutter_, drawn, scanAlone); }, op.stroke);
    sculpt::SculptureDelta delta;
    try {
        stroke_->replay();
        delta = stroke_->finish();
    } catch (...) {
        discard();
        throw;
    }
    forget();
    const std::uint64_t cut = contents_.sculpture.version();
    try {
        auto set = takeBackAndTell(delta);
        contents_.sculpture.contentIsAsAt(content);
        return set;
    } catch (...) {
        if (contents_.sculpture.version() == cut) { // it is still there
            contents_.sculpture.swap(delta);
        }
        contents_.sculpture.contentIsAsAt(content);
        throw;
    }
}

segment::VoxelSet CutEditor::wouldCut(const BrushSegment& op) {
    const std::optional<Range> seen = seenBy(op);
    return cutAndTakeBack(op, [&](sculpt::SculptureDelta& delta) {
        return delta.isEmpty() ? segment::VoxelSet() : takeBackAndTell(delta, seen);
    });
}

segment::FineSet CutEditor::wouldCutFinest(const BrushSegment& op) {
    const segment::FineSet set = cutAndTakeBack(op, [&](sculpt::SculptureDelta& delta) {
        return delta.isEmpty() ? segment::FineSet(contents_.region.finestGrid().dims)
                               : takeBackAndTellFinest(delta);
    });
    const std::optional<Range> seen = seenBy(op);
    return seen ? contents_.region.finestInRange(set, *seen) : set;
}

std::optional<Range> CutEditor::seenBy(const BrushSegment& op) const {
    return std::visit(
        [&](const auto& drawn) {
            return op.isToAdd ? std::optional(drawn.canvas->view.visibleRange(contents_.scan.volume.range))
                              : std::nullopt;
        },
        op.stroke);
}

} // namespace vs::studio
