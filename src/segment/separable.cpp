// SPDX-License-Identifier: Apache-2.0
#include "segment/separable.h"

#include <itkMultiThreaderBase.h>

namespace vs::segment {

void inParallel(int count, const std::function<void(int)>& f) {
    itk::MultiThreaderBase::New()->ParallelizeArray(
        0, itk::SizeValueType(count), [&](itk::SizeValueType i) { f(int(i)); }, nullptr);
}

} // namespace vs::segment
