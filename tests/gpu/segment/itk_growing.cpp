// SPDX-License-Identifier: Apache-2.0
#include "gpu/segment/itk_growing.h"

#include "base/timer.h"

#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>

#include <algorithm>

namespace vs::test {

std::vector<std::uint8_t> growWithItk(const volume::Volume& volume, const std::vector<glm::ivec3>& seeds,
                                      Range range, bool cornersTouch, double* milliseconds) {
    return volume::visit(volume, [&]<typename T>(const T* values) {
        using Input = itk::Image<T, 3>;
        using Output = itk::Image<std::uint8_t, 3>;
        typename Input::SizeType size;
        for (unsigned int axis = 0; axis < 3; ++axis) {
            size[axis] = itk::SizeValueType(volume.geometry.dims[int(axis)]);
        }
        auto image = Input::New();
        image->SetRegions(size);
        image->Allocate();
        const std::size_t count = volume.geometry.voxelCount();
        std::copy(values, values + count, image->GetBufferPointer());
        using Filter = itk::ConnectedThresholdImageFilter<Input, Output>;
        auto filter = Filter::New();
        filter->SetInput(image);
        filter->SetLower(T(range.lo));
        filter->SetUpper(T(range.hi));
        filter->SetReplaceValue(1);
        filter->SetConnectivity(cornersTouch ? Filter::FullConnectivity : Filter::FaceConnectivity);
        for (const glm::ivec3 seed : seeds) {
            filter->AddSeed({seed.x, seed.y, seed.z});
        }
        const Timer timer;
        filter->Update();
        if (milliseconds != nullptr) {
            *milliseconds = timer.milliseconds();
        }
        const std::uint8_t* labels = filter->GetOutput()->GetBufferPointer();
        return std::vector<std::uint8_t>(labels, labels + count);
    });
}

} // namespace vs::test
