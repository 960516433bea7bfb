// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QEventPoint>
#include <QPointF>

#include <map>
#include <vector>

namespace vs::desktop {

// What fingers did between two reports, in logical pixels of the widget: what was under `from` is to be under
// `from + moved`, larger by `scale` and turned clockwise by `degrees` about there.
struct FingerMotion {
    int fingers = 0; // 1, or 2 for two and more, of which the first two count
    QPointF from;
    QPointF moved;
    double scale = 1;
    double degrees = 0;
};

// The motion of one or two fingers by plain geometry: their middle, their distance, the angle of the line
// through them. A finger that comes or goes begins anew, so that nothing jumps.
class FingerTracker {
public:
    // No fingers in the result: nothing moved yet, or another number of fingers than before.
    FingerMotion follow(const QList<QEventPoint>& points);
    void forget() { before_.clear(); }

private:
    struct Finger {
        int id = 0;
        QPointF place;
    };
    std::vector<Finger> before_;
};

} // namespace vs::desktop
