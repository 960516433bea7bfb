// SPDX-License-Identifier: Apache-2.0
#include "model/edits/editor.h"

#include "model/document/document_host.h"
#include "model/document/view_model.h"
#include "model/edits/free_room.h"
#include "model/hand/hand.h"
#include "model/hand/tool.h"
#include "model/texts/library_texts.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_mark.h"
#include "studio/document/live_stroke.h"
#include "studio/document/part_queries.h"

namespace vs::desktop {

Editor::Editor(DocumentHost& host, ViewModel& view, Hand& hand) : host_(host), view_(view), hand_(hand) {}

bool Editor::apply(const studio::Operation& operation, const std::filesystem::path& outputFolder) {
    return change([&] { return host_.document()->apply(operation, outputFolder); });
}

bool Editor::rewind(int generations) {
    return change([&] { return host_.document()->rewindFurther(generations); });
}

bool Editor::change(const std::function<studio::Outcome()>& edit) {
    if (host_.geometry() == nullptr || host_.isLoading() || host_.isAway()) {
        return false;
    }
    hand_.tool().finishPending();
    if (host_.facts()->isStrokeOpen()) {
        return false;
    }
    interrupt(); // what has grown so far is an operation of its own
    view_.flush();
    const volume::GridGeometry before = host_.facts()->geometry;
    const bool done = perform(edit);
    view_.adopt();
    host_.wake();
    emit host_.changed();
    if (done && !(host_.facts()->geometry == before)) {
        emit voxelsMoved();
    }
    return done;
}

bool Editor::perform(const std::function<studio::Outcome()>& edit) {
    studio::Outcome outcome;
    const bool isDone = host_.workLong([&] { outcome = edit(); }, LongWork::Input::GivesUp);
    if (isDone) {
        report(outcome);
        emit done(outcome.milliseconds);
    }
    return isDone;
}

// "Peel: 120 voxels changed", "Undone: peel"; and "Nothing was cut: ...", which says by itself what was
// tried.
void Editor::report(const studio::Outcome& outcome) {
    const auto capitalised = [](const QString& text) { return text.left(1).toUpper() + text.mid(1); };
    const QString name = capitalised(libraryText(outcome.name));
    const QString message = libraryText(outcome.message);
    if (outcome.name == "undo" || outcome.name == "redo") {
        host_.say((outcome.name == "undo" ? tr("Undone: %1") : tr("Redone: %1")).arg(message));
    } else if (std::string_view(outcome.message.text).starts_with("nothing ")) {
        host_.say(capitalised(message));
    } else {
        host_.say(message.isEmpty() ? name : name + ": " + message);
    }
}

bool Editor::beginStroke(const std::function<void(studio::Document&, const studio::Canvas&)>& begin) {
    interrupt();
    const auto on = view_.canvas();
    return host_.workLong([&] { begin(*host_.document(), on); });
}

bool Editor::endMark(bool keep) {
    bool isDone = false;
    if (keep) {
        isDone = perform([&] { return host_.document()->mark().commit(); });
    } else if (host_.workLong([&] { host_.document()->mark().discard(); })) {
        isDone = true;
        host_.say(tr("Nothing was changed"));
    }
    host_.wake();
    emit host_.changed();
    return isDone;
}

bool Editor::endStroke(bool keep) {
    if (host_.geometry() == nullptr || !host_.facts()->isStrokeOpen()) {
        return false;
    }
    if (host_.facts()->isMarkOpen()) {
        return endMark(keep);
    }
    if (keep && hand_.tool().actsOnSegment()) {
        const studio::Operation stroke = host_.document()->stroke().operation(); // it has shown what it takes
        host_.workLong([&] { host_.document()->stroke().discard(); });
        return cut(stroke);
    }
    bool isDone = false;
    if (keep) {
        isDone = perform([&] { return host_.document()->stroke().commit(); });
    } else if (host_.workLong([&] { host_.document()->stroke().discard(); })) {
        isDone = true;
        host_.say(tr("Nothing was changed"));
    }
    host_.wake();
    emit host_.changed();
    return isDone;
}

studio::Operation Editor::aimed(const studio::Operation& stroke) const {
    if (!hand_.tool().actsOnMaterial()) {
        return stroke;
    }
    return std::visit(
        [&](const auto& drawn) -> studio::Operation {
            if constexpr (std::is_constructible_v<decltype(studio::Unfill::stroke), decltype(drawn)>) {
                if (hand_.tool().isReversed()) {
                    return studio::Unfill{drawn};
                }
            }
            if constexpr (std::is_constructible_v<decltype(studio::Fill::stroke), decltype(drawn)>) {
                return studio::Fill{hand_.material(), drawn};
            }
            if constexpr (std::is_same_v<std::decay_t<decltype(drawn)>, studio::Scissors>) {
                return studio::FillHole{hand_.material(), drawn.outline, drawn.depth, drawn.radius,
                                        drawn.canvas};
            }
            return drawn;
        },
        stroke);
}

bool Editor::prepareMaterial() {
    const bool isNeeded = hand_.tool().actsOnMaterial() && !hand_.tool().isReversed();
    if (!isNeeded || host_.geometry() == nullptr) {
        return true;
    }
    const auto count = int(host_.facts()->materials->size());
    if (hand_.material() <= count) {
        return true;
    }
    studio::SetMaterial material;
    material.number = count + 1;
    const bool isMade = apply(material);
    hand_.setMaterial(count + 1);
    return isMade;
}

bool Editor::cut(const studio::Operation& stroke) {
    if (!hand_.tool().actsOnSegment()) {
        return apply(aimed(stroke));
    }
    studio::BrushSegment brush;
    brush.isToAdd = hand_.tool().adds();
    std::visit(
        [&](const auto& drawn) {
            if constexpr (std::is_constructible_v<decltype(brush.stroke), decltype(drawn)>) {
                brush.stroke = drawn;
            }
        },
        stroke);
    return apply(brush);
}

FreeRoom Editor::roomBesideAll() {
    auto& parts = host_.document()->parts();
    FreeRoom room(view_.shown().camera, *host_.geometry(), view_.viewport());
    room.take(parts.remainingCells());
    for (const studio::SeenPart& part : parts.seen()) {
        room.take(parts.cells(part.at), part.place);
    }
    const auto pulledOut = parts.seenPulledOut();
    auto cells = parts.segmentCells(studio::labelsOf(pulledOut));
    for (const studio::SeenPart& part : pulledOut) {
        room.take(cells[std::uint8_t(part.at)], part.place);
    }
    return room;
}

bool Editor::pullOut(const std::string& segment) {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return false;
    }
    const auto facts = host_.facts();
    const studio::SegmentInfo* info = facts->segments.find(segment);
    if (info != nullptr && info->pulledOut) {
        return apply(studio::PutBack{segment});
    }
    if (info == nullptr || facts->voxels[info->label] == 0) {
        host_.say(tr("Nothing to pull out: the segment is empty"));
        return false;
    }
    render::Placement place;
    render::Camera camera;
    view_.flush();
    const bool isPlaced = host_.workLong([&] {
        auto& parts = host_.document()->parts();
        FreeRoom room = roomBesideAll();
        const auto cells = parts.segmentCells({info->label})[info->label];
        if (!cells.empty()) {
            const render::Placement drawn = room.find(cells);
            room.take(cells, drawn);
            place = parts.putFor(drawn, parts.segmentBoxes()[info->label]);
        }
        camera = room.cameraOnAll();
    });
    if (!isPlaced || !apply(studio::PullOut{segment, place})) {
        return false;
    }
    auto view = view_.shown();
    view.camera = camera;
    view_.showView(view);
    emit pulledOut(segment);
    return true;
}

bool Editor::paste(bool takesTrimmed) {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return false;
    }
    render::Placement place;
    render::Camera camera;
    bool isSomething = false;
    view_.flush();
    const bool isPlaced = host_.workLong([&] {
        auto& document = *host_.document();
        FreeRoom room = roomBesideAll();
        const auto part = document.parts().nextCells(takesTrimmed);
        isSomething = !part.empty();
        if (isSomething) {
            const render::Placement drawn = room.find(part);
            room.take(part, drawn);
            place = document.parts().putFor(drawn, document.parts().nextBox(takesTrimmed));
            camera = room.cameraOnAll();
        }
    });
    if (isPlaced && !isSomething) {
        host_.say(
            takesTrimmed
                ? tr("Nothing to paste: nothing visible was cut since the last paste")
                : tr("Nothing to paste: tools have cut nothing visible since the last paste. What Keep and "
                     "Clip took away: Edit > Paste All"));
        return false;
    }
    if (!isPlaced || !apply(studio::Paste{place, {}, takesTrimmed})) {
        return false;
    }
    auto view = view_.shown();
    view.camera = camera;
    view_.showView(view);
    emit pasted();
    return true;
}

} // namespace vs::desktop
