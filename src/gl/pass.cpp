// SPDX-License-Identifier: Apache-2.0
#include "gl/pass.h"

#include <epoxy/gl.h>

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

} // namespace

Pass::Pass(const char* name) : name_(name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    if (timing().enabled) {
        glFinish();
        timer_ = Timer();
    }
}

Pass::~Pass() {
    if (timing().enabled) {
        glFinish();
        PassTimes& entry = timing().times[name_];
        entry.milliseconds += timer_.milliseconds();
        ++entry.count;
    }
    glPopDebugGroup();
}

void Pass::enableTiming(bool enabled) { timing().enabled = enabled; }
const std::map<std::string, PassTimes>& Pass::times() { return timing().times; }
void Pass::resetTimes() { timing().times.clear(); }

} // namespace vs::gl
