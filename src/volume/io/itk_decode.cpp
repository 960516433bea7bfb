// SPDX-License-Identifier: Apache-2.0
#include "volume/io/itk_decode.h"

#include "base/log.h"
#include "volume/io/take_values.h"

#include <fmt/format.h>
#include <gdcmTrace.h>
#include <itkObject.h>

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace vs::volume {
namespace {

int redirect(int descriptor) {
    const int saved = dup(descriptor);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (saved >= 0 && nowhere >= 0) {
        dup2(nowhere, descriptor);
    }
    if (nowhere >= 0) {
        close(nowhere);
    }
    return saved;
}

void restore(int saved, int descriptor) {
    if (saved >= 0) {
        dup2(saved, descriptor);
        close(saved);
    }
}

} // namespace

GridGeometry geometryOf(const itk::ImageIOBase& io) {
    GridGeometry geometry;
    for (unsigned axis = 0; axis < 3; ++axis) {
        geometry.dims[int(axis)] = int(io.GetDimensions(axis));
        const auto direction = io.GetDirection(axis);
        for (unsigned row = 0; row < 3; ++row) {
            geometry.worldFromVoxel[int(axis)][int(row)] = direction[row] * io.GetSpacing(axis);
        }
        geometry.worldFromVoxel[3][int(axis)] = io.GetOrigin(axis);
    }
    return geometry;
}

QuietLibraries::QuietLibraries() {
    itk::Object::GlobalWarningDisplayOff();
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    if (!isLogged(LogLevel::Debug)) {
        std::fflush(stdout);
        savedError_ = redirect(STDERR_FILENO);
        savedOutput_ = redirect(STDOUT_FILENO);
    }
}

QuietLibraries::~QuietLibraries() {
    if (savedOutput_ >= 0) {
        std::fflush(stdout);
    }
    restore(savedError_, STDERR_FILENO);
    restore(savedOutput_, STDOUT_FILENO);
}

std::string shortReason(const std::exception& error) {
    std::string text = error.what();
    if (const auto* itkError = dynamic_cast<const itk::ExceptionObject*>(&error)) {
        text = itkError->GetDescription();
    }
    if (const auto colon = text.find("): "); text.starts_with("ITK ERROR: ") && colon != std::string::npos) {
        text = text.substr(colon + 3);
    }
    text = trimmed(text);
    for (char& c : text) {
        c = c == '\n' ? ' ' : c;
    }
    return printable(text);
}

ReadResult readPlacedByItk(itk::ImageIOBase& io, const std::filesystem::path& path, Inspection&& inspection,
                           std::optional<int> frame) {
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int picked = chosenFrame(path, frames, frame);
    ReadResult result;
    result.notices = inspection.notices;
    try {
        const QuietLibraries quiet;
        io.SetFileName(path.string());
        io.ReadImageInformation();
        // What ITK has understood must be what was inspected.
        bool isSame = io.GetNumberOfDimensions() >= 3;
        for (unsigned axis = 0; axis < 3; ++axis) {
            isSame = isSame && io.GetDimensions(axis) == std::uint64_t(inspection.sizes[axis]);
        }
        if (!isSame) {
            throw std::runtime_error("the header is ambiguous");
        }
        result.volume.geometry = geometryOf(io);
        takeFrame(path, inspection, picked, result);
    } catch (const std::bad_alloc&) {
        refuse(path, "it does not fit into memory", "crop it or use a machine with more");
    } catch (const std::exception& error) {
        refuse(path, fmt::format("it cannot be read ({})", shortReason(error)),
               "check the header and the data");
    }
    return result;
}

} // namespace vs::volume
