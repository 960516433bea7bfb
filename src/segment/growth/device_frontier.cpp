// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/device_frontier.h"

#include "base/check.h"
#include "gl/pass.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vs::segment {

namespace {

constexpr std::uint32_t kTilesPerBrick = 64;
constexpr std::uint32_t kTilesPerGroup = 16;
constexpr std::size_t kWordsPerSlab = 4; // see shaders/words.glsl
constexpr std::size_t kSlabBytes = kWordsPerSlab * sizeof(std::uint32_t);
// When rows of tiles are tested whole: measured on a software renderer, where both sides of a choice cost.
constexpr std::uint64_t kManyVoxels = 4096; // in a generation
constexpr std::uint64_t kManyInTile = 8;

gl::Defines definesFor(Connectivity connectivity, gl::Defines more = {}) {
    if (connectivity == Connectivity::TwentySix) {
        more.emplace_back("VS_NEIGHBOURS_26", "1");
    }
    return more;
}

} // namespace

// Mirrors Expansion in shaders/active_tiles.glsl (std430).
struct DeviceFrontier::Expansion {
    glm::uvec4 tiles{0, 1, 1, 0};
    glm::uvec4 unmade{0, 1, 1, 0};
    glm::uvec4 grown{0};

    [[nodiscard]] std::uint64_t total() const { return std::uint64_t(grown.x) + grown.y + grown.z + grown.w; }
};

DeviceFrontier::DeviceFrontier(const SeedMap& seedMap)
    : tileCount_(std::uint32_t(seedMap.bricks().count()) * kTilesPerBrick),
      planeWords_(seedMap.planeBytes() / sizeof(std::uint32_t)),
      allowed_(planeWords_ / kWordsPerSlab, gl::Format::RGBA32UI, "growth allowed"),
      newest_(2 * planeWords_ / kWordsPerSlab, gl::Format::RGBA32UI, "growth newest"),
      work_(std::size_t(tileCount_) * 10 * sizeof(std::uint32_t), "growth work"),
      expansions_((kMaxExpansions + 1) * sizeof(Expansion), "growth expansions"), answers_(4, "seed answers"),
      list_(4, "growth seeds") {}

std::vector<Frontier::SeedAnswer> DeviceFrontier::testSeeds(SeedMap& seedMap, const Rules& rules,
                                                            int playhead,
                                                            std::span<const std::uint32_t> voxels) {
    gl::Defines defines = seedMap.widthDefines();
    if (rules.forbidden != nullptr) {
        defines.emplace_back("VS_FORBIDDEN", "1");
    }
    gl::Program& test = testSeeds_.prepare(*rules.field, *rules.constraints, defines);
    answers_.reserve(voxels.size() * sizeof(SeedAnswer));
    seedMap.bind(test);
    seedMap.bindOwner(test, rules.owner);
    seedMap.bindList(voxels);
    answers_.bindStorage(kAnswersStorage);
    if (rules.forbidden != nullptr) {
        rules.forbidden->bindStorage(kForbiddenToSeedStorage);
    }
    test.set("count", int(voxels.size())).set("playhead", std::uint32_t(playhead));
    // Labels and sculpture, which this reads as textures, are written next, as images.
    test.dispatchOverList(voxels.size(), gl::Barrier::All);
    return answers_.read<SeedAnswer>(voxels.size()); // numbered as in shaders/test_seeds.comp
}

void DeviceFrontier::invalidate() {
    ++rulesNumber_; // what may be entered has changed
    isValid_ = false;
    added_.clear();
}

void DeviceFrontier::add(std::span<const std::uint32_t> voxels) {
    if (isValid_) { // else all grown voxels are collected anyway
        added_.insert(added_.end(), voxels.begin(), voxels.end());
        newestIsLast_ = false; // unless they entered beside it
    }
}

// Both planes are zero wherever no tile is at work.
void DeviceFrontier::clearNewest() {
    if (carried_ > 0 || isAtWork_) {
        newest_.buffer().clear();
    }
    isAtWork_ = false;
    carried_ = 0;
    if (carriedUnmade_ > 0) {
        ++rulesNumber_; // they count as made
    }
    carriedUnmade_ = 0;
    newestIsRegion_ = false;
    ++stamp_; // no tile is noted any more
}

// The slab that one of the planes of newest voxels begins with.
std::uint32_t DeviceFrontier::planeStart(int plane) const {
    return std::uint32_t(std::size_t(plane) * planeWords_ / kWordsPerSlab);
}

void DeviceFrontier::prepareToNote(gl::Program& program, int expansion, int list, std::uint32_t stamp) const {
    program.set("stamp", stamp)
        .set("expansionNoted", expansion)
        .set("tileCount", tileCount_)
        .set("listNoted", list)
        .set("rulesNumber", rulesNumber_);
}

void DeviceFrontier::collect(SeedMap& seedMap, const Rules& rules) {
    gl::Defines defines = seedMap.widthDefines();
    if (rules.owner.hasOthers || rules.frozen > 0) {
        defines.emplace_back("VS_PARTLY", "1");
    }
    gl::Program& program = collect_.with(definesFor(rules.constraints->connectivity, std::move(defines)));
    seedMap.grownTexels().bindTexture(kGrownTexelsTexture);
    seedMap.bind(program);
    seedMap.bindOwner(program, rules.owner);
    prepareToNote(program, 0, now_, stamp_);
    program.set("newestAt", planeStart(now_)).set("frozen", std::uint32_t(rules.frozen));
    seedMap.bricks().onDevice().bindStorage(kBrickNumbersStorage);
    seedMap.dispatchOverBricks(program, seedMap.bricks().touched(), gl::Barrier::All, 1);
    newestIsLast_ = false;
    newestIsRegion_ = true;
}

void DeviceFrontier::push(const SeedMap& seedMap, std::span<const std::uint32_t> voxels,
                          const Constraints& constraints, Into into) {
    if (voxels.empty()) {
        return;
    }
    const bool notesRows = into == Into::Newest && testing_ == Testing::ByRows;
    gl::Program& program = push_.with(
        definesFor(constraints.connectivity, notesRows ? gl::Defines{{"VS_BY_ROWS", "1"}} : gl::Defines{}));
    list_.reserve(voxels.size() * sizeof(std::uint32_t));
    list_.write(voxels);
    list_.bindStorage(kVoxelsStorage);
    program.set("dims", seedMap.dims())
        .set("brickDims", seedMap.bricks().brickDims())
        .set("count", int(voxels.size()));
    prepareToNote(program, 0, now_, stamp_);
    program.set("newestAt", into == Into::PlaneWithin ? 0U : planeStart(now_) * std::uint32_t(kWordsPerSlab))
        .set("isWithin", into == Into::Newest ? 0 : 1);
    program.dispatchOverList(voxels.size(), gl::Barrier::All);
}

// Opens a submission: the tiles to begin with are those carried over, and what is pushed or collected now.
void DeviceFrontier::begin(int expansions) {
    std::vector<Expansion> table(std::size_t(expansions) + 1);
    const auto arguments = [](std::uint32_t tiles) {
        return glm::uvec4(std::min((tiles + kTilesPerGroup - 1) / kTilesPerGroup, gl::kMaxGroups), 1, 1,
                          tiles);
    };
    table[0].tiles = arguments(carried_);
    table[0].unmade = {std::min(carriedUnmade_, gl::kMaxGroups), 1, 1, carriedUnmade_};
    expansions_.write(std::span<const Expansion>(table));
    expansions_.bindStorage(kExpansionsStorage);
    work_.bindStorage(kWorkStorage);
    newest_.buffer().bindStorage(kNewestStorage);
}

// Expands so many times, giving `generation` and those after it. Returns the voxels that joined each time.
std::vector<std::uint64_t> DeviceFrontier::run(const SeedMap& seedMap, gl::Program& program,
                                               gl::Program* allow, const Constraints& constraints,
                                               gl::Defines noteDefines, int generation, int expansions) {
    gl::Program& note = note_.with(definesFor(constraints.connectivity, std::move(noteDefines)));
    note.set("dims", seedMap.dims()).set("brickDims", seedMap.bricks().brickDims());
    newest_.bindTexture(kNewestTexelsTexture);
    for (int i = 0; i < expansions; ++i) {
        const int next = 1 - now_;
        // A device need not have a ninth binding, so what is allowed and the numbers of bricks share one.
        allowed_.buffer().bindStorage(kAllowedStorage);
        if (allow != nullptr) {
            prepareToNote(*allow, i + 1, next, stamp_);
            allow->set("expansionIndex", i);
            allow->dispatchIndirect(expansions_,
                                    std::size_t(i) * sizeof(Expansion) + offsetof(Expansion, unmade),
                                    gl::Barrier::All);
        }
        prepareToNote(program, i + 1, next, ++stamp_);
        program.set("expansionIndex", i)
            .set("generation", std::uint32_t(generation + i))
            .set("newestAt", planeStart(now_))
            .set("nextAt", planeStart(next))
            .set("isBefore", newestIsLast_ ? 1 : 0);
        program.dispatchIndirect(expansions_, std::size_t(i) * sizeof(Expansion), gl::Barrier::Storage);
        seedMap.bricks().onDevice().bindStorage(kBrickNumbersStorage);
        prepareToNote(note, i + 1, next, stamp_);
        const bool clears = newestIsRegion_;
        note.set("expansionIndex", i)
            .set("generation", std::uint32_t(generation + i))
            .set("cleansUp", clears ? 0 : 1);
        // Each expansion takes its tiles, and the newest voxels as texels, from the one before.
        note.dispatchIndirect(expansions_, std::size_t(i) * sizeof(Expansion), gl::Barrier::All);
        if (clears) {
            newest_.buffer().clear(planeStart(now_) * kSlabBytes, planeWords_ * sizeof(std::uint32_t));
            newestIsRegion_ = false;
        }
        now_ = next;
        newestIsLast_ = true;
    }
    const auto table = expansions_.read<Expansion>(std::size_t(expansions) + 1);
    carried_ = table.back().tiles.w;
    carriedUnmade_ = table.back().unmade.w;
    judge(table[std::size_t(expansions) - 1], expansions);
    std::vector<std::uint64_t> grown;
    grown.reserve(std::size_t(expansions));
    for (int i = 0; i < expansions; ++i) {
        grown.push_back(table[std::size_t(i)].total());
    }
    return grown;
}

// Whether so much grows that whole rows of tiles should be tested at once; or nothing, and what is left of
// the planes can be cleared at once when something is to grow again.
void DeviceFrontier::judge(const Expansion& last, int expansions) {
    growsMuch_ = last.total() > kManyVoxels && last.total() > kManyInTile * last.tiles.w;
    isOver_ = last.total() == 0 && carriedUnmade_ == 0;
    expansionsByVoxel_ = std::min(expansionsByVoxel_ + expansions, kMaxExpansions);
}

// From now on rows are noted with the tiles; those of the tiles carried over are here.
void DeviceFrontier::goOverToRows(const SeedMap& seedMap) {
    testing_ = Testing::ByRows;
    gl::Program& program = noteRows_.with({});
    program.set("dims", seedMap.dims()).set("brickDims", seedMap.bricks().brickDims());
    prepareToNote(program, 0, now_, stamp_);
    program.dispatchIndirect(expansions_, 0, gl::Barrier::All);
}

std::vector<std::uint64_t> DeviceFrontier::expand(SeedMap& seedMap, const Rules& rules, int generation,
                                                  int expansions) {
    VS_CHECK(expansions >= 1 && expansions <= kMaxExpansions);
    const gl::Pass pass("expand region");
    if (isAtWork_) {
        invalidate();
    }
    if (generation + expansions - 1 > SeedMap::kLongest16) {
        seedMap.widen();
    }
    if (!isValid_ || isOver_) {
        clearNewest();
    }
    if (!isValid_) {
        testing_ = Testing::ByVoxel;
        growsMuch_ = false;
        expansionsByVoxel_ = 0;
    }
    const bool goesOver = testing_ == Testing::ByVoxel && growsMuch_;
    if (testing_ == Testing::ByVoxel && !goesOver) {
        expansions = std::min(expansions, std::max(expansionsByVoxel_, 1));
    }
    isAtWork_ = true;
    begin(expansions);
    if (goesOver) {
        goOverToRows(seedMap);
    }
    allowed_.buffer().bindStorage(kAllowedStorage);
    if (isValid_) {
        push(seedMap, added_, *rules.constraints);
        added_.clear();
    } else {
        collect(seedMap, rules);
        isValid_ = true;
    }

    const gl::Defines forbidden =
        rules.forbidden != nullptr ? gl::Defines{{"VS_FORBIDDEN", "1"}} : gl::Defines{};
    gl::Defines defines = seedMap.widthDefines();
    gl::Program* allow = nullptr;
    if (testing_ == Testing::ByRows) {
        allow = &allow_.prepare(*rules.field, *rules.constraints, forbidden);
        allow->set("dims", seedMap.dims()).set("brickDims", seedMap.bricks().brickDims());
        allowed_.bindTexture(kAllowedTexelsTexture);
    } else {
        defines.insert(defines.end(), forbidden.begin(), forbidden.end());
        defines.emplace_back("VS_BY_VOXEL", "1");
        seedMap.grownTexels().bindTexture(kGrownTexelsTexture);
    }
    gl::Program& program = expand_.prepare(*rules.field, *rules.constraints, defines);
    seedMap.bind(program);
    if (rules.forbidden != nullptr) {
        rules.forbidden->bindStorage(kForbiddenToGrowStorage);
    }
    auto grown =
        run(seedMap, program, allow, *rules.constraints,
            allow != nullptr ? gl::Defines{{"VS_BY_ROWS", "1"}} : gl::Defines{}, generation, expansions);
    isAtWork_ = false;
    return grown;
}

int DeviceFrontier::flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
                          const gl::TexelBuffer& region, const gl::Buffer& reached, int expansions) {
    const gl::Pass pass("flood region");
    invalidate();
    clearNewest();
    const int atOnce = std::min(kMaxExpansions, std::max(expansions, 1));
    isAtWork_ = true;
    begin(atOnce);
    region.buffer().bindStorage(kRegionStorage);
    push(seedMap, seeds, *rules.constraints, Into::NewestWithin);
    reached.bindStorage(kNewestStorage); // and once more, into the set itself; the tiles are noted already
    push(seedMap, seeds, *rules.constraints, Into::PlaneWithin);
    newest_.buffer().bindStorage(kNewestStorage);

    gl::Program& program = expand_.prepare(*rules.field, *rules.constraints, {{"VS_FLOOD", "1"}});
    int found = 0;
    for (bool goesOn = expansions > 0; goesOn;) {
        const int batch = std::min(atOnce, expansions - found);
        seedMap.bind(program);
        reached.bindStorage(kGrownStorage);
        region.bindTexture(kAllowedTexelsTexture);
        for (const std::uint64_t voxels :
             run(seedMap, program, nullptr, *rules.constraints, {{"VS_FLOOD", "1"}}, 0, batch)) {
            found += voxels > 0 ? 1 : 0;
            goesOn = voxels > 0;
        }
        goesOn = goesOn && found < expansions;
        if (goesOn) {
            begin(std::min(atOnce, expansions - found));
        }
    }
    carried_ = std::max(carried_, 1U); // the planes are not clean
    clearNewest();
    invalidate(); // tiles that the seeds lie in count as made
    return found;
}

} // namespace vs::segment
