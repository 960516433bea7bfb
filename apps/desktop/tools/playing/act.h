// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

#include "studio/operations/operation.h"

#include <memory>
#include <optional>

namespace vs::desktop {

class StudioController;

// An operation of a session while it is done before one's eyes: a stroke is drawn and then cuts, a region
// grows, the camera flies. What it leaves in the document is what the operation says.
class Act {
public:
    enum class State { GoesOn, Done, Failed };

    virtual ~Act() = default;
    Act(const Act&) = delete;
    Act& operator=(const Act&) = delete;

    // Does what is due so many seconds after it began.
    virtual State advance(double seconds) = 0;
    // Does all that is left at once. Failed: the message says why.
    virtual State complete() = 0;
    // Ends where it is, with nothing left open; gives what remains to be done, if anything does.
    virtual std::optional<studio::Operation> stopHere() = 0;
    // What is painted over the picture meanwhile.
    [[nodiscard]] virtual Overlays overlays() const { return {}; }

protected:
    explicit Act(StudioController& studio) : studio_(studio) {}

    StudioController& studio_;
};

// The act that suits an operation.
std::unique_ptr<Act> actFor(const studio::Operation& operation, StudioController& studio);

} // namespace vs::desktop
