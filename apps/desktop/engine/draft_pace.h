// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::desktop {

// How coarse drafts of one kind have to be, from how long those before took.
class DraftPace {
public:
    // `scale`: how many times larger the pixels of the first draft are.
    explicit DraftPace(double scale) : scale_(scale) {}

    // Chooses the scale of the next draft: of so many pixels of the view, in so much time.
    double choose(double pixels, double milliseconds);
    // Takes note of what one took that had so many pixels of its own.
    void note(double pixels, double milliseconds);
    // Takes what another kind takes for the first guess.
    void assume(const DraftPace& other) {
        nanosPerPixel_ = nanosPerPixel_ == 0 ? other.nanosPerPixel_ : nanosPerPixel_;
    }
    // Nothing is known any more of how long drafts take.
    void forget() { nanosPerPixel_ = 0; }

private:
    double scale_;
    double nanosPerPixel_ = 0; // running estimate; 0: not known yet
};

} // namespace vs::desktop
