// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace vs::render {

// One file of data/transfer_functions, compiled into the program: its name without extension, and its text.
struct EmbeddedPreset {
    std::string_view name;
    std::string_view text;
};

// All presets, in alphabetical order (generated at build).
std::span<const EmbeddedPreset> embeddedPresets();

} // namespace vs::render
