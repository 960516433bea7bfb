// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_reload.h"

#include "base/log.h"

#include <atomic>
#include <mutex>
#include <utility>

namespace vs::gl {

namespace {

std::atomic<int> generation = 0;

// Programs are used on the thread that has their context, which may be another one than that which asks.
std::mutex faultMutex;
std::optional<std::string> firstFault;

} // namespace

void reloadShaders() { ++generation; }

int shaderGeneration() { return generation.load(std::memory_order_relaxed); }

void tellShaderFault(const std::string& fault) {
    logNotice(fault);
    const std::lock_guard lock(faultMutex);
    if (!firstFault) {
        firstFault = fault;
    }
}

std::optional<std::string> takeShaderFault() {
    const std::lock_guard lock(faultMutex);
    return std::exchange(firstFault, std::nullopt);
}

} // namespace vs::gl
