// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/film_plan.h"

#include "render/camera/flight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::studio {

namespace {

using render::Camera;

// --- orbits

bool endsWhereItBegan(const Shot& shot) {
    const bool turns = shot.orbit == Shot::Orbit::Turntable || shot.orbit == Shot::Orbit::Tilt;
    return shot.kind == Shot::Kind::Still &&
           (shot.orbit == Shot::Orbit::Rock ||
            (turns && shot.amount != 0 && std::remainder(shot.amount, 360.0) == 0));
}

render::Flight flightOf(const Shot& shot, const Camera& from) {
    // A spiral goes up while it turns: a person sees the crown, then comes back down to look ahead.
    constexpr double spiralElevation = 60;
    switch (shot.orbit) {
    case Shot::Orbit::Turntable:
        return render::turntable(from, shot.amount, shot.seconds);
    case Shot::Orbit::Rock:
        return render::rocking(from, shot.amount, shot.seconds);
    case Shot::Orbit::Tilt:
        return render::tiltOver(from, shot.amount, shot.seconds);
    case Shot::Orbit::Spiral:
        return render::spiral(from, shot.amount, from.elevationDegrees + spiralElevation, shot.seconds);
    case Shot::Orbit::Approach:
        return render::zoomIn(from, shot.amount, shot.seconds);
    case Shot::Orbit::None:
        break;
    }
    return {{{0, from}}};
}

// What an orbit adds to a camera that moves by itself.
Camera withOrbit(Camera camera, const Shot& shot, const Camera& from, double seconds) {
    if (shot.orbit == Shot::Orbit::None) {
        return camera;
    }
    const Camera there = render::cameraAt(flightOf(shot, from), seconds);
    camera.azimuthDegrees += there.azimuthDegrees - from.azimuthDegrees;
    camera.elevationDegrees += there.elevationDegrees - from.elevationDegrees;
    camera.rollDegrees += there.rollDegrees - from.rollDegrees;
    camera.zoom *= there.zoom / from.zoom;
    return camera;
}

// --- between views

double mixed(double from, double to, double share) { return from + (to - from) * share; }

// From rest to rest.
double gentle(double share) {
    share = std::clamp(share, 0.0, 1.0);
    return share * share * (3 - 2 * share);
}

// A view on the way from one to another: what cannot be between them is the other's from the start.
View between(const View& from, const View& to, double share) {
    View view = to;
    if (share >= 1) {
        return view;
    }
    const double way = gentle(share);
    const render::Flight flight{{{0, from.camera}, {1, to.camera}}};
    view.camera = render::cameraAt(flight, std::clamp(share, 0.0, 1.0));
    view.range = {mixed(from.range.lo, to.range.lo, way), mixed(from.range.hi, to.range.hi, way)};
    return view;
}

// --- key frames

// The values that the keys give for something, with the times at which they do; `fallback` where none does.
template <typename Get>
double keyed(const std::vector<FilmKey>& keys, double seconds, double fallback, Get get) {
    std::vector<double> times;
    std::vector<double> values;
    for (const FilmKey& key : keys) {
        if (const std::optional<double> value = get(key)) {
            times.push_back(key.seconds);
            values.push_back(*value);
        }
    }
    return times.empty() ? fallback : render::monotoneCubic(times, values, seconds);
}

Camera cameraOf(const std::vector<FilmKey>& keys, double seconds, const Camera& fallback) {
    render::Flight flight;
    for (const FilmKey& key : keys) {
        if (key.view.camera) {
            flight.keys.push_back({key.seconds, *key.view.camera, {key.wholeTurns, 0, 0}});
        }
    }
    return flight.keys.empty() ? fallback : render::cameraAt(flight, seconds);
}

void placeParts(const std::vector<FilmKey>& keys, double seconds, std::vector<render::Placement>& places) {
    for (std::size_t part = 0; part < places.size(); ++part) {
        const render::Placement before = places[part];
        const auto number = [&](auto get) {
            return keyed(keys, seconds, get(before), [&](const FilmKey& key) {
                const auto& given = key.view.pasted;
                return given && part < given->size() ? std::optional<double>(get((*given)[part]))
                                                     : std::nullopt;
            });
        };
        for (int axis = 0; axis < 3; ++axis) {
            places[part].moveMm[axis] = number([axis](const render::Placement& p) { return p.moveMm[axis]; });
            places[part].turnDegrees[axis] =
                number([axis](const render::Placement& p) { return p.turnDegrees[axis]; });
        }
        places[part].scale = number([](const render::Placement& p) { return p.scale; });
    }
}

FilmFrame keyedFrame(const Shot& shot, double seconds, const FilmSubject& subject) {
    const auto& keys = shot.keys;
    FilmFrame frame{subject.view};
    for (const FilmKey& key : keys) { // what changes at the keys
        if (key.seconds <= seconds || &key == &keys.front()) {
            SetView step = key.view;
            step.pasted.reset(); // parts are the document's; only their places are the film's
            frame.view = changed(frame.view, step);
        }
    }
    frame.view.camera = cameraOf(keys, seconds, subject.view.camera);
    const auto limit = [&](double Range::*end) {
        return keyed(keys, seconds, subject.view.range.*end, [end](const FilmKey& key) {
            return key.view.range ? std::optional((*key.view.range).*end) : std::nullopt;
        });
    };
    frame.view.range = {limit(&Range::lo), limit(&Range::hi)};
    frame.view.spread =
        keyed(keys, seconds, subject.view.spread, [](const FilmKey& key) { return key.view.spread; });
    placeParts(keys, seconds, frame.view.pasted);
    const auto generationOf = [](const FilmKey& key) {
        return key.generation ? std::optional(double(*key.generation)) : std::nullopt;
    };
    if (std::any_of(keys.begin(), keys.end(),
                    [](const FilmKey& key) { return key.generation.has_value(); })) {
        frame.generation = int(std::lround(keyed(keys, seconds, subject.generation, generationOf)));
    }
    return frame;
}

// --- a session that is played

// Where the person stood who drew a step; before it was drawn, the view of before.
View viewOf(const Drawn& drawn, View before) {
    if (drawn.canvas) {
        const View& canvas = drawn.canvas->view;
        before.camera = canvas.camera;
        before.mode = canvas.mode;
        before.range = canvas.range;
        before.sculptureView = canvas.sculptureView;
        before.sampling = canvas.sampling;
        before.transferFunction = canvas.transferFunction;
        before.hidesAbove = canvas.hidesAbove;
        before.surfaceSmoothing = canvas.surfaceSmoothing;
    }
    return before;
}

// The first part of a line, by its points.
Drawn::Line beginningOf(const Drawn::Line& line, double share) {
    const auto count = std::size_t(std::ceil(share * double(line.size())));
    return {line.begin(),
            line.begin() + std::ptrdiff_t(std::min(std::max<std::size_t>(count, 1), line.size()))};
}

// What the pen has drawn so far: first what it leads, then its way.
Drawn drawnSoFar(Drawn drawn, double share) {
    if (drawn.way.size() > 1) {
        drawn.way = beginningOf(drawn.way, share);
        return drawn;
    }
    for (Drawn::Line& line : drawn.lines) {
        line = beginningOf(line, share);
    }
    if (share < 1) { // an outline is a line until it is closed
        for (const Drawn::Line& area : drawn.areas) {
            drawn.lines.push_back(beginningOf(area, share));
        }
        drawn.areas.clear();
        drawn.lineWidth = drawn.lineWidth > 0 ? drawn.lineWidth : 2;
    }
    return drawn;
}

FilmFrame playedFrame(double share, const FilmSubject& subject) {
    constexpr double arrives = 0.3; // of a step's time: the camera is there
    constexpr double isDrawn = 0.7; // and all is drawn
    const std::size_t count = subject.steps.size();
    // One more: back to the view in which the film was made.
    const double at = share * double(count + 1);
    const auto step = std::min(std::size_t(at), count);
    const double now = at - double(step);
    View before = subject.view;
    View view = subject.view;
    for (std::size_t n = 0; n <= step; ++n) {
        before = view;
        view = n < count ? viewOf(drawnFor(*subject.steps[n]), view) : subject.view;
        before = n == 0 ? view : before;
    }
    FilmFrame frame{between(before, view, now / arrives)};
    frame.steps = step;
    if (step == count) {
        return frame;
    }
    const Drawn drawn = drawnFor(*subject.steps[step]);
    const double begins = drawn.isEmpty() ? arrives : isDrawn;
    if (now >= begins) {
        frame.steps = step + 1;
        frame.grown = (now - begins) / (1 - begins);
    } else if (!drawn.isEmpty() && now >= arrives) {
        frame.strokes = drawnSoFar(drawn, (now - arrives) / (isDrawn - arrives));
    }
    return frame;
}

FilmFrame grownFrame(const Shot& shot, double share, const FilmSubject& subject) {
    FilmFrame frame{subject.view};
    const double shown = shot.isBackward ? 1 - share : share;
    frame.generation = std::max(1, int(std::lround(shown * subject.generation)));
    return frame;
}

FilmFrame frameOf(const Shot& shot, double share, const FilmSubject& subject) {
    switch (shot.kind) {
    case Shot::Kind::Growth:
        return grownFrame(shot, share, subject);
    case Shot::Kind::Session:
        return playedFrame(share, subject);
    case Shot::Kind::Keys:
        return keyedFrame(shot, share * shot.seconds, subject);
    case Shot::Kind::Still:
        break;
    }
    return {subject.view};
}

} // namespace

FilmPlan::FilmPlan(const SaveMovie& film, FilmSubject subject)
    : subject_(std::move(subject)), framesPerSecond_(film.framesPerSecond) {
    for (const Shot& shot : film.shots) {
        const int count = std::max(1, int(std::lround(shot.seconds * film.framesPerSecond)));
        parts_.push_back({shot, frameCount_, count});
        frameCount_ += count;
    }
}

int FilmPlan::frameAt(double seconds) const {
    return int(std::clamp(std::floor(seconds * framesPerSecond_), 0.0, double(frameCount_ - 1)));
}

const FilmPlan::Part& FilmPlan::partOf(int frame) const {
    return *std::prev(std::upper_bound(parts_.begin(), parts_.end(), frame,
                                       [](int number, const Part& part) { return number < part.first; }));
}

FilmFrame FilmPlan::frame(int number) const {
    const Part& part = partOf(number);
    const int last = std::max(1, endsWhereItBegan(part.shot) ? part.count : part.count - 1);
    const double share = double(number - part.first) / last;
    FilmFrame frame = frameOf(part.shot, share, subject_);
    // Strokes are seen from where they were drawn: a session has its own way.
    if (part.shot.kind != Shot::Kind::Session) {
        frame.view.camera =
            withOrbit(frame.view.camera, part.shot, subject_.view.camera, share * part.shot.seconds);
    }
    return frame;
}

} // namespace vs::studio
