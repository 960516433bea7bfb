// SPDX-License-Identifier: Apache-2.0
#include "gl/pass.h"

#include <epoxy/gl.h>

#include <utility>

namespace vs::gl {

namespace {

struct Timing {
    bool enabled = false;
    std::map<std::string, PassTimes> times;
};

Timing& timing() {
    static thread_local Timing table;
    return table;
}

thread_local Pass* innermost = nullptr;

// Nanoseconds, once the device has come there.
GLint64 stampOf(unsigned query) {
    GLint64 nanoseconds = 0;
    glGetQueryObjecti64v(query, GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds;
}

} // namespace

Pass::Pass(const char* name) : name_(name), outer_(std::exchange(innermost, this)) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    if (timing().enabled) {
        glFinish();
        glCreateQueries(GL_TIMESTAMP, int(stamps_.size()), stamps_.data());
        glQueryCounter(stamps_[0], GL_TIMESTAMP);
        timer_ = Timer();
    }
}

Pass::~Pass() {
    if (stamps_[0] != 0) {
        glQueryCounter(stamps_[1], GL_TIMESTAMP);
        glFinish();
        PassTimes& entry = timing().times[name_];
        entry.milliseconds += timer_.milliseconds();
        entry.deviceMilliseconds += 1e-6 * double(stampOf(stamps_[1]) - stampOf(stamps_[0]));
        ++entry.count;
        glDeleteQueries(int(stamps_.size()), stamps_.data());
    }
    glPopDebugGroup();
    innermost = outer_;
}

std::string Pass::openNames() {
    std::string names;
    for (const Pass* pass = innermost; pass != nullptr; pass = pass->outer_) {
        names.insert(0, names.empty() ? "" : ": ").insert(0, pass->name_);
    }
    return names;
}

void Pass::enableTiming(bool enabled) { timing().enabled = enabled; }
const std::map<std::string, PassTimes>& Pass::times() { return timing().times; }
void Pass::resetTimes() { timing().times.clear(); }

} // namespace vs::gl
