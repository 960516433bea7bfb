// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace vs {

// Threads that can run at once, at least one.
int processorCount();
// Threads for work that mostly waits for memory: more than a few only wait for one another.
int threadsForMemory();

// Calls work(i) once for each 0 <= i < count, in no particular order, on so many threads, the calling one
// among them. The calls must not depend on one another. Throws what one of them threw, after all have ended.
void inParallel(int count, int threads, const std::function<void(int)>& work);
// Does so on all processors.
void inParallel(int count, const std::function<void(int)>& work);

} // namespace vs
