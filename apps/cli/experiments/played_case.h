// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/case_figures.h"
#include "studio/cases/cases.h"

#include "gl/context.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// A case that was played into a folder of pictures, or why it was not.
struct PlayedCase {
    struct Stage {
        std::string text;                  // of the step
        std::vector<std::string> pictures; // names in the case's folder
    };

    const studio::Case* which = nullptr;
    const studio::CaseScan* scan = nullptr; // null: it is made
    bool isMissing = false;                 // the scan is not there
    std::string error;                      // empty: it went well
    std::string volume;                     // what it was played on
    std::vector<Stage> stages;
    CaseFigures figures;

    [[nodiscard]] bool isDone() const { return !isMissing && error.empty(); }
    [[nodiscard]] std::size_t pictureCount() const;
};

struct PlayOptions {
    std::filesystem::path output;            // a case's pictures lie in a folder of its name there
    std::vector<std::filesystem::path> data; // folders with scans
    std::optional<int> width;                // of pictures, in pixels, instead of their own
};

// Plays it, measuring. What goes wrong is told by the result.
PlayedCase playCase(const studio::Case& which, const PlayOptions& options, const gl::Context& context);

} // namespace vs::cli
