// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <functional>
#include <optional>

// How long computations tell whoever waits for them how far they are, and stop when nobody wants them any
// more. For those that take more than about half a second on a large volume.
namespace vs {

// Thrown by reportProgress() when the person has given up.
class GivenUp : public Error {
public:
    using Error::Error;
};

// While it lives, what this thread reports goes to `listen`, which gets the share that is done (0 to 1, if
// that is known) and returns false to give up. The listener before it comes back afterwards.
class ProgressListener {
public:
    using Listen = std::function<bool(std::optional<double> share)>;

    explicit ProgressListener(Listen listen);
    ~ProgressListener();
    ProgressListener(const ProgressListener&) = delete;
    ProgressListener& operator=(const ProgressListener&) = delete;

private:
    Listen listen_;
    ProgressListener* outer_;

    friend void reportProgress(std::optional<double> share);
};

// Tells the listener, if there is one, what share is done; nothing: it cannot be said. To be called where
// stopping leaves everything as it was, or where whoever calls restores it. Throws GivenUp.
void reportProgress(std::optional<double> share = {});

} // namespace vs
