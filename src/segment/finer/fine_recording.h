// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_growth.h"

#include <exception>

namespace vs::segment {

// Has a growth note in a record what it changes, while this lives. When the call throws, all of that is taken
// back, and the record is empty.
class FineGrowth::Recording {
public:
    Recording(FineUndo* undo, FineGrowth& growth)
        : growth_(growth), isOutermost_(growth.recording_ == nullptr),
          exceptions_(std::uncaught_exceptions()), noted_(undo != nullptr ? undo : &own_) {
        if (isOutermost_) {
            *noted_ = {growth_.label_, growth_.run_, {}};
            growth_.recording_ = noted_;
        }
    }
    ~Recording() {
        if (isOutermost_) {
            growth_.recording_ = nullptr;
            if (std::uncaught_exceptions() > exceptions_) {
                growth_.takeBack(*noted_);
                *noted_ = {};
            }
        }
    }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

private:
    FineGrowth& growth_;
    bool isOutermost_;
    int exceptions_;
    FineUndo own_;
    FineUndo* noted_;
};

} // namespace vs::segment
