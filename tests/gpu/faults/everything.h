// SPDX-License-Identifier: Apache-2.0
// A session on the test head in which every operation occurs.
#pragma once

#include "studio/operations/operation.h"

#include <filesystem>
#include <vector>

namespace vs::test {

// Files go into, and the label map is, where the document's output folder is said to be.
std::vector<studio::Operation> everything(const std::filesystem::path& labelMap);

// Pictures of the document as it is, in every mode and with all that can be shown: p0.png, p1.png ...
std::vector<studio::Operation> picturesOfAll();

} // namespace vs::test
