// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/separable.h"

#include <itkMultiThreaderBase.h>

#include <exception>
#include <mutex>

namespace vs::segment {

void inParallel(int count, const std::function<void(int)>& f) {
    // ITK 5.2 loses what is thrown on its threads.
    std::mutex mutex;
    std::exception_ptr failure;
    const auto guarded = [&](itk::SizeValueType i) {
        try {
            f(int(i));
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
    };
    itk::MultiThreaderBase::New()->ParallelizeArray(0, itk::SizeValueType(count), guarded, nullptr);
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace vs::segment
