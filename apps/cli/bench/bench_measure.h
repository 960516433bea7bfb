// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/pass.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vs::cli {

// What a piece of work took.
struct Measurement {
    std::string kind; // "data", "mode" or "edit"
    std::string name;
    std::vector<double> milliseconds; // wall clock of each run, until the device has finished
    // What each pass takes in one run, by the names of gl::Pass: medians over runs of their own, since timing
    // passes slows them down.
    std::map<std::string, gl::PassTimes> passes;

    [[nodiscard]] double medianMilliseconds() const;
    [[nodiscard]] double deviceMilliseconds() const; // all passes
};

// A piece of work that is run again and again, counted from 0. What must happen before a run but is not part
// of it is in `prepare`.
struct Work {
    std::function<void(int run)> run;
    std::function<void(int run)> prepare = {};
    bool usesDevice = true; // false: has no passes
};

// One run that does not count (programs are compiled, caches filled), then `runs` for the wall clock, then
// some for the passes. Needs a current context.
Measurement measure(const std::string& kind, const std::string& name, int runs, const Work& work);

} // namespace vs::cli
