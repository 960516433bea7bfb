// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/context.h"
#include "studio/cases/case_index.h"
#include "studio/document/document.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// What was measured while a case was played: its row of the table beside that of the thesis, section 6. What
// a case does not do is not set.
struct CaseFigures {
    glm::ivec3 dims{0};
    double loadSeconds = 0; // reading the file (a phantom: not its making), upload, all histograms
    double mip = 0;         // pictures a second of the window's size, one ray a pixel
    double xray = 0;
    double surface = 0;
    std::optional<double> drill; // updates a second: each a place of the pen, and a surface picture
    std::optional<double> laser;
    std::optional<double> peel;                       // updates a second: each a layer
    std::optional<double> paste;                      // pictures a second with what was pasted or pulled out
    std::optional<double> voxelsPerSecond;            // growth
    std::vector<std::pair<std::string, double>> dice; // of segments, with what is true
    double seconds = 0;                               // the whole case, without these measurements
};

// Gathers them while a case is played.
class FigureTaker {
public:
    // Counts all histograms that are part of loading in the thesis, section 6: intensity (the document has
    // it), gradient magnitude, and both.
    static void countAll(const studio::Document& document);
    // Times pictures of each mode in the document's view as it is now, which stays.
    void timeModes(studio::Document& document);
    // Takes note of what an operation took.
    void add(const studio::Operation& operation, const studio::Outcome& outcome);
    // At the end: pictures with parts, if there are any, and all rates.
    void finish(studio::Document& document);

    CaseFigures figures;

private:
    struct Tally {
        double milliseconds = 0;
        double amount = 0; // updates, or voxels
    };
    [[nodiscard]] std::optional<double> updatesPerSecond(const Tally& tool) const;

    Tally drill_;
    Tally laser_;
    Tally peel_;
    Tally growth_;
};

// How well the segments of a document cover what is true: labels as a file or a phantom has them, one a
// voxel. Throws Error for a segment that there is not.
std::vector<std::pair<std::string, double>> diceOf(const studio::Document& document,
                                                   const std::vector<studio::TrueLabels>& wanted,
                                                   const std::vector<std::int64_t>& truth);

} // namespace vs::cli
