// SPDX-License-Identifier: Apache-2.0
#include "gpu/segment/itk_growing.h"

#include "base/timer.h"

#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>
#include <itkNeighborhoodConnectedImageFilter.h>

#include <algorithm>

namespace vs::test {
namespace {

using Labels = itk::Image<std::uint8_t, 3>;

template <typename T>
typename itk::Image<T, 3>::Pointer imageOf(const volume::Volume& volume, const T* values) {
    typename itk::Image<T, 3>::SizeType size;
    for (unsigned int axis = 0; axis < 3; ++axis) {
        size[axis] = itk::SizeValueType(volume.geometry.dims[int(axis)]);
    }
    auto image = itk::Image<T, 3>::New();
    image->SetRegions(size);
    image->Allocate();
    std::copy(values, values + volume.geometry.voxelCount(), image->GetBufferPointer());
    return image;
}

// What both filters are told alike.
template <typename Filter>
void begin(Filter& filter, const std::vector<glm::ivec3>& seeds, Range range) {
    using T = typename Filter::InputImagePixelType;
    filter.SetLower(T(range.lo));
    filter.SetUpper(T(range.hi));
    filter.SetReplaceValue(1);
    for (const glm::ivec3 seed : seeds) {
        filter.AddSeed({seed.x, seed.y, seed.z});
    }
}

std::vector<std::uint8_t> valuesOf(const Labels& labels) {
    const std::uint8_t* values = labels.GetBufferPointer();
    return {values, values + labels.GetBufferedRegion().GetNumberOfPixels()};
}

} // namespace

std::vector<std::uint8_t> growWithItk(const volume::Volume& volume, const std::vector<glm::ivec3>& seeds,
                                      Range range, bool cornersTouch, double* milliseconds) {
    return volume::visit(volume, [&]<typename T>(const T* values) {
        using Filter = itk::ConnectedThresholdImageFilter<itk::Image<T, 3>, Labels>;
        auto filter = Filter::New();
        filter->SetInput(imageOf(volume, values));
        begin(*filter, seeds, range);
        filter->SetConnectivity(cornersTouch ? Filter::FullConnectivity : Filter::FaceConnectivity);
        const Timer timer;
        filter->Update();
        if (milliseconds != nullptr) {
            *milliseconds = timer.milliseconds();
        }
        return valuesOf(*filter->GetOutput());
    });
}

std::vector<std::uint8_t> growNeighbourhoodsWithItk(const volume::Volume& volume,
                                                    const std::vector<glm::ivec3>& seeds, Range range,
                                                    int radius) {
    return volume::visit(volume, [&]<typename T>(const T* values) {
        using Filter = itk::NeighborhoodConnectedImageFilter<itk::Image<T, 3>, Labels>;
        auto filter = Filter::New();
        filter->SetInput(imageOf(volume, values));
        begin(*filter, seeds, range);
        typename Filter::InputImageSizeType size;
        size.Fill(itk::SizeValueType(radius));
        filter->SetRadius(size);
        filter->Update();
        return valuesOf(*filter->GetOutput());
    });
}

} // namespace vs::test
