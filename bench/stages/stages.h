// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace vs {

// A piece of work that is timed: what it does, and all that it needs besides, made beforehand.
struct BenchStage {
    std::string name;
    std::function<void()> run; // the device may still be busy when it returns
};

// Each needs a current context.
std::vector<BenchStage> countingStages();
std::vector<BenchStage> lookingStages();
std::vector<BenchStage> sculptingStages();

} // namespace vs
