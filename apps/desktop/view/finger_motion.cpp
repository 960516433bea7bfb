// SPDX-License-Identifier: Apache-2.0
#include "view/finger_motion.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kLeastApart = 1; // pixels: nearer, neither distance nor angle means anything
} // namespace

FingerMotion FingerTracker::follow(const QList<QEventPoint>& points) {
    std::vector<Finger> now;
    for (const QEventPoint& point : points) {
        if (point.state() != QEventPoint::State::Released && now.size() < 2) {
            now.push_back({point.id(), point.position()});
        }
    }
    const std::vector<Finger> before = std::exchange(before_, now);
    const bool areSame = std::equal(before.begin(), before.end(), now.begin(), now.end(),
                                    [](const Finger& a, const Finger& b) { return a.id == b.id; });
    if (!areSame || now.empty()) {
        return {};
    }
    if (now.size() == 1) {
        return {1, before[0].place, now[0].place - before[0].place};
    }
    const QLineF was(before[0].place, before[1].place);
    const QLineF is(now[0].place, now[1].place);
    FingerMotion motion{2, was.center(), is.center() - was.center()};
    if (was.length() >= kLeastApart && is.length() >= kLeastApart) {
        motion.scale = is.length() / was.length();
        motion.degrees = std::remainder(was.angle() - is.angle(), 360.0); // Qt's run anticlockwise
    }
    return motion;
}

} // namespace vs::desktop
