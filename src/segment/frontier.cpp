// SPDX-License-Identifier: Apache-2.0
#include "segment/frontier.h"

#include "base/check.h"
#include "gl/pass.h"

#include <algorithm>
#include <cstddef>

namespace vs::segment {

namespace {

constexpr std::uint32_t kTilesPerBrick = 64;
constexpr std::uint32_t kTilesPerGroup = 16;
constexpr std::size_t kWordsPerSlab = 4; // see shaders/words.glsl
constexpr std::uint32_t kMaxGroups = 65535;

gl::Defines definesFor(Connectivity connectivity, gl::Defines more = {}) {
    if (connectivity == Connectivity::TwentySix) {
        more.emplace_back("VS_NEIGHBOURS_26", "1");
    }
    return more;
}

} // namespace

// Mirrors Step in shaders/active_tiles.glsl (std430).
struct Frontier::Step {
    glm::uvec4 tiles{0, 1, 1, 0};
    glm::uvec4 unmade{0, 1, 1, 0};
    glm::uvec4 grown{0};

    [[nodiscard]] std::uint64_t total() const { return std::uint64_t(grown.x) + grown.y + grown.z + grown.w; }
};

Frontier::Frontier(const SeedMap& seedMap)
    : tileCount_(std::uint32_t(seedMap.bricks().count()) * kTilesPerBrick),
      planeWords_(seedMap.planeBytes() / sizeof(std::uint32_t)),
      allowed_(planeWords_ / kWordsPerSlab, gl::Format::RGBA32UI, "growth allowed"),
      newest_(2 * planeWords_ / kWordsPerSlab, gl::Format::RGBA32UI, "growth newest"),
      work_(std::size_t(tileCount_) * 10 * sizeof(std::uint32_t), "growth work"),
      steps_((kMaxSteps + 1) * sizeof(Step), "growth steps"), list_(4, "growth seeds") {}

void Frontier::invalidate() {
    ++rulesNumber_; // what may be entered has changed
    isValid_ = false;
    added_.clear();
}

void Frontier::add(std::span<const std::uint32_t> voxels) {
    if (isValid_) { // else all grown voxels are collected anyway
        added_.insert(added_.end(), voxels.begin(), voxels.end());
        newestIsLast_ = false; // unless they entered beside it
    }
}

// Both planes are zero wherever no tile is at work.
void Frontier::clearNewest() {
    if (carried_ > 0) {
        newest_.buffer().clear();
    }
    carried_ = 0;
    if (carriedUnmade_ > 0) {
        ++rulesNumber_; // they count as made
    }
    carriedUnmade_ = 0;
    ++stamp_; // no tile is noted any more
}

// The slab that one of the planes of newest voxels begins with.
std::uint32_t Frontier::planeStart(int plane) const {
    return std::uint32_t(std::size_t(plane) * planeWords_ / kWordsPerSlab);
}

void Frontier::prepareToNote(gl::Program& program, int step, int list, std::uint32_t stamp) const {
    program.set(5, stamp).set(6, step).set(7, tileCount_).set(8, list).set(12, rulesNumber_);
}

void Frontier::collect(SeedMap& seedMap, const Rules& rules) {
    gl::Program& program = collect_.with(definesFor(rules.constraints->connectivity, seedMap.widthDefines()));
    seedMap.grownTexels().bindTexture(6);
    seedMap.bind(program);
    seedMap.bindOwner(program, rules.owner);
    prepareToNote(program, 0, now_, stamp_);
    program.set(10, planeStart(now_)).set(11, std::uint32_t(rules.frozen));
    seedMap.dispatchOverBricks(program, seedMap.bricks().touched(), gl::Barrier::All);
    newestIsLast_ = false;
}

void Frontier::push(const SeedMap& seedMap, std::span<const std::uint32_t> voxels,
                    const Constraints& constraints, Into into) {
    if (voxels.empty()) {
        return;
    }
    gl::Program& program = push_.with(definesFor(constraints.connectivity));
    list_.reserve(voxels.size() * sizeof(std::uint32_t));
    list_.write(voxels);
    list_.bindStorage(7);
    program.set(0, seedMap.dims()).set(1, seedMap.bricks().brickDims()).set(9, int(voxels.size()));
    prepareToNote(program, 0, now_, stamp_);
    program.set(10, into == Into::PlaneWithin ? 0U : planeStart(now_) * std::uint32_t(kWordsPerSlab))
        .set(11, into == Into::Newest ? 0 : 1);
    program.dispatchOverList(voxels.size(), gl::Barrier::All);
}

// Opens a submission: the tiles to begin with are those carried over, and what is pushed or collected now.
void Frontier::begin(int steps) {
    std::vector<Step> table(std::size_t(steps) + 1);
    const auto arguments = [](std::uint32_t tiles) {
        return glm::uvec4(std::min((tiles + kTilesPerGroup - 1) / kTilesPerGroup, kMaxGroups), 1, 1, tiles);
    };
    table[0].tiles = arguments(carried_);
    table[0].unmade = {std::min(carriedUnmade_, kMaxGroups), 1, 1, carriedUnmade_};
    steps_.write(std::span<const Step>(table));
    steps_.bindStorage(5);
    work_.bindStorage(6);
    newest_.buffer().bindStorage(2);
}

// Expands so many times, giving `generation` and those after it. Returns the voxels that joined each time.
std::vector<std::uint64_t> Frontier::run(const SeedMap& seedMap, gl::Program& program, gl::Program* allow,
                                         const Constraints& constraints, int generation, int steps) {
    gl::Program& note = note_.with(definesFor(
        constraints.connectivity, allow == nullptr ? gl::Defines{{"VS_FLOOD", "1"}} : gl::Defines{}));
    note.set(0, seedMap.dims()).set(1, seedMap.bricks().brickDims());
    seedMap.bricks().onDevice().bindStorage(8);
    newest_.bindTexture(4);
    for (int i = 0; i < steps; ++i) {
        const int next = 1 - now_;
        if (allow != nullptr) {
            prepareToNote(*allow, i + 1, next, stamp_);
            allow->set(10, i);
            allow->dispatchIndirect(steps_, std::size_t(i) * sizeof(Step) + offsetof(Step, unmade),
                                    gl::Barrier::All);
        }
        prepareToNote(program, i + 1, next, ++stamp_);
        program.set(10, i)
            .set(11, std::uint32_t(generation + i))
            .set(13, planeStart(now_))
            .set(14, planeStart(next))
            .set(15, newestIsLast_ ? 1 : 0);
        program.dispatchIndirect(steps_, std::size_t(i) * sizeof(Step), gl::Barrier::Storage);
        prepareToNote(note, i + 1, next, stamp_);
        note.set(10, i).set(11, std::uint32_t(generation + i));
        // Each expansion takes its tiles, and the newest voxels as texels, from the one before.
        note.dispatchIndirect(steps_, std::size_t(i) * sizeof(Step), gl::Barrier::All);
        now_ = next;
        newestIsLast_ = true;
    }
    const auto table = steps_.read<Step>(std::size_t(steps) + 1);
    carried_ = table.back().tiles.w;
    carriedUnmade_ = table.back().unmade.w;
    std::vector<std::uint64_t> grown;
    for (int i = 0; i < steps; ++i) {
        grown.push_back(table[std::size_t(i)].total());
    }
    return grown;
}

std::vector<std::uint64_t> Frontier::expand(SeedMap& seedMap, const Rules& rules, int generation, int steps) {
    VS_CHECK(steps >= 1 && steps <= kMaxSteps);
    const gl::Pass pass("expand region");
    if (generation + steps - 1 > SeedMap::kLongest16) {
        seedMap.widen();
    }
    if (!isValid_) {
        clearNewest();
    }
    begin(steps);
    allowed_.buffer().bindStorage(1);
    if (isValid_) {
        push(seedMap, added_, *rules.constraints);
        added_.clear();
    } else {
        collect(seedMap, rules);
        isValid_ = true;
    }

    gl::Program& allow =
        allow_.prepare(*rules.field, *rules.constraints,
                       rules.forbidden != nullptr ? gl::Defines{{"VS_FORBIDDEN", "1"}} : gl::Defines{});
    allow.set(0, seedMap.dims()).set(1, seedMap.bricks().brickDims());
    gl::Program& program = expand_.prepare(*rules.field, *rules.constraints, seedMap.widthDefines());
    seedMap.bind(program);
    allowed_.bindTexture(5);
    if (rules.forbidden != nullptr) {
        rules.forbidden->bindStorage(7);
    }
    return run(seedMap, program, &allow, *rules.constraints, generation, steps);
}

int Frontier::flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
                    const gl::TexelBuffer& region, const gl::Buffer& reached, int steps) {
    const gl::Pass pass("flood region");
    invalidate();
    clearNewest();
    const int atOnce = std::min(kMaxSteps, std::max(steps, 1));
    begin(atOnce);
    region.buffer().bindStorage(1);
    push(seedMap, seeds, *rules.constraints, Into::NewestWithin);
    reached.bindStorage(2); // and once more, into the set itself; the tiles are noted already
    push(seedMap, seeds, *rules.constraints, Into::PlaneWithin);
    newest_.buffer().bindStorage(2);

    gl::Program& program = expand_.prepare(*rules.field, *rules.constraints, {{"VS_FLOOD", "1"}});
    int found = 0;
    for (bool goesOn = steps > 0; goesOn;) {
        const int batch = std::min(atOnce, steps - found);
        seedMap.bind(program);
        reached.bindStorage(0);
        region.bindTexture(5);
        for (const std::uint64_t voxels : run(seedMap, program, nullptr, *rules.constraints, 0, batch)) {
            found += voxels > 0 ? 1 : 0;
            goesOn = voxels > 0;
        }
        goesOn = goesOn && found < steps;
        if (goesOn) {
            begin(std::min(atOnce, steps - found));
        }
    }
    carried_ = std::max(carried_, 1U); // the planes are not clean
    clearNewest();
    invalidate(); // tiles that the seeds lie in count as made
    return found;
}

} // namespace vs::segment
