// SPDX-License-Identifier: Apache-2.0
#include "studio/document/film_player.h"

#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "image/film.h"
#include "studio/document/document_impl.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

FilmSubject subjectOf(const Contents& contents) {
    FilmSubject subject{contents.view};
    subject.generation = contents.region.exists() ? contents.region.growth()->playhead() : 0;
    for (const Edit& edit : contents.history.done()) {
        subject.steps.push_back(edit.operation);
    }
    return subject;
}

void expectSubject(const SaveMovie& film, const FilmSubject& subject) {
    for (const Shot& shot : film.shots) {
        if (shot.kind == Shot::Kind::Growth && subject.generation == 0) {
            throw Error("{}: the segment at work has not grown; a shot of growth shows how it did",
                        film.file);
        }
        if (shot.kind == Shot::Kind::Session && subject.steps.empty()) {
            throw Error("{}: nothing was done that a shot of the session could show", film.file);
        }
    }
}

} // namespace

FilmPlayer::FilmPlayer(Document::Impl& impl, const SaveMovie& film)
    : impl_(impl), film_(film), steps_(impl.contents.history.done().size()), generation_(generationNow()),
      view_(impl.contents.view), plan_(film, subjectOf(impl.contents)) {
    expectSubject(film, subjectOf(impl.contents));
    generationsBefore_.resize(steps_);
}

FilmPlayer::~FilmPlayer() {
    try {
        const ProgressListener toTheEnd([](auto) { return true; }); // what goes back is not given up as well
        goBack();
    } catch (const std::exception& error) {
        logNotice(error.what());
    }
}

void FilmPlayer::goBack() {
    showGeneration(generation_);
    travelTo(steps_);
    impl_.contents.show(view_);
}

int FilmPlayer::generationNow() const {
    return impl_.contents.region.exists() ? impl_.contents.region.growth()->playhead() : 0;
}

void FilmPlayer::showGeneration(int generation) {
    if (impl_.contents.region.exists() && generation != generationNow()) {
        impl_.contents.region.scrub(generation);
        ++impl_.contents.version;
    }
}

void FilmPlayer::travelTo(std::size_t steps) {
    History& history = impl_.contents.history;
    while (history.done().size() > steps) {
        impl_.travel(history.toUndo(), true);
        history.tookBack();
        generation_ = generationNow();
        generationsBefore_[history.done().size()] = generation_;
    }
    while (history.done().size() < steps) {
        impl_.travel(history.toRedo(), false);
        history.appliedAgain();
        generation_ = generationNow();
    }
}

void FilmPlayer::show(const FilmFrame& frame) {
    showGeneration(generation_); // undo and redo go on from what a step left
    const std::size_t steps = frame.steps.value_or(steps_);
    if (steps > 0 && frame.steps && !generationsBefore_[steps - 1]) {
        travelTo(std::min(steps - 1, impl_.contents.history.done().size())); // to see what the step found
    }
    travelTo(steps);
    if (!frame.steps) {
        showGeneration(frame.generation.value_or(generation_));
    } else if (steps > 0 && std::holds_alternative<Grow>(*impl_.contents.history.done().back().operation)) {
        const int before = generationsBefore_[steps - 1].value_or(0);
        showGeneration(before + int(std::lround(std::min(frame.grown, 1.0) * (generation_ - before))));
    }
}

image::Image FilmPlayer::picture(int number, glm::ivec2 size, int samples) {
    FilmFrame frame = plan_.frame(number);
    show(frame);
    if (frame.steps) { // parts are where they were then
        frame.view.pasted = impl_.contents.view.pasted;
    }
    SavePicture picture;
    picture.size = size;
    picture.samples = samples;
    picture.background = film_.background;
    picture.annotations = film_.annotations;
    return impl_.files.picture(picture, frame.view, frame.strokes);
}

Outcome Document::Impl::run(const SaveMovie& op, const std::filesystem::path& folder) {
    FilmPlayer player(*this, op);
    image::FilmSettings settings;
    settings.framesPerSecond = op.framesPerSecond;
    image::FilmWriter film(folder / op.file, op.size, settings);
    for (int frame = 0; frame < player.frameCount(); ++frame) {
        film.add(player.picture(frame, op.size, op.samples));
        reportProgress(double(frame + 1) / player.frameCount());
    }
    player.goBack();
    film.finish();
    return {{}, 0, 0, say("%1", op.file)};
}

image::Image Document::filmFrame(const SaveMovie& film, double seconds, glm::ivec2 size) {
    VS_CHECK(impl_->isIdle());
    FilmPlayer player(*impl_, film);
    image::Image picture = player.picture(player.frameAt(seconds), size, 1);
    player.goBack();
    return picture;
}

} // namespace vs::studio
