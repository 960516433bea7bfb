// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/store_bricks.h"

#include "base/progress.h"
#include "volume/io/formats.h"
#include "volume/io/inspect.h"
#include "volume/reading/decoder_process.h"
#include "volume/reading/read_volume.h"
#include "volume/reading/web_store.h"
#include "volume/store/store_progress.h"

#include <algorithm>
#include <utility>

namespace vs::volume {

bool hasLevels(const std::filesystem::path& path) { return isWebAddress(path) || isStore(path); }

namespace {

// Whether a number is that of cells, of which a decoder may say what it likes.
bool isProduct(std::uint64_t number, glm::ivec3 cells) {
    const auto perSlice = std::uint64_t(cells.x) * std::uint64_t(cells.y); // below 2^62
    return number % perSlice == 0 && number / perSlice == std::uint64_t(cells.z);
}

} // namespace

StoreBricks::StoreBricks(std::filesystem::path path, const ReadOptions& options)
    : path_(std::move(path)), folder_(path_), options_(options) {
    if (isWebAddress(path_)) {
        web_ = std::make_unique<WebStore>(path_.string(), ".zattrs");
        folder_ = web_->folder();
        DecoderProcess decoder{DescriptionRequest{folder_}};
        auto names = decoder.finalAnswer<FileNames>(path_).names;
        names.emplace_back(kUnfinishedStore);
        web_->fetch(names);
    }
    OpenedLevels levels;
    giveBack(start(levels));
    grids_ = levels.grids;
    type_ = levels.type;
}

StoreBricks::~StoreBricks() = default;

StoreBricks::Decoder StoreBricks::start(OpenedLevels& levels) const {
    auto decoder = std::make_unique<DecoderProcess>(LevelsRequest{folder_, options_});
    levels = decoder->finalAnswer<OpenedLevels>(path_);
    return decoder;
}

// One that is idle, or another one.
StoreBricks::Decoder StoreBricks::take() const {
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            Decoder decoder = std::move(idle_.back());
            idle_.pop_back();
            return decoder;
        }
    }
    return start();
}

StoreBricks::Decoder StoreBricks::start() const {
    OpenedLevels levels;
    Decoder decoder = start(levels);
    const auto areAlike = [](const GridGeometry& a, const GridGeometry& b) { return a.dims == b.dims; };
    if (levels.type != type_ ||
        !std::equal(levels.grids.begin(), levels.grids.end(), grids_.begin(), grids_.end(), areAlike)) {
        refuse(path_, "it has become another store", "open it anew");
    }
    return decoder;
}

void StoreBricks::giveBack(Decoder decoder) const {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(decoder));
}

// What ask(decoder) gives. One that waits may be gone: it ends with the thread that started it. Then another
// one is asked.
template <typename Ask>
auto StoreBricks::answered(const Ask& ask) const {
    bool mayBeGone = true;
    while (true) {
        Decoder decoder = mayBeGone ? take() : start();
        try {
            auto answer = ask(*decoder);
            giveBack(std::move(decoder));
            return answer;
        } catch (const Error&) {
            const bool hasEnded = !decoder->whyItEnded().empty();
            if (!hasEnded) {
                giveBack(std::move(decoder)); // it refused this one, and works still
            }
            if (!hasEnded || !std::exchange(mayBeGone, false)) {
                throw;
            }
        }
    }
}

std::vector<std::byte> StoreBricks::read(int level, const Box3& box) const {
    return answered([&](DecoderProcess& decoder) {
        fetch(decoder, level, box, false);
        decoder.ask(BoxRequest{level, box});
        return received(decoder, box.volume() * sizeOf(type_));
    });
}

void StoreBricks::fetch(DecoderProcess& decoder, int level, const Box3& box, bool isOfExtremes) const {
    if (web_) {
        decoder.ask(FilesRequest{{level, box}, isOfExtremes});
        web_->fetch(decoder.finalAnswer<FileNames>(path_).names);
    }
}

void StoreBricks::fetchLevel(int level) const {
    if (level < 0 || level >= int(grids_.size())) {
        return; // reading it says what is wrong
    }
    Decoder decoder = take();
    const Box3 all = grids_[std::size_t(level)].box();
    constexpr int atOnce = 64; // slices
    for (int z = 0; z < all.hi.z; z += atOnce) {
        reportProgress(double(z) / all.hi.z);
        fetch(*decoder, level, intersect(all, {{0, 0, z}, {all.hi.x, all.hi.y, z + atOnce}}), false);
    }
    if (level > 0) {
        fetch(*decoder, 0, {}, true);
    }
    giveBack(std::move(decoder));
}

std::vector<std::byte> StoreBricks::received(DecoderProcess& decoder, std::size_t bytes) const {
    const auto sent = decoder.finalAnswer<SentValues>(path_);
    if (sent.bytes != bytes) {
        refuse(path_, "its decoder gave another number of values", "get an intact copy of the store");
    }
    return decoder.content(sent.bytes);
}

std::optional<CellExtremes> StoreBricks::extremes() const {
    return answered([&](DecoderProcess& decoder) { return extremesFrom(decoder); });
}

std::optional<CellExtremes> StoreBricks::extremesFrom(DecoderProcess& decoder) const {
    fetch(decoder, 0, {}, true);
    decoder.ask(ExtremesRequest{web_ == nullptr});
    const auto sent = decoder.finalAnswer<SentValues>(path_);
    if (sent.bytes == 0) {
        return {};
    }
    constexpr int longestSide = 1 << 20; // so that no product of a store's sizes is too large
    if (sent.side < 1 || sent.side > longestSide || glm::any(glm::lessThan(sent.cells, glm::ivec3(1))) ||
        sent.cells != divideUp(grids_.front().dims, sent.side) || sent.bytes % (2 * sizeOf(sent.type)) != 0 ||
        !isProduct(sent.bytes / (2 * sizeOf(sent.type)), sent.cells)) {
        refuse(path_, "its decoder gave ranges of something else", "get an intact copy of the store");
    }
    return CellExtremes{sent.side, sent.cells, sent.type, decoder.content(sent.bytes)};
}

} // namespace vs::volume
