// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

// How driver errors are counted. Internal to this folder; others ask Context::errorCount().
namespace vs::gl {

// Errors of one context. Drivers report them as debug messages; some keep silent in a context that was not
// made for debugging, so what glGetError holds counts as well, where no message told of it.
struct ErrorCount {
    int messages = 0; // told by the driver
    int silent = 0;   // found by glGetError alone
    int seen = 0;     // messages when glGetError was last asked

    [[nodiscard]] int total() const { return messages + silent; }
};

// Counts for the context that this thread works with from now on; null for none.
void countErrorsIn(ErrorCount* count);
[[nodiscard]] ErrorCount* errorsCounted();

// One error message of the driver. The first few are logged.
void addErrorMessage(ErrorCount& count, std::string_view message);

// Counts what glGetError holds and leaves it empty.
void collectErrors();

// For a call whose failure is told by an exception, and must not count or be logged besides: made before the
// call, asked after it.
class ExpectedFailure {
public:
    ExpectedFailure();
    ~ExpectedFailure();
    ExpectedFailure(const ExpectedFailure&) = delete;
    ExpectedFailure& operator=(const ExpectedFailure&) = delete;

    // Whether there has been an error since.
    [[nodiscard]] static bool happened();
};

} // namespace vs::gl
