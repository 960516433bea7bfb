// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"

#include <itkImageIOBase.h>

#include <cmath>
#include <limits>
#include <optional>

// Bridges to ITK's image readers. Internal to this folder; ITK's headers stay out of the public ones.
namespace vs::volume {

// Sends what the decoding libraries print to nowhere while it lives: their causes reach the caller as
// exceptions, and standard error must hold our one line. Nothing is hidden when VOLUME_STUDIO_LOG=debug is
// set.
class QuietLibraries {
public:
    QuietLibraries();
    ~QuietLibraries();
    QuietLibraries(const QuietLibraries&) = delete;
    QuietLibraries& operator=(const QuietLibraries&) = delete;

private:
    int savedError_ = -1;
    int savedOutput_ = -1;
};

// What stored values stand for: slope * value + intercept. Factors that change nothing leave types alone.
struct Scaling {
    double slope = 1;
    double intercept = 0;

    [[nodiscard]] bool changes() const {
        constexpr double nothing = std::numeric_limits<float>::epsilon();
        return std::abs(slope - 1) > nothing || std::abs(intercept) > nothing;
    }
    [[nodiscard]] float of(double stored) const { return static_cast<float>(slope * stored + intercept); }
};

// Sets volume.type and volume.bytes from values in this machine's byte order; 64-bit values and scaled ones
// become Float32. Returns whether that changed one that is not scaled.
bool takeValues(Volume& volume, StoredType type, std::vector<std::byte>&& bytes, const Scaling& scaling = {});

// Sets the values of one frame of a file that was inspected, with a notice where 64-bit ones were rounded.
// They are read here and by no library: those turn NaN into 0, stop at the first number that they do not
// like, take compressed sizes on trust.
void takeFrame(const std::filesystem::path& path, Inspection& inspection, int frame, ReadResult& result,
               const Scaling& scaling = {});

// The grid of the first three axes, after ReadImageInformation.
GridGeometry geometryOf(const itk::ImageIOBase& io);

// Reads the file with the given reader, which tells where the volume lies, after its header was inspected.
// `frame` picks a volume of a 4D file.
ReadResult readPlacedByItk(itk::ImageIOBase& io, const std::filesystem::path& path, Inspection&& inspection,
                           std::optional<int> frame);

// The first line of an exception's text without the place in ITK's sources.
std::string shortReason(const std::exception& error);

} // namespace vs::volume
