// SPDX-License-Identifier: Apache-2.0
#include "render/camera/flight.h"

#include "base/check.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vs::render {

namespace {

constexpr double kTurn = 360; // degrees
constexpr double kTie =
    1e-9; // turns; ways that differ by less count as equally short, whatever rounding says
constexpr double kClosed = 1e-6; // degrees, mm and zoom: what nobody sees when a loop closes

glm::dvec3 anglesOf(const Camera& camera) {
    return {camera.azimuthDegrees, camera.elevationDegrees, camera.rollDegrees};
}

// The whole turns that bring an angle nearest to another.
double turnsTowards(double degrees, double toDegrees) {
    return std::floor((toDegrees - degrees) / kTurn + 0.5 + kTie);
}

// How many whole turns, beside the shorter way, it takes to turn by so many degrees.
int turnsBeside(double degrees) { return -int(turnsTowards(degrees, 0)); }

bool isWholeTurns(double degrees) {
    return degrees != 0 && std::abs(std::remainder(degrees, kTurn)) < kClosed;
}

// The angles of all keys without jumps, by the ways that the keys ask for. Whole turns are added to the angle
// as it is given, so that it stays exact where there are none.
std::vector<glm::dvec3> continuousAngles(const std::vector<CameraKey>& keys) {
    std::vector<glm::dvec3> angles;
    for (const CameraKey& key : keys) {
        glm::dvec3 given = anglesOf(key.camera);
        for (int axis = 0; axis < 3 && !angles.empty(); ++axis) {
            const double turns = turnsTowards(given[axis], angles.back()[axis]) + key.wholeTurns[axis];
            given[axis] += kTurn * turns;
        }
        angles.push_back(given);
    }
    return angles;
}

bool showTheSame(const Camera& a, const Camera& b) {
    const glm::dvec3 turned = anglesOf(a) - anglesOf(b);
    double most = std::max(std::abs(a.zoom - b.zoom), glm::length(a.panMm - b.panMm));
    for (int axis = 0; axis < 3; ++axis) {
        most = std::max(most, std::abs(std::remainder(turned[axis], kTurn)));
    }
    return most < kClosed && a.projection == b.projection;
}

// Values of the keys, read at a time.
class KeyCurves {
public:
    KeyCurves(const Flight& flight, double seconds) : ends_(flight.ends), seconds_(seconds) {
        for (const CameraKey& key : flight.keys) {
            times_.push_back(key.seconds);
        }
    }

    template <typename ValueOfKey>
    [[nodiscard]] double operator()(const ValueOfKey& valueOfKey) const {
        std::vector<double> values;
        for (std::size_t n = 0; n < times_.size(); ++n) {
            values.push_back(valueOfKey(n));
        }
        return monotoneCubic(times_, values, seconds_, ends_);
    }

    // The last key that is not after the time; the first, if all are.
    [[nodiscard]] std::size_t keyBefore() const {
        const auto after = std::upper_bound(times_.begin(), times_.end(), seconds_);
        return after == times_.begin() ? 0 : std::size_t(after - times_.begin()) - 1;
    }

private:
    std::vector<double> times_;
    Ends ends_;
    double seconds_;
};

Flight between(const Camera& from, const Camera& to, double seconds, glm::ivec3 wholeTurns = glm::ivec3(0)) {
    VS_CHECK(seconds > 0);
    return {{{0, from}, {seconds, to, wholeTurns}}};
}

} // namespace

void checkFlight(const Flight& flight) {
    if (flight.keys.empty()) {
        throw Error("a flight without key frames: give it one or more");
    }
    for (std::size_t n = 1; n < flight.keys.size(); ++n) {
        const double before = flight.keys[n - 1].seconds;
        const double after = flight.keys[n].seconds;
        if (!(after > before)) {
            throw Error("key frame {} at {} s does not come after the one at {} s; give increasing times",
                        n + 1, after, before);
        }
    }
    if (flight.ends == Ends::Loop && !showTheSame(flight.keys.front().camera, flight.keys.back().camera)) {
        throw Error("the last key frame of a loop shows something else than its first; give it that camera");
    }
}

double durationSeconds(const Flight& flight) {
    return flight.keys.empty() ? 0 : flight.keys.back().seconds - flight.keys.front().seconds;
}

Camera cameraAt(const Flight& flight, double seconds) {
    const KeyCurves curve(flight, seconds);
    const auto& keys = flight.keys;
    const std::size_t before = curve.keyBefore();
    const std::vector<glm::dvec3> angles = continuousAngles(keys);
    const double zoomBefore = keys[before].camera.zoom;
    Camera camera = keys[before].camera; // with its projection
    camera.azimuthDegrees = curve([&](std::size_t n) { return angles[n].x; });
    camera.elevationDegrees = curve([&](std::size_t n) { return angles[n].y; });
    camera.rollDegrees = curve([&](std::size_t n) { return angles[n].z; });
    camera.panMm.x = curve([&](std::size_t n) { return keys[n].camera.panMm.x; });
    camera.panMm.y = curve([&](std::size_t n) { return keys[n].camera.panMm.y; });
    // Ratios to the key before, whose zoom is exact thereby.
    const auto logarithm = [&](std::size_t n) { return std::log(keys[n].camera.zoom / zoomBefore); };
    camera.zoom = zoomBefore * std::exp(curve(logarithm));
    return camera;
}

std::vector<Camera> flightFrames(const Flight& flight, double framesPerSecond) {
    checkFlight(flight);
    if (!(framesPerSecond > 0)) {
        throw Error("{} frames per second are no film; give more than 0", framesPerSecond);
    }
    const double duration = durationSeconds(flight);
    const double first = flight.keys.front().seconds;
    const long count = std::max(1L, std::lround(duration * framesPerSecond));
    // The last frame of a loop is a step before its end; any other shows the end.
    const double steps = double(flight.ends == Ends::Loop ? count : std::max(1L, count - 1));
    std::vector<Camera> cameras;
    for (long n = 0; n < count; ++n) {
        cameras.push_back(cameraAt(flight, first + duration * (double(n) / steps)));
    }
    return cameras;
}

Flight turntable(const Camera& camera, double degrees, double seconds) {
    Camera end = camera;
    end.azimuthDegrees += degrees;
    Flight flight = between(camera, end, seconds, {turnsBeside(degrees), 0, 0});
    flight.ends = isWholeTurns(degrees) ? Ends::Loop : Ends::Rest;
    return flight;
}

Flight tiltOver(const Camera& camera, double degrees, double seconds) {
    Camera end = camera;
    end.elevationDegrees += degrees;
    Flight flight = between(camera, end, seconds, {0, turnsBeside(degrees), 0});
    flight.ends = isWholeTurns(degrees) ? Ends::Loop : Ends::Rest;
    return flight;
}

Flight rocking(const Camera& camera, double degrees, double seconds) {
    VS_CHECK(seconds > 0);
    constexpr int keyCount = 16; // so many on a sine that the speed has no bumps between them
    // Key by key from the middle to one side: sines of equal angles are equal to the bit, so the swing is
    // even.
    constexpr std::array<int, keyCount + 1> quarters{0,  1,  2,  3,  4,  3,  2,  1, 0,
                                                     -1, -2, -3, -4, -3, -2, -1, 0};
    Flight flight{{}, Ends::Loop};
    for (int n = 0; n <= keyCount; ++n) {
        CameraKey key{seconds * n / keyCount, camera};
        key.camera.azimuthDegrees += degrees * std::sin(std::numbers::pi / 8 * quarters[std::size_t(n)]);
        flight.keys.push_back(key);
    }
    return flight;
}

Flight spiral(const Camera& camera, double degrees, double toElevationDegrees, double seconds) {
    Camera end = camera;
    end.azimuthDegrees += degrees;
    end.elevationDegrees = toElevationDegrees;
    return between(camera, end, seconds,
                   {turnsBeside(degrees), turnsBeside(toElevationDegrees - camera.elevationDegrees), 0});
}

Flight zoomIn(const Camera& camera, double factor, double seconds) {
    VS_CHECK(factor > 0);
    Camera end = camera;
    end.zoom *= factor;
    return between(camera, end, seconds);
}

} // namespace vs::render
