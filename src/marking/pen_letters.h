// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vs::marking {

using PenLines = std::vector<std::vector<glm::dvec2>>;

// What a marking pen writes: lines of letters whose capitals are 1 high, y down, centred on the origin. It
// writes capitals, digits and a few signs (A-Z, umlauts, 0-9, + - x = / . , : ? ! * < > ( ) and the sign of
// degrees); small letters become capitals. The same on every computer, whatever fonts it has.
PenLines penLetters(const std::string& utf8);

// The first character of a text that a pen cannot write; empty: it can write all.
std::string unwritable(const std::string& utf8);

} // namespace vs::marking
