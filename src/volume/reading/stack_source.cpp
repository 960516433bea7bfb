// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/stack_source.h"

#include "base/hash.h"
#include "base/progress.h"
#include "volume/io/formats.h"
#include "volume/reading/read_volume.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <span>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

// The decoder has the slices, shares them, and takes rows out of what is compressed.
constexpr std::uint64_t kCopies = 3;

bool isReadInSlices(const fs::path& path, const ReadOptions& options) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return !isStore(path) && isTiffFolder(path);
    }
    return fs::is_regular_file(path, error) && (options.raw || recognise(path) == Format::Tiff);
}

// Names, sizes and times of a file, or of those in a folder.
std::string contentOf(const fs::path& path) {
    Hash64 hash;
    const auto add = [&hash](const fs::path& file) {
        std::error_code error;
        const auto text = fmt::format("{} {} {};", file.filename().string(), fs::file_size(file, error),
                                      fs::last_write_time(file, error).time_since_epoch().count());
        hash.add(std::as_bytes(std::span(text)));
    };
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        add(path);
        return hash.text();
    }
    std::vector<fs::path> files;
    for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
        files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    std::for_each(files.begin(), files.end(), add);
    return hash.text();
}

// Some slices of a volume, kept until others are asked for.
class Slab {
public:
    Slab(fs::path path, ReadOptions options, int slices, int count)
        : path_(std::move(path)), options_(std::move(options)), slices_(slices), count_(count) {}

    // A box's values; it must lie within one slab.
    std::vector<std::byte> read(const Box3& box) {
        const std::scoped_lock lock(mutex_);
        const int first = box.lo.z / slices_ * slices_;
        if (first != first_) {
            load(first);
        }
        return valuesIn(held_, {box.lo - glm::ivec3(0, 0, first), box.hi - glm::ivec3(0, 0, first)});
    }

private:
    void load(int first) {
        const ProgressListener quiet([](std::optional<double>) { return true; }); // the whole is reported
        first_ = -1;
        held_ = {};
        options_.slices = {first, std::min(slices_, count_ - first)};
        held_ = readVolume(path_, options_).volume;
        first_ = first;
    }

    fs::path path_;
    ReadOptions options_;
    int slices_;
    int count_;
    std::mutex mutex_;
    int first_ = -1;
    Volume held_;
};

} // namespace

std::optional<StoreSource> stackSource(const fs::path& path, const ReadOptions& options, int chunk,
                                       std::uint64_t memoryBytes, std::vector<std::string>& notices) {
    if (!isReadInSlices(path, options)) {
        return {};
    }
    ReadOptions one = options;
    one.slices = {0, 1};
    const auto read = readVolume(path, one);
    notices = read.notices;
    const Volume& first = read.volume;
    const std::uint64_t slabBytes = kCopies * std::uint64_t(chunk) * first.bytes.size();
    if (slabBytes > memoryBytes) {
        throw UsageError(
            "{}: {} slices at once take some {} MiB, and {} are allowed; give --memory more, or --chunk "
            "less",
            path.string(), chunk, slabBytes >> 20, memoryBytes >> 20);
    }
    StoreSource source;
    source.facts = {first.geometry, first.unit, first.name};
    source.facts.geometry.dims.z = first.details.slices;
    source.type = first.type;
    const glm::ivec3 dims = source.facts.geometry.dims;
    std::error_code error;
    source.identity =
        fmt::format("{} of {} x {} x {} {}, channel {}, frame {}, {}",
                    fs::weakly_canonical(path, error).string(), dims.x, dims.y, dims.z, name(source.type),
                    options.channel.value_or(0), options.frame.value_or(0), contentOf(path));
    const auto slab = std::make_shared<Slab>(path, options, chunk, dims.z);
    source.read = [slab](const Box3& box) { return slab->read(box); };
    return source;
}

} // namespace vs::volume
