// SPDX-License-Identifier: Apache-2.0
#include "growing_itk.h"

#include "base/timer.h"

#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>

#include <algorithm>

namespace vs {

PeerRun growWithItk(const GrowingCase& task) {
    return volume::visit(task.volume, [&]<typename T>(const T* values) {
        using Input = itk::Image<T, 3>;
        using Output = itk::Image<std::uint8_t, 3>;
        typename Input::SizeType size;
        for (unsigned int axis = 0; axis < 3; ++axis) {
            size[axis] = itk::SizeValueType(task.volume.geometry.dims[int(axis)]);
        }
        const std::size_t count = task.volume.geometry.voxelCount();
        auto image = Input::New();
        image->SetRegions(size);
        // ITK has no images of constant values; the filter only reads.
        image->GetPixelContainer()->SetImportPointer(const_cast<T*>(values), count, false);
        auto filter = itk::ConnectedThresholdImageFilter<Input, Output>::New();
        filter->SetInput(image);
        filter->SetLower(T(task.range.lo));
        filter->SetUpper(T(task.range.hi));
        filter->SetReplaceValue(1);
        for (const glm::ivec3 seed : task.seeds) {
            filter->AddSeed({seed.x, seed.y, seed.z});
        }
        const Timer timer;
        filter->Update();
        const double milliseconds = timer.milliseconds();
        const std::uint8_t* labels = filter->GetOutput()->GetBufferPointer();
        return PeerRun{milliseconds, std::uint64_t(std::count(labels, labels + count, std::uint8_t(1)))};
    });
}

} // namespace vs
