// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/played_case.h"

#include "base/embedded_text.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vs::cli {

// The files apps/cli/experiments/*.html (generated at build).
std::span<const EmbeddedText> embeddedPages();

// An experiment and all of its cases that were asked for.
struct PlayedExperiment {
    const studio::Experiment* which = nullptr;
    std::vector<PlayedCase> cases;
};

// One page of HTML that needs no network: the table of figures beside that of the thesis, section 6, and for
// each experiment its stages as pictures, which lie in the folders of their cases beside the page. Throws
// WriteError.
void writePage(const std::filesystem::path& file, const std::vector<PlayedExperiment>& experiments,
               const std::string& device);

// Writes the table alone, as comma-separated values.
void writeFigures(const std::filesystem::path& file, const std::vector<PlayedExperiment>& experiments);

} // namespace vs::cli
