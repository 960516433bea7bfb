// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/detail.h"

#include "base/error.h"
#include "field/shaders/bindings.h"
#include "gl/pass.h"

#include <algorithm>

namespace vs::field {

namespace {

constexpr std::size_t kMostFailures = 20; // that are told of
constexpr std::size_t kFirstSlots = 64;   // of a pool that has room for more
constexpr std::size_t kGrowth = 4;

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

std::vector<std::size_t> bricksOfLevels(const std::vector<BrickGrid>& grids) {
    std::vector<std::size_t> counts;
    for (const BrickGrid& grid : grids) {
        counts.push_back(grid.count());
    }
    return counts;
}

// Memory for all bricks that may ever be looked at takes long to be had: most pictures need far fewer.
std::size_t firstPoolBytes(const DetailOptions& options, gl::Format format) {
    const auto texels = std::size_t(options.side + 1);
    const std::size_t few = kFirstSlots * texels * texels * texels * gl::bytesPerTexel(format);
    return std::min(options.deviceBytes, std::max(options.deviceBytes / (kGrowth * kGrowth), few));
}

} // namespace

Detail::Detail(const std::shared_ptr<const volume::BrickSource>& source, const volume::GridGeometry& scene,
               const DetailOptions& options)
    : grids_(gridsOf(*source, scene, options)), reader_(source, grids_, options.hostBytes, options.threads),
      texels_(brickTexels(source->type())), options_(options),
      poolBytes_(firstPoolBytes(options, texels_.format)),
      pool_(options.side + 1, texels_.format, poolBytes_, mostBricks(grids_)),
      table_(bricksOfLevels(grids_), cellsAlong(options.side)), block_(sizeof(BricksBlock), "bricks") {
    while (finest_ + 1 < int(grids_.size()) &&
           2 * grids_[std::size_t(finest_)].count() > gl::TexelBuffer::mostTexels()) {
        ++finest_;
    }
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

void Detail::addDefines(const Layers& layers, gl::Defines& defines) const {
    const auto switches =
        gl::switchesOn({{"BRICKS", true}, {"FINER", isFiner()}, {"FINER_CUTS", layers.hasCuts}});
    defines.insert(defines.end(), switches.begin(), switches.end());
    if (layers.hasSegments) {
        defines.emplace_back("FINER_SEGMENTS", segmentKinds());
    }
}

std::string Detail::segmentKinds() const {
    return pool_.overlay(BrickLayer::Segments).format() == gl::Format::RGBA8 ? "2" : "1";
}

void Detail::tell(const std::string& line) {
    const bool isKnown = std::find(failures_.begin(), failures_.end(), line) != failures_.end();
    if (!isKnown && failures_.size() < kMostFailures) {
        failures_.push_back(line);
    }
}

void Detail::use(int level) {
    if (level == level_ && isShown_) {
        return;
    }
    level_ = level;
    for (Over& over : over_) {
        over.laidOverAll = {};
    }
    show();
}

// Shaders see where the bricks of the level in use are now.
void Detail::show() {
    isShown_ = false;
    if (hasLostPool()) {
        remakePool({});
    }
    table_.show(level_, pool_, failed_);
    writeBlock();
    isShown_ = true;
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
    block.brickCells = {glm::ivec2(pool_.slotCounts()), table_.firstCell(),
                        table_.hasCells() ? cellsAlong(grid.side) : 0};
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

LayerFormats Detail::layerFormats() const {
    LayerFormats formats;
    for (const BrickLayer layer : kBrickLayers) {
        const gl::Texture& over = pool_.overlay(layer);
        formats[std::size_t(layer)] = over ? std::optional(over.format()) : std::nullopt;
    }
    return formats;
}

// The bricks that were there come again from the host.
void Detail::remakePool(const LayerFormats& formats) {
    isShown_ = false;
    pool_ = BrickPool(1, texels_.format, 1, 1); // freed first, so that old and new need not fit together
    pool_ = BrickPool(options_.side + 1, texels_.format, poolBytes_, mostBricks(grids_), formats);
    for (Over& over : over_) {
        over.laid.clear();
        over.laidOverAll = {};
    }
}

// Bricks share their room with what lies over them from now on. Where there is no room, they stay as they are
// without it.
void Detail::makeRoomFor(BrickLayer layer) {
    LayerFormats formats = layerFormats();
    try {
        formats[std::size_t(layer)] = overIn(layer).overlay->format();
        remakePool(formats);
    } catch (const GlError&) {
        formats[std::size_t(layer)] = std::nullopt;
        remakePool(formats);
        tell(layer == BrickLayer::Cuts
                 ? "the device has no room for what is cut at the finest level: pictures show cuts at the "
                   "resolution that is worked on; give --device-memory less"
                 : "the device has no room for segments at the finest level: pictures show them at the "
                   "resolution that is worked on; give --device-memory less");
    }
    show();
}

// Before bricks go that may be looked at again, the pool takes more of what it may have, if that makes a
// difference.
void Detail::growPool() {
    const LayerFormats formats = layerFormats();
    const std::size_t had = poolBytes_;
    const std::size_t more =
        std::min(options_.deviceBytes, kGrowth * poolBytes_ + kGrowth); // a rest of the division counts, too
    const std::size_t slots =
        BrickPool::slotsFor(options_.side + 1, texels_.format, more, mostBricks(grids_), formats);
    poolBytes_ = more;
    if (slots <= pool_.slotCount()) {
        return;
    }
    const std::size_t before = pool_.slotCount();
    try {
        remakePool(formats);
        show();
    } catch (const std::exception&) { // what is allowed may be more than there is
        poolBytes_ = had;
    }
    if (poolBytes_ == had || pool_.slotCount() <= before) {
        poolBytes_ = options_.deviceBytes = had;
        remakePool(formats);
        show();
    }
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

void Detail::bind(const Layers& layers) {
    block_.bindUniform(kBricksBlock);
    table_.bind();
    pool_.texture().bindTexture(kBrickPoolTexture);
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
    const std::vector<int> used = table_.takeUses();
    const auto missed = std::size_t(std::count_if( // when they were asked for: some may have come since
        used.begin(), used.end(), [&](int place) { return table_.isMissing(place); }));
    deliver(0); // what others asked for is not lost when something else is wanted
    pool_.beginRound();
    isFull_ = false;
    std::vector<std::pair<double, BrickKey>> missing;
    const glm::dvec3 viewer = viewerVoxel * grid.perSceneVoxel + grid.origin;
    for (const int place : used) {
        const BrickKey key{level_, place};
        if (table_.isMissing(place)) {
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

// There was not even the memory that it had before, when it was to grow.
bool Detail::hasLostPool() const { return pool_.texture().size() == glm::ivec3(1); }

void Detail::place(const ReadBrick& brick) {
    if (hasLostPool()) {
        return;
    }
    if (pool_.isFull() && poolBytes_ < options_.deviceBytes) {
        growPool();
    }
    const auto put = pool_.put(brick.key, brick.texels);
    if (!put) {
        isFull_ = true; // it is in the host's cache, and comes again when it is asked for again
        return;
    }
    table_.noteCells(put->slot, brick.ranges.cells);
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
    if (put->goneInstead) {
        table_.remove(*put->goneInstead);
    }
    table_.place(brick.key, put->slot);
}

bool Detail::deliver(double waitMs) {
    const std::size_t before = bricksRead_;
    bool isKnownNow = false; // what was not known before: that it cannot be read, or what it holds
    for (const ReadBrick& brick : reader_.take(waitMs)) {
        if (!brick.failure.empty()) {
            failed_.insert(brick.key);
            tell(brick.failure + "; pictures are coarser there");
            table_.giveUp(brick.key);
            isKnownNow = true;
            continue;
        }
        isKnownNow = table_.noteRange(brick.key, brick.ranges.all) || isKnownNow;
        if (!pool_.find(brick.key)) {
            place(brick);
        }
    }
    return isKnownNow || bricksRead_ > before;
}

std::size_t Detail::deviceBytes() const { return pool_.bytes() + table_.deviceBytes(); }

} // namespace vs::field
