// SPDX-License-Identifier: Apache-2.0
#include "gl/errors.h"

#include "base/log.h"

#include <epoxy/gl.h>

namespace vs::gl {

namespace {

constexpr int kLogged = 8; // what fails in one tile fails in all of them

thread_local ContextRecord* current = nullptr;
thread_local bool isExpected = false;

// The oldest error held, GL_NO_ERROR after the last. Bounded: a lost context may never run out of them.
template <typename F>
void takeErrors(F&& each) {
    GLenum error = glGetError();
    for (int n = 0; error != GL_NO_ERROR && n < 16; ++n) {
        each(error);
        error = glGetError();
    }
}

} // namespace

void setCurrentRecord(ContextRecord* record) { current = record; }
ContextRecord* currentRecord() { return current; }

void addErrorMessage(ContextRecord& record, std::string_view message) {
    if (isExpected) {
        return;
    }
    if (++record.messages <= kLogged) {
        logNotice(fmt::format("OpenGL: {}", message));
    }
}

void collectErrors() {
    takeErrors([](GLenum error) {
        if (current != nullptr && current->messages == current->seen && ++current->silent <= kLogged) {
            logNotice(fmt::format("OpenGL: error 0x{:04x}", error));
        }
    });
    if (current != nullptr) {
        current->seen = current->messages;
    }
}

bool fails(const std::function<void()>& call) {
    collectErrors();
    isExpected = true;
    call();
    bool failed = false;
    takeErrors([&failed](GLenum) { failed = true; });
    isExpected = false;
    return failed;
}

} // namespace vs::gl
