// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/context.h"
#include "studio/selfcheck/tally.h"

#include <functional>
#include <span>
#include <string>

namespace vs::studio {

// One stage of the program's work on the device and how it is checked: the same small input is given to the
// device and to a closed form, or to a short loop on the CPU.
struct StageCheck {
    const char* name;
    void (*run)(Tally& tally);
};

// All stages, in the order in which one builds on another.
std::span<const StageCheck> stageChecks();

// What the check of a stage has found.
struct StageResult {
    std::string name;
    Tally tally;
    std::string failure; // why the stage could not be run to its end; empty if it was
    int errors = 0;      // that OpenGL reported meanwhile
    double milliseconds = 0;

    [[nodiscard]] bool isOk() const {
        return failure.empty() && errors == 0 && tally.wrong() == 0 && tally.values() > 0;
    }
};

// Checks a stage on the current context's device. What the stage throws becomes its failure, in which no path
// is left.
StageResult runCheck(const StageCheck& check, const gl::Context& context);

// A message of one line without paths: those from a root are only said to be paths, and of others the name
// at their end is left, up to its first dot, as "cast_rays:12" of "render/shaders/cast_rays.comp:12".
std::string withoutPaths(const std::string& message);

} // namespace vs::studio
