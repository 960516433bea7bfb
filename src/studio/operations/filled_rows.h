// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace vs::studio {

// Rows of pixels or voxels that brushes fill piece after piece, and most of them where others were before:
// keeps a stretch of each row that is known to be full, so that it is not filled over and over.
class FilledRows {
public:
    FilledRows(std::size_t rows, int width) : full_(rows), width_(width) {}

    // Calls `fill(begin, end)` with what of [begin, end), inside the row, may not be full yet, and takes it
    // for full afterwards.
    template <typename Fill>
    void fill(std::size_t row, int begin, int end, const Fill& fill) {
        Stretch& full = full_[row];
        if (begin >= end || (begin >= full.begin && end <= full.end)) {
            return;
        }
        if (begin > full.end || end < full.begin) { // apart: the longer one is kept
            fill(begin, end);
            full = end - begin > full.end - full.begin ? Stretch{begin, end} : full;
            return;
        }
        if (begin < full.begin) {
            fill(begin, full.begin);
        }
        if (end > full.end) {
            fill(full.end, end);
        }
        full = {std::min(begin, full.begin), std::max(end, full.end)};
    }
    [[nodiscard]] bool isFull(std::size_t row) const {
        return full_[row].begin <= 0 && full_[row].end >= width_;
    }

private:
    struct Stretch {
        int begin = 0;
        int end = 0;
    };
    std::vector<Stretch> full_;
    int width_;
};

} // namespace vs::studio
