// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vs::cli {

// Texts of the command line as values. Each throws UsageError naming the text and what would be right.
Range parseRange(const std::string& text, const std::string& what = "range"); // "LO:HI", LO not above HI
glm::ivec2 parseSize(const std::string& text);                                // "WIDTHxHEIGHT", each 1..16384
// `count` numbers separated by `separator`; `what` begins the complaint, `example` ends it.
std::vector<double> parseNumbers(const std::string& text, char separator, std::size_t count,
                                 const std::string& what, const std::string& example);

// For options that are numbers: like CLI::Range, but "nan" is not within any bounds.
CLI::Validator between(double lo, double hi);

// Names of files to write, checked before the work is done. Each throws UsageError.
void checkPictureName(const std::filesystem::path& path); // .png
void checkGridName(const std::filesystem::path& path);    // what volume::writeGrid knows

} // namespace vs::cli
