// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/drawn.h"
#include "studio/operations/filming.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace vs::studio {

// What a film is made of: the document when it is made.
struct FilmSubject {
    View view;
    int generation = 0; // that the segment at work shows
    // The steps that hold, the oldest first.
    std::vector<std::shared_ptr<const Operation>> steps = {};
};

// What one frame shows.
struct FilmFrame {
    View view;
    std::optional<int> generation = {};    // of the segment at work; without: as the document has it
    std::optional<std::size_t> steps = {}; // so many of the steps are done; without: all
    // How much is shown of what the last of these steps grew, from 0 to 1.
    double grown = 1;
    Drawn strokes = {}; // over the picture: what the pen has drawn of the next step so far
};

// Which frames a film has, and what each shows: a function of the film and its subject alone. Frames are
// spread evenly over each shot; the last frame of a shot shows its end, but for orbits that end where they
// began: the next turn's first frame is that.
class FilmPlan {
public:
    FilmPlan(const SaveMovie& film, FilmSubject subject);

    [[nodiscard]] int frameCount() const { return frameCount_; }
    [[nodiscard]] FilmFrame frame(int number) const;
    // The frame at a time of the film.
    [[nodiscard]] int frameAt(double seconds) const;

private:
    struct Part {
        Shot shot;
        int first = 0; // frame
        int count = 0;
    };
    [[nodiscard]] const Part& partOf(int frame) const;

    FilmSubject subject_;
    double framesPerSecond_;
    std::vector<Part> parts_;
    int frameCount_ = 0;
};

} // namespace vs::studio
