// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vs::gl {

using Defines = std::vector<std::pair<std::string, std::string>>;

// The definitions of the switches that are on, each as 1.
Defines switchesOn(std::initializer_list<std::pair<const char*, bool>> switches);

// A shader text after #include expansion. `files[n]` is the file whose lines carry source number n in #line,
// so a driver's "2(17)" can be turned back into a file and line.
struct ExpandedSource {
    std::string text;
    std::vector<std::string> files;
};

// Finds a shader text by its path below src/; nothing if there is none.
using SourceLookup = std::function<std::optional<std::string>(const std::string& path)>;

// The embedded shaders, or the files below $VOLUME_STUDIO_SHADER_DIR when that is set (development).
std::optional<std::string> findShader(const std::string& path);

// Expands `#include "path"` lines (each file once), puts `#version 450 core` and the defines on top. Pure
// text work. Throws GlError naming the including file and line when a file is missing.
ExpandedSource expandSource(const std::string& path, const Defines& defines,
                            const SourceLookup& lookup = findShader);

// The names of the uniforms that a shader text declares outside of blocks, in order; one to a declaration.
// What stands in comments does not count.
std::vector<std::string> declaredUniforms(std::string_view source);

// Replaces the source numbers in a driver's log by file names.
std::string readableLog(const std::string& log, const ExpandedSource& source);

} // namespace vs::gl
