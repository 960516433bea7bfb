// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/detail.h"

#include "base/error.h"
#include "field/shaders/bindings.h"
#include "gl/pass.h"

#include <algorithm>

namespace vs::field {

namespace {

// What a page says of a brick: mirrors field/shaders/bricks.glsl.
constexpr std::uint32_t kNotThere = 0;
constexpr std::uint32_t kNotReadable = 1;
std::uint32_t pageOf(glm::ivec3 slot) {
    return 0x80000000U | std::uint32_t(slot.x) | std::uint32_t(slot.y) << 10 | std::uint32_t(slot.z) << 20;
}

constexpr std::size_t kMostFailures = 20; // that are told of

// The source's levels, from the finest on, that are finer than the scene's grid.
std::vector<BrickGrid> gridsOf(const volume::BrickSource& source, const volume::GridGeometry& scene,
                               const DetailOptions& options) {
    std::vector<BrickGrid> grids;
    for (const volume::GridGeometry& level : source.levels()) {
        const auto grid = brickGrid(level, scene, options.side);
        const bool isCoarser = grid && glm::any(glm::lessThan(grid->perSceneVoxel, glm::dvec3(0.99)));
        if (!grid || isCoarser || !(grid->isFiner() || options.hasOwnLevel)) {
            break;
        }
        grids.push_back(*grid);
    }
    if (grids.empty()) {
        throw Error("{}: it has no level that is finer than the one that is worked on", source.name());
    }
    return grids;
}

std::size_t mostBricks(const std::vector<BrickGrid>& grids) {
    std::size_t count = 0;
    for (const BrickGrid& grid : grids) {
        count += grid.count();
    }
    return count;
}

} // namespace

Detail::Detail(const std::shared_ptr<const volume::BrickSource>& source, const volume::GridGeometry& scene,
               const DetailOptions& options)
    : grids_(gridsOf(*source, scene, options)), reader_(source, grids_, options.hostBytes, options.threads),
      texels_(brickTexels(source->type())), options_(options),
      pool_(options.side + 1, texels_.format, options.deviceBytes, mostBricks(grids_)),
      block_(sizeof(BricksBlock), "bricks") {
    while (finest_ + 1 < int(grids_.size()) &&
           2 * grids_[std::size_t(finest_)].count() > gl::TexelBuffer::mostTexels()) {
        ++finest_;
    }
    ranges_.resize(grids_.size());
    use(finest_);
}

// Along axes that become no finer, voxels are as small as they ever will be.
bool Detail::isFineEnough(glm::dvec3 spacing, double pixelSteps) const {
    const glm::dvec3 finest = grids_[std::size_t(finest_)].spacing;
    for (int axis = 0; axis < 3; ++axis) {
        if (spacing[axis] > pixelSteps && finest[axis] < 0.99 * spacing[axis]) {
            return false;
        }
    }
    return true;
}

std::optional<int> Detail::levelFor(double pixelSteps) const {
    const BrickGrid& last = grids_.back();
    if (last.isFiner() && isFineEnough(last.spacing * last.perSceneVoxel, pixelSteps)) {
        return {};
    }
    for (int level = int(grids_.size()) - 1; level > finest_; --level) {
        if (isFineEnough(grids_[std::size_t(level)].spacing, pixelSteps)) {
            return level;
        }
    }
    return finest_;
}

std::optional<int> Detail::coarserThan(int level) const {
    const bool hasCoarser = level + 1 < int(grids_.size());
    return hasCoarser ? std::optional(level + 1) : std::nullopt;
}

bool Detail::hasTellingRanges(int macrocell) const {
    const glm::dvec3 size = double(macrocell) * grids_[std::size_t(level_)].perSceneVoxel;
    return !options_.areRangesKnown || glm::all(glm::greaterThanEqual(size, glm::dvec3(1.99 * kBrickCell)));
}

void Detail::tell(const std::string& line) {
    const bool isKnown = std::find(failures_.begin(), failures_.end(), line) != failures_.end();
    if (!isKnown && failures_.size() < kMostFailures) {
        failures_.push_back(line);
    }
}

void Detail::use(int level) {
    if (level == level_) {
        return;
    }
    level_ = level;
    for (Over& over : over_) {
        over.laidOverAll = {};
    }
    writeBlock();
    writePages();
}

void Detail::writeBlock() {
    const BrickGrid& grid = grids_[std::size_t(level_)];
    const glm::vec3 pool(pool_.texture().size());
    BricksBlock block;
    block.levelScale = glm::vec4(grid.perSceneVoxel, step());
    block.levelOrigin = glm::vec4(grid.origin, 1.0 / grid.side);
    block.levelDims = glm::ivec4(grid.dims, grid.side);
    block.brickCounts = glm::ivec4(grid.counts(), grid.count());
    block.poolScale = glm::vec4(1.0F / pool, float(grid.texels()));
    block.brickValue = {texels_.valueScale, texels_.valueOffset, 0, 0};
    const bool hasCells = tableWords() > 2 * grid.count();
    block.brickCells = {glm::ivec2(pool_.slotCounts()), 2 * grid.count(),
                        hasCells ? cellsAlong(grid.side) : 0};
    block_.writeValue(block);
}

// A brick of a level meets a box of the finest level's voxels, or what lies between those and the next.
bool Detail::reaches(const BrickKey& key, const Box3& finest) const {
    const BrickGrid& top = grids_.front();
    const BrickGrid& grid = grids_[std::size_t(key.level)];
    const glm::dvec3 scale = top.perSceneVoxel / grid.perSceneVoxel;
    const glm::dvec3 offset = top.origin - grid.origin * scale;
    const glm::dvec3 lo(grid.brickAt(key.place) * grid.side);
    const glm::dvec3 hi = lo + double(grid.side);
    return glm::all(glm::lessThanEqual(lo * scale + offset - 1.0, glm::dvec3(finest.hi))) &&
           glm::all(glm::greaterThanEqual(hi * scale + offset + 1.0, glm::dvec3(finest.lo)));
}

void Detail::layOver(BrickLayer layer, const BrickKey& key) {
    Over& over = overIn(layer);
    const BrickGrid& grid = grids_[std::size_t(key.level)];
    pool_.lay(layer, key, over.overlay->texelsOf(grid, grid.brickAt(key.place)));
    over.laid[key] = {over.overlay, over.version};
}

// Brings what lies over the bricks of the level in use up to date: a stroke that is drawn asks for what was
// there before it and what is there now in turns, and most bricks have the same in both.
void Detail::layOverAll(BrickLayer layer) {
    Over& over = overIn(layer);
    if (over.laidOverAll.overlay == over.overlay) {
        return;
    }
    const gl::Pass pass("lay over bricks");
    const BrickGrid& grid = grids_[std::size_t(level_)];
    std::map<std::uint64_t, Box3> changed; // since versions
    std::vector<BrickKey> keys;
    pool_.forEach([&](const BrickKey& key, glm::ivec3) {
        if (key.level != level_) {
            return;
        }
        const auto [entry, isNew] = over.laid.try_emplace(key); // new: nothing was laid since it came
        Laid& laid = entry->second;
        const std::uint64_t since = std::min(laid.version, over.version);
        if (!changed.contains(since)) {
            changed[since] = over.changedSince(since);
        }
        const bool isSame = !isNew && (laid.version == over.version || !reaches(key, changed[since]) ||
                                       (laid.overlay != nullptr &&
                                        over.overlay->isAlike(*laid.overlay, grid, grid.brickAt(key.place))));
        if (isSame) {
            laid = {over.overlay, over.version};
        } else {
            keys.push_back(key);
        }
    });
    for (const BrickKey& key : keys) {
        layOver(layer, key);
    }
    over.laidOverAll = {over.overlay, over.version};
}

// Bricks share their room with what lies over them from now on; those that were there come again from the
// host. Where there is no room, they stay as they are without it.
void Detail::makeRoomFor(BrickLayer layer) {
    LayerFormats formats;
    for (const BrickLayer other : kBrickLayers) {
        formats[std::size_t(other)] =
            pool_.overlay(other) ? std::optional(pool_.overlay(other).format()) : std::nullopt;
    }
    const auto make = [&](std::optional<gl::Format> format) {
        formats[std::size_t(layer)] = format;
        pool_ = BrickPool(1, texels_.format, 1, 1); // freed first, so that old and new need not fit together
        pool_ =
            BrickPool(options_.side + 1, texels_.format, options_.deviceBytes, mostBricks(grids_), formats);
    };
    try {
        make(overIn(layer).overlay->format());
    } catch (const GlError&) {
        make({});
        tell(layer == BrickLayer::Cuts
                 ? "the device has no room for what is cut at the finest level: pictures show cuts at the "
                   "resolution that is worked on; give --device-memory less"
                 : "the device has no room for segments at the finest level: pictures show them at the "
                   "resolution that is worked on; give --device-memory less");
    }
    for (Over& over : over_) {
        over.laid.clear();
        over.laidOverAll = {};
    }
    cells_.clear();
    writeBlock();
    writePages();
}

void Detail::lay(BrickLayer layer, const std::shared_ptr<const BrickOverlay>& overlay, std::uint64_t version,
                 const std::function<Box3(std::uint64_t)>& changedSince) {
    Over& over = overIn(layer);
    const bool isFirst = over.overlay == nullptr || over.overlay->isEmpty();
    over.overlay = overlay;
    over.version = version;
    over.changedSince = changedSince;
    const bool isOtherFormat =
        pool_.overlay(layer) && !overlay->isEmpty() && pool_.overlay(layer).format() != overlay->format();
    if (isOtherFormat || (isFirst && !pool_.overlay(layer) && !overlay->isEmpty())) {
        makeRoomFor(layer);
    }
}

std::size_t Detail::cellWordsOfSlot() const {
    const auto along = std::size_t(cellsAlong(options_.side));
    return along * along * along;
}

// Pages and ranges of the level's bricks, and the ranges of cells, if the device has room for those too.
std::size_t Detail::tableWords() const {
    const std::size_t bricks = 2 * grids_[std::size_t(level_)].count();
    const std::size_t all = bricks + pool_.slotCount() * cellWordsOfSlot();
    return all <= gl::TexelBuffer::mostTexels() ? all : bricks;
}

void Detail::writePages() {
    const BrickGrid& grid = grids_[std::size_t(level_)];
    pageOf_.assign(grid.count(), kNotThere);
    for (const BrickKey& key : failed_) {
        if (key.level == level_) {
            pageOf_[std::size_t(key.place)] = kNotReadable;
        }
    }
    pool_.forEach([&](const BrickKey& key, glm::ivec3 slot) {
        if (key.level == level_) {
            pageOf_[std::size_t(key.place)] = pageOf(slot);
        }
    });
    auto& ranges = ranges_[std::size_t(level_)];
    ranges.resize(grid.count(), kAnyValue);
    cells_.resize(pool_.slotCount() * cellWordsOfSlot(), kAnyValue);
    if (pages_.texels() < tableWords()) {
        pages_ = gl::TexelBuffer(tableWords(), gl::Format::R32UI, "pages of bricks");
    }
    if (uses_.size() < pageOf_.size() * sizeof(std::uint32_t)) {
        uses_ = gl::Buffer(pageOf_.size() * sizeof(std::uint32_t), "uses of bricks");
    }
    pages_.write(std::as_bytes(std::span(pageOf_)), 0);
    pages_.write(std::as_bytes(std::span(ranges)), grid.count());
    if (tableWords() > 2 * grid.count()) {
        pages_.write(std::as_bytes(std::span(cells_)), 2 * grid.count());
    }
    uses_.clear();
}

void Detail::setPage(int place, std::uint32_t page) {
    pageOf_[std::size_t(place)] = page;
    pages_.write(std::as_bytes(std::span(&page, 1)), std::size_t(place));
}

// What a brick holds stays known when it is no longer there.
void Detail::noteRanges(const ReadBrick& brick) {
    auto& ranges = ranges_[std::size_t(brick.key.level)];
    ranges.resize(grids_[std::size_t(brick.key.level)].count(), kAnyValue);
    ranges[std::size_t(brick.key.place)] = brick.ranges.all;
    if (brick.key.level == level_) {
        pages_.write(std::as_bytes(std::span(&brick.ranges.all, 1)),
                     ranges.size() + std::size_t(brick.key.place));
    }
}

void Detail::placeCells(const ReadBrick& brick, glm::ivec3 slot) {
    const glm::ivec3 slots = pool_.slotCounts();
    const auto number = std::size_t((slot.z * slots.y + slot.y) * slots.x + slot.x);
    std::copy(brick.ranges.cells.begin(), brick.ranges.cells.end(),
              cells_.begin() + std::ptrdiff_t(number * cellWordsOfSlot()));
    const std::size_t begin = 2 * pageOf_.size();
    if (tableWords() > begin) {
        pages_.write(std::as_bytes(std::span(brick.ranges.cells)), begin + number * cellWordsOfSlot());
    }
}

void Detail::bind(const Layers& layers) {
    block_.bindUniform(kBricksBlock);
    pages_.bindTexture(kBrickPagesTexture);
    pool_.texture().bindTexture(kBrickPoolTexture);
    uses_.bindStorage(kBrickUsesStorage);
    if (layers.hasCuts) {
        layOverAll(BrickLayer::Cuts);
        pool_.overlay(BrickLayer::Cuts).bindTexture(kBrickCutsTexture);
    }
    if (layers.hasSegments) {
        layOverAll(BrickLayer::Segments);
        pool_.overlay(BrickLayer::Segments).bindTexture(kBrickSegmentsTexture);
    }
}

std::size_t Detail::endRound(glm::dvec3 viewerVoxel) {
    const gl::Pass pass("bricks asked for");
    const BrickGrid& grid = grids_[std::size_t(level_)];
    const auto uses = uses_.read<std::uint32_t>(grid.count());
    uses_.clear();
    std::vector<int> used;
    std::size_t missed = 0; // when they were asked for: some may have come since
    for (int place = 0; place < int(uses.size()); ++place) {
        if (uses[std::size_t(place)] != 0) {
            used.push_back(place);
            missed += pageOf_[std::size_t(place)] == kNotThere ? 1 : 0;
        }
    }
    deliver(0); // what others asked for is not lost when something else is wanted
    pool_.beginRound();
    isFull_ = false;
    std::vector<std::pair<double, BrickKey>> missing;
    const glm::dvec3 viewer = viewerVoxel * grid.perSceneVoxel + grid.origin;
    for (const int place : used) {
        const BrickKey key{level_, place};
        if (pageOf_[std::size_t(place)] == kNotThere) {
            const glm::dvec3 middle = (glm::dvec3(grid.brickAt(place)) + 0.5) * double(grid.side);
            missing.emplace_back(glm::distance(middle, viewer), key);
        } else {
            pool_.use(key);
        }
    }
    std::sort(missing.begin(), missing.end());
    std::vector<BrickKey> keys;
    for (const auto& [distance, key] : missing) {
        keys.push_back(key);
    }
    reader_.want(missed > 0 ? keys : std::vector<BrickKey>());
    return missed;
}

bool Detail::deliver(double waitMs) {
    bool hasChanged = false;
    for (const ReadBrick& brick : reader_.take(waitMs)) {
        if (!brick.failure.empty()) {
            failed_.insert(brick.key);
            tell(brick.failure + "; pictures are coarser there");
            if (brick.key.level == level_) {
                setPage(brick.key.place, kNotReadable);
            }
            hasChanged = true;
            continue;
        }
        noteRanges(brick);
        if (pool_.find(brick.key)) {
            continue;
        }
        const auto put = pool_.put(brick.key, brick.texels);
        if (!put) {
            isFull_ = true; // it is in the host's cache, and comes again when it is asked for again
            continue;
        }
        placeCells(brick, put->slot);
        for (const BrickLayer layer : kBrickLayers) {
            Over& over = overIn(layer);
            if (put->goneInstead) {
                over.laid.erase(*put->goneInstead);
            }
            // What nobody looks at is laid when somebody does.
            if (over.overlay != nullptr && over.laidOverAll.overlay == over.overlay &&
                brick.key.level == level_) {
                layOver(layer, brick.key);
            }
        }
        ++bricksRead_;
        hasChanged = true;
        if (put->goneInstead && put->goneInstead->level == level_) {
            setPage(put->goneInstead->place, kNotThere);
        }
        if (brick.key.level == level_) {
            setPage(brick.key.place, pageOf(put->slot));
        }
    }
    return hasChanged;
}

std::size_t Detail::deviceBytes() const {
    return pool_.bytes() + pages_.texels() * sizeof(std::uint32_t) + uses_.size();
}

} // namespace vs::field
