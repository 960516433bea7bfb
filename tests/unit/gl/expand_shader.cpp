// SPDX-License-Identifier: Apache-2.0
// Prints a shader as the program hands it to the driver: expand_shader PATH [NAME=VALUE ...]
#include "base/error.h"
#include "gl/shader_source.h"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc < 2) {
        return 2;
    }
    vs::gl::Defines defines;
    for (int i = 2; i < argc; ++i) {
        const std::string text = argv[i];
        const auto split = text.find('=');
        defines.emplace_back(text.substr(0, split), split == std::string::npos ? "" : text.substr(split + 1));
    }
    try {
        std::fputs(vs::gl::expandSource(argv[1], defines).text.c_str(), stdout);
    } catch (const vs::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
