// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"
#include "render/camera/monotone_cubic.h"

#include <vector>

namespace vs::render {

// Where the viewer is at a time of a film.
struct CameraKey {
    double seconds = 0;
    Camera camera;
    // Added to the shorter way from the key before: whole turns of azimuth, elevation and roll, each positive
    // or negative. Of two ways that are equally short, the positive one counts as the shorter.
    glm::ivec3 wholeTurns{0};

    bool operator==(const CameraKey&) const = default;
};

// A way of the viewer through key frames. Angles go steadily from key to key, so that the patient's axis
// stays upright while a turntable turns and nothing rolls unless its keys do; zoom goes by ratios. The
// projection is that of the key before.
struct Flight {
    std::vector<CameraKey> keys;
    Ends ends = Ends::Rest; // Loop: the last key shows what the first shows, and is not a frame of its own

    bool operator==(const Flight&) const = default;
};

// Throws Error when there are no keys, when their times do not increase, or when a loop does not close: its
// last key shows something else than its first.
void checkFlight(const Flight& flight);

// From the first key to the last.
double durationSeconds(const Flight& flight);

// The camera at a time; before the first key and after the last it rests there. Its angles are continuous and
// may be beyond half a turn; at a key they are those of the key up to whole turns, and all else is the key's
// to the bit. The flight must be one that checkFlight() accepts.
Camera cameraAt(const Flight& flight, double seconds);

// The cameras of all frames of a film at constant rate, one at least. They are spread evenly from the first
// key to the last, so that the film's duration is right to half a frame; a loop's last frame comes one step
// before its first. Throws Error as checkFlight() does, or when the rate is not positive.
std::vector<Camera> flightFrames(const Flight& flight, double framesPerSecond);

// Ready-made flights, all from the given camera at 0 seconds. `seconds` is how long one takes, more than 0.

// Goes around the patient's axis; positive degrees move the viewer to the patient's left. Whole turns loop at
// constant speed, others begin and end at rest.
Flight turntable(const Camera& camera, double degrees, double seconds);

// Goes over the patient's head (positive degrees) or under the feet. Whole turns loop at constant speed.
Flight tiltOver(const Camera& camera, double degrees, double seconds);

// Swings once to the patient's left and right by so many degrees each (negative: right first), as a pendulum
// does, and loops.
Flight rocking(const Camera& camera, double degrees, double seconds);

// Goes around the patient's axis while the elevation becomes another one.
Flight spiral(const Camera& camera, double degrees, double toElevationDegrees, double seconds);

// Comes nearer by a factor (more than 0; below 1: goes away).
Flight zoomIn(const Camera& camera, double factor, double seconds);

} // namespace vs::render
