// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"

#include <utility>

namespace vs {

namespace {
thread_local ProgressListener* current = nullptr;
}

ProgressListener::ProgressListener(Listen listen)
    : listen_(std::move(listen)), outer_(std::exchange(current, this)) {}

ProgressListener::~ProgressListener() { current = outer_; }

void reportProgress(std::optional<double> share) {
    if (current != nullptr && !current->listen_(share)) {
        throw GivenUp("it was given up");
    }
}

} // namespace vs
