// SPDX-License-Identifier: Apache-2.0
#include "tools/playing/act.h"

#include "tools/playing/drawn_acts.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

// What needs no time of its own.
class InstantAct : public Act {
public:
    InstantAct(studio::Operation operation, StudioController& studio)
        : Act(studio), operation_(std::move(operation)) {}

    State advance(double) override { return complete(); }
    State complete() override {
        // What a session writes was written when it was made.
        if (studio::isOutput(operation_)) {
            return studio_.host().guard([&] { studio_.host().document()->logOutput(operation_); })
                       ? State::Done
                       : State::Failed;
        }
        return studio_.editor().apply(operation_) ? State::Done : State::Failed;
    }
    std::optional<studio::Operation> stopHere() override { return operation_; }

private:
    studio::Operation operation_;
};

// The camera flies to where the session looks from; all else of the view is there at once.
class ViewAct : public Act {
public:
    ViewAct(const studio::SetView& operation, StudioController& studio)
        : Act(studio), operation_(operation), from_(studio.view().shown().camera),
          view_(studio::changed(studio.view().shown(), operation)) {}

    State advance(double seconds) override {
        constexpr double kSeconds = 0.9;
        if (from_ == view_.camera || seconds >= kSeconds) {
            return complete();
        }
        studio::View view = view_;
        view.camera = between(glm::smoothstep(0.0, kSeconds, seconds));
        studio_.view().showView(view);
        return State::GoesOn;
    }
    State complete() override {
        studio_.view().showView(view_);
        return State::Done;
    }
    std::optional<studio::Operation> stopHere() override { return operation_; }

private:
    [[nodiscard]] render::Camera between(double share) const {
        render::Camera camera = view_.camera;
        const auto turn = [share](double a, double b) { return a + share * std::remainder(b - a, 360.0); };
        camera.azimuthDegrees = turn(from_.azimuthDegrees, camera.azimuthDegrees);
        camera.elevationDegrees = turn(from_.elevationDegrees, camera.elevationDegrees);
        camera.rollDegrees = turn(from_.rollDegrees, camera.rollDegrees);
        camera.zoom = from_.zoom * std::pow(camera.zoom / from_.zoom, share);
        camera.panMm = glm::mix(from_.panMm, camera.panMm, share);
        return camera;
    }

    studio::SetView operation_;
    render::Camera from_;
    studio::View view_;
};

// A line to be read before it goes on.
class NoteAct : public Act {
public:
    NoteAct(studio::Note note, StudioController& studio) : Act(studio), note_(std::move(note)) {}

    State advance(double seconds) override {
        constexpr double kSecondsPerCharacter = 0.03;
        const double reading = std::clamp(kSecondsPerCharacter * double(note_.text.size()), 1.0, 4.0);
        return seconds < reading ? State::GoesOn : complete();
    }
    State complete() override { return studio_.editor().apply(note_) ? State::Done : State::Failed; }
    std::optional<studio::Operation> stopHere() override { return note_; }

private:
    studio::Note note_;
};

// A region that grows, faster and faster where it is not said how far.
class GrowAct : public Act {
public:
    GrowAct(const studio::Grow& operation, StudioController& studio) : Act(studio), operation_(operation) {}

    State advance(double seconds) override {
        if (!isGrowing_) {
            isGrowing_ = studio_.host().workLong(
                [&] { studio_.host().document()->growing().begin(operation_.sculptureView); });
            if (!isGrowing_) {
                return State::Failed;
            }
        }
        const int due = std::min(dueAfter(seconds), operation_.generations.value_or(kAll));
        if (due <= grown_ && due < operation_.generations.value_or(kAll)) {
            return State::GoesOn;
        }
        constexpr double kPortionMs = 30;
        return growTo(due, kPortionMs);
    }
    State complete() override {
        if (!isGrowing_) {
            return studio_.editor().apply(operation_) ? State::Done : State::Failed;
        }
        constexpr double kNoHurry = 1e9;
        return growTo(operation_.generations.value_or(kAll), kNoHurry);
    }
    std::optional<studio::Operation> stopHere() override {
        if (!isGrowing_) {
            return operation_;
        }
        end();
        studio::Grow left = operation_;
        if (left.generations) {
            *left.generations -= grown_;
        }
        return left;
    }

private:
    static constexpr int kAll = 1 << 30;

    [[nodiscard]] int dueAfter(double seconds) const {
        if (operation_.generations) {
            const double all = *operation_.generations;
            return int(std::ceil(all * seconds / std::clamp(all / 25, 1.0, 4.0)));
        }
        return 1 + int(20 * seconds + 15 * seconds * seconds);
    }
    State growTo(int generation, double budgetMs) {
        bool goesOn = false;
        int grown = 0;
        const bool isDone = studio_.host().workLong([&] {
            studio::Document& document = *studio_.host().document();
            const int before = document.facts()->growth.extent;
            goesOn = document.growing().growFor(budgetMs, generation - grown_);
            grown = document.facts()->growth.extent - before;
        });
        if (!isDone) {
            return State::Failed;
        }
        grown_ += grown;
        if (goesOn && grown_ < operation_.generations.value_or(kAll)) {
            return State::GoesOn;
        }
        return end();
    }
    State end() {
        isGrowing_ = false;
        return studio_.editor().perform([&] { return studio_.host().document()->growing().end(); })
                   ? State::Done
                   : State::Failed;
    }

    studio::Grow operation_;
    bool isGrowing_ = false;
    int grown_ = 0; // generations
};

// A region that goes back to an earlier generation, or forward to a later one that it had.
class ScrubAct : public Act {
public:
    ScrubAct(studio::Operation operation, StudioController& studio)
        : Act(studio), operation_(std::move(operation)), from_(studio.host().facts()->growth.generation),
          to_(targetOf(operation_, from_)) {}

    State advance(double seconds) override {
        const double all = std::abs(to_ - from_);
        const double share = seconds / std::clamp(all / 30, 0.8, 4.0);
        if (share >= 1 || !studio_.host().facts()->growth.hasSeeds) {
            return complete();
        }
        const int generation = int(std::lround(glm::mix(double(from_), double(to_), share)));
        return studio_.host().workLong(
                   [&] { studio_.host().document()->growing().scrub(std::max(generation, 1)); })
                   ? State::GoesOn
                   : State::Failed;
    }
    State complete() override {
        drop();
        return studio_.editor().apply(operation_) ? State::Done : State::Failed;
    }
    std::optional<studio::Operation> stopHere() override {
        drop();
        return operation_;
    }

private:
    // Back to where it was: the operation says the rest.
    void drop() {
        if (studio_.host().facts()->isScrubbing()) {
            studio_.host().workLong([&] { studio_.host().document()->growing().dropScrub(); });
        }
    }
    static int targetOf(const studio::Operation& operation, int from) {
        const auto* rewind = std::get_if<studio::Rewind>(&operation);
        return rewind != nullptr ? std::max(from - rewind->generations, 1)
                                 : std::get<studio::ShowGeneration>(operation).generation;
    }

    studio::Operation operation_;
    int from_;
    int to_;
};

} // namespace

std::unique_ptr<Act> actFor(const studio::Operation& operation, StudioController& studio) {
    return std::visit(
        [&](const auto& op) -> std::unique_ptr<Act> {
            using Op = std::decay_t<decltype(op)>;
            if constexpr (std::is_same_v<Op, studio::SetView>) {
                return std::make_unique<ViewAct>(op, studio);
            } else if constexpr (std::is_same_v<Op, studio::Note>) {
                return std::make_unique<NoteAct>(op, studio);
            } else if constexpr (std::is_same_v<Op, studio::Grow>) {
                return std::make_unique<GrowAct>(op, studio);
            } else if constexpr (std::is_same_v<Op, studio::Rewind> ||
                                 std::is_same_v<Op, studio::ShowGeneration>) {
                return std::make_unique<ScrubAct>(op, studio);
            } else if constexpr (std::is_same_v<Op, studio::Peel> || std::is_same_v<Op, studio::Drill> ||
                                 std::is_same_v<Op, studio::Laser>) {
                return std::make_unique<CutAct>(op, studio);
            } else if constexpr (requires { op.canvas; } || std::is_same_v<Op, studio::BrushSegment>) {
                return std::make_unique<DrawnAct>(op, studio);
            } else {
                return std::make_unique<InstantAct>(op, studio);
            }
        },
        operation);
}

} // namespace vs::desktop
