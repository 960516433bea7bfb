// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

// Programs as the driver has compiled them (OpenGL 4.5, section 7.5), kept in files from one start to the
// next in the person's cache folder, by driver and by the shader's text: drivers that have no cache of their
// own, or none for this person, compile once, and the others need not read GLSL again.
namespace vs::gl {

// A program made of what was kept of a shader's text (with all that it includes); 0: nothing was kept, or the
// driver does not take it any more.
unsigned int loadKeptProgram(const std::string& text);

// Keeps a linked program of that text, if it can be: if not, it is compiled at the next start too.
void keepProgram(unsigned int program, const std::string& text);

} // namespace vs::gl
