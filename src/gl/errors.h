// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/hazards.h"
#include "gl/sampler_slots.h"
#include "gl/staging.h"

#include <functional>
#include <memory>
#include <string_view>

// What is kept of contexts, and how driver errors are counted. Internal to this folder; others ask
// Context::errorCount().
namespace vs::gl {

// What is kept of one context. Errors: drivers report them as debug messages; some keep silent in a context
// that was not made for debugging, so what glGetError holds counts as well, where no message told of it. A
// hazard counts as an error too: on some device the result is another one.
struct ContextRecord {
    int messages = 0;                       // told by the driver
    int silent = 0;                         // found by glGetError alone
    int seen = 0;                           // messages when glGetError was last asked
    bool isLost = false;                    // the context: the driver tells that once
    std::unique_ptr<HazardChecker> hazards; // while they are watched
    Staging staging;
    SamplerSlots samplerSlots;

    [[nodiscard]] int total() const { return messages + silent + (hazards ? hazards->count() : 0); }
};

// The record of the context that this thread works with from now on; null for none.
void setCurrentRecord(ContextRecord* record);
[[nodiscard]] ContextRecord* currentRecord();

// One error message of the driver. The first few are logged.
void addErrorMessage(ContextRecord& record, std::string_view message);

// Counts what glGetError holds and leaves it empty.
void collectErrors();

// Makes an OpenGL call and tells whether it failed. For failures that are told by an exception: they neither
// count nor are logged besides.
[[nodiscard]] bool fails(const std::function<void()>& call);

} // namespace vs::gl
