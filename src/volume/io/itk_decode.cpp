// SPDX-License-Identifier: Apache-2.0
#include "volume/io/itk_decode.h"

#include "base/log.h"

#include <fmt/format.h>
#include <gdcmTrace.h>
#include <itkObject.h>

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

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

// Returns whether rounding changed any value that is not scaled anyway.
template <typename From>
bool toFloat(const std::vector<std::byte>& from, std::vector<std::byte>& to, const Scaling& scaling) {
    const std::size_t count = from.size() / sizeof(From);
    to.resize(count * sizeof(float));
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
        From value;
        std::memcpy(&value, from.data() + i * sizeof(From), sizeof(From));
        if (scaling.changes()) {
            const float scaled = scaling.of(double(value));
            std::memcpy(to.data() + i * sizeof(float), &scaled, sizeof(float));
            continue;
        }
        const float narrow = static_cast<float>(value);
        // Long double holds every 64-bit integer, so the comparison is exact for all types.
        changed = changed ||
                  (static_cast<long double>(narrow) != static_cast<long double>(value) && value == value);
        std::memcpy(to.data() + i * sizeof(float), &narrow, sizeof(float));
    }
    return changed;
}

void rescale(Volume& volume, const Scaling& scaling) {
    const std::size_t count = volume.bytes.size() / sizeOf(volume.type);
    std::vector<std::byte> scaled(count * sizeof(float));
    visit(volume, [&](const auto* values) {
        auto* out = reinterpret_cast<float*>(scaled.data());
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = scaling.of(double(values[i]));
        }
    });
    volume.type = ScalarType::Float32;
    volume.bytes = std::move(scaled);
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

bool takeValues(Volume& volume, StoredType type, std::vector<std::byte>&& bytes, const Scaling& scaling) {
    const auto keep = [&](ScalarType kept) {
        volume.type = kept;
        volume.bytes = std::move(bytes);
        if (scaling.changes()) {
            rescale(volume, scaling);
        }
        return false;
    };
    const auto convert = [&](auto example) {
        volume.type = ScalarType::Float32;
        return toFloat<decltype(example)>(bytes, volume.bytes, scaling);
    };
    switch (type) {
    case StoredType::UInt8:
        return keep(ScalarType::UInt8);
    case StoredType::Int8:
        return keep(ScalarType::Int8);
    case StoredType::UInt16:
        return keep(ScalarType::UInt16);
    case StoredType::Int16:
        return keep(ScalarType::Int16);
    case StoredType::UInt32:
        return keep(ScalarType::UInt32);
    case StoredType::Int32:
        return keep(ScalarType::Int32);
    case StoredType::Float32:
        return keep(ScalarType::Float32);
    case StoredType::UInt64:
        return convert(std::uint64_t(0));
    case StoredType::Int64:
        return convert(std::int64_t(0));
    case StoredType::Float64:
        break;
    }
    return convert(0.0);
}

void takeFrame(const std::filesystem::path& path, Inspection& inspection, int frame, ReadResult& result,
               const Scaling& scaling) {
    const std::uint64_t frames = inspection.sizes.size() > 3 ? std::uint64_t(inspection.sizes[3]) : 1;
    const std::uint64_t count = inspection.block.count / frames;
    auto values = readValues(inspection.block, count * std::uint64_t(frame), count);
    if (takeValues(result.volume, inspection.block.type, std::move(values), scaling)) {
        result.notices.push_back(
            fmt::format("{}: 64-bit values were rounded to 32-bit floats; some changed", path.string()));
    }
    result.volume.details.frame = frame;
    result.volume.details.frames = int(frames);
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
