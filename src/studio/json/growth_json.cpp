// SPDX-License-Identifier: Apache-2.0
#include "studio/json/growth_json.h"

#include "base/value_json.h"
#include "field/field.h"

#include <limits>

namespace vs::studio {

namespace {

using segment::Constraints;
using segment::GenerationSpan;
using segment::GrowthSnapshot;
using segment::GrowthState;
using segment::GrowthUndo;
using segment::SavedBrick;

constexpr long kMostGenerations = 0xffffff; // that a seed map can hold
constexpr long kAnyVersion = std::numeric_limits<long>::max();

// Stands for the document's sculpture, which is not there yet.
const gl::Texture kSomeSculpture;

std::size_t voxelsOf(glm::ivec3 dims) { return Box3{glm::ivec3(0), dims}.volume(); }

std::size_t bricksIn(glm::ivec3 dims) { return Box3{glm::ivec3(0), divideUp(dims, field::kBrick)}.volume(); }

// --- rules and runs

void writeRange(Json& json, const char* name, const std::optional<Range>& range) {
    if (range) {
        json[name] = Json::array({range->lo, range->hi});
    }
}

Range rangeOf(const JsonReader& from) { return {from.at(0).number(), from.at(1).number()}; }

std::optional<Range> readRange(const JsonReader& from, const char* name) {
    return from.has(name) ? std::optional(rangeOf(from.member(name))) : std::nullopt;
}

Json writeRules(const Constraints& rules) {
    Json json{{"range", {rules.range.lo, rules.range.hi}},
              {"fenced", rules.sculpture != nullptr},
              {"sculptureVersion", rules.sculptureVersion},
              {"view", int(rules.view)},
              {"connectivity", rules.connectivity == segment::Connectivity::Six ? 6 : 26}};
    writeRange(json, "difference", rules.difference);
    writeRange(json, "gradient", rules.gradient);
    writeRange(json, "gradientDifference", rules.gradientDifference);
    return json;
}

Constraints readRules(const JsonReader& from) {
    Constraints rules;
    rules.range = rangeOf(from.member("range"));
    rules.difference = readRange(from, "difference");
    rules.gradient = readRange(from, "gradient");
    rules.gradientDifference = readRange(from, "gradientDifference");
    rules.sculpture = from.member("fenced").boolean() ? &kSomeSculpture : nullptr;
    rules.sculptureVersion = std::uint64_t(from.member("sculptureVersion").integerBetween(0, kAnyVersion));
    rules.view = field::SculptureView(from.member("view").integerBetween(0, 2));
    rules.connectivity = from.member("connectivity").integerBetween(6, 26) == 6
                             ? segment::Connectivity::Six
                             : segment::Connectivity::TwentySix;
    return rules;
}

Json writeRun(StateWriter& file, const GrowthState& run) {
    return {{"playhead", run.playhead},
            {"extent", run.extent},
            {"finished", run.isFinished},
            {"voxels", file.list(run.voxels)},
            {"rules", writeRules(run.constraints)},
            {"live", run.isLive},
            {"consistentFrom", run.consistentFrom == GrowthState::kNever ? -1 : run.consistentFrom},
            {"frozen", run.frozen},
            {"seeds", file.shared(run.seeds)}};
}

// Earlier programs wrote whether all that had grown by then could be reached.
int readConsistentFrom(const JsonReader& from, int extent) {
    const long first = from.has("consistent") ? (from.member("consistent").boolean() ? extent : -1)
                                              : from.member("consistentFrom").integerBetween(-1, extent);
    return first < 0 ? GrowthState::kNever : int(first);
}

GrowthState readRun(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    GrowthState run;
    run.extent = int(from.member("extent").integerBetween(0, kMostGenerations));
    run.playhead = int(from.member("playhead").integerBetween(0, run.extent));
    run.isFinished = from.member("finished").boolean();
    run.voxels = file.list<std::uint64_t>(from.member("voxels"), std::size_t(run.extent));
    if (run.voxels.size() != std::size_t(run.extent)) {
        from.member("voxels").fail("must have as many numbers as there are generations");
    }
    run.constraints = readRules(from.member("rules"));
    run.isLive = from.member("live").boolean();
    run.consistentFrom = readConsistentFrom(from, run.extent);
    run.frozen = int(from.member("frozen").integerBetween(0, kMostGenerations));
    // A seed can be named again and again, but hardly more often than there are voxels.
    run.seeds = file.shared<segment::Seed>(from.member("seeds"), 2 * voxelsOf(dims));
    for (const segment::Seed& seed : *run.seeds) {
        if (seed.voxel >= voxelsOf(dims)) {
            from.member("seeds").fail("must be voxels of the volume");
        }
    }
    return run;
}

// --- bricks

// How a brick stands in a list: all but its bytes, which follow one another in a block.
struct ListedBrick {
    std::uint32_t brick = 0;
    GenerationSpan span;
    std::uint32_t size = 0;
    std::uint32_t compressed = 0;
};

Json writeBricks(StateWriter& file, const std::vector<SavedBrick>& bricks) {
    std::vector<ListedBrick> list;
    std::vector<std::byte> bytes;
    for (const SavedBrick& brick : bricks) {
        list.push_back(
            {brick.brick, brick.span, std::uint32_t(brick.size), std::uint32_t(brick.compressed.size())});
        bytes.insert(bytes.end(), brick.compressed.begin(), brick.compressed.end());
    }
    return {{"list", file.list(list)}, {"bytes", file.block(bytes)}};
}

std::vector<SavedBrick> readBricks(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    // An undo record may have a brick more than once, as often as it was changed by one operation.
    constexpr std::size_t mostOften = 256;
    const auto list = file.list<ListedBrick>(from.member("list"), mostOften * bricksIn(dims));
    const auto bytes = file.block(from.member("bytes"));
    std::vector<SavedBrick> bricks;
    std::size_t at = 0;
    for (const ListedBrick& listed : list) {
        // Without compression a brick has less than 8 bytes a voxel.
        constexpr std::size_t mostBytes = std::size_t(8) * field::kBrick * field::kBrick * field::kBrick;
        if (listed.brick >= bricksIn(dims) || listed.size > mostBytes ||
            listed.compressed > bytes.size() - at) {
            from.fail("must be bricks of the volume");
        }
        const auto begin = bytes.begin() + std::ptrdiff_t(at);
        bricks.push_back(
            {listed.brick, listed.span, listed.size, {begin, begin + std::ptrdiff_t(listed.compressed)}});
        at += listed.compressed;
    }
    return bricks;
}

std::vector<std::uint32_t> readVoxels(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    auto voxels = file.list<std::uint32_t>(from, voxelsOf(dims));
    for (const std::uint32_t voxel : voxels) {
        if (voxel >= voxelsOf(dims)) {
            from.fail("must be voxels of the volume");
        }
    }
    return voxels;
}

} // namespace

// --- what growth holds

nlohmann::ordered_json stored(StateWriter& file, const GrowthSnapshot& growth) {
    Json others = Json::array();
    for (const auto& [label, run] : growth.others) {
        others.push_back({{"label", int(label)},
                          {"run", writeRun(file, run.state)},
                          {"spans", file.list(run.spans)},
                          {"forbidden", file.block(run.forbidden)}});
    }
    return {{"label", int(growth.label)},
            {"run", writeRun(file, growth.atWork.state)},
            {"forbidden", file.block(growth.atWork.forbidden)},
            {"others", std::move(others)},
            {"bricks", writeBricks(file, growth.bricks)}};
}

GrowthSnapshot readGrowth(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    GrowthSnapshot growth;
    growth.label = std::uint8_t(from.member("label").integerBetween(1, 255));
    growth.atWork.state = readRun(file, from.member("run"), dims);
    growth.atWork.forbidden = file.block(from.member("forbidden"));
    const JsonReader others = from.member("others");
    for (std::size_t i = 0; i < others.size(); ++i) {
        const JsonReader other = others.at(i);
        GrowthSnapshot::Run run;
        run.state = readRun(file, other.member("run"), dims);
        run.spans = file.list<GenerationSpan>(other.member("spans"), bricksIn(dims));
        run.forbidden = file.block(other.member("forbidden"));
        const auto label = std::uint8_t(other.member("label").integerBetween(1, 255));
        if (label == growth.label || !growth.others.emplace(label, std::move(run)).second) {
            other.member("label").fail("must not be that of another segment");
        }
    }
    growth.bricks = readBricks(file, from.member("bricks"), dims);
    return growth;
}

nlohmann::ordered_json stored(StateWriter& file, const GrowthUndo& undo) {
    const GrowthUndo::Content& held = undo.content();
    return {{"before", writeRun(file, held.before)},
            {"labels", {int(held.labelBefore), int(held.labelAfter)}},
            {"extentAfter", held.extentAfter},
            {"added", file.list(held.addedSeeds)},
            {"allowedAgain", file.list(held.allowedAgain)},
            {"bricks", writeBricks(file, held.saved)},
            {"changesForbidden", held.changesForbidden},
            {"forbidden", file.block(held.forbidden)}};
}

GrowthUndo readGrowthUndo(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    GrowthUndo::Content held;
    held.before = readRun(file, from.member("before"), dims);
    held.labelBefore = std::uint8_t(from.member("labels").at(0).integerBetween(1, 255));
    held.labelAfter = std::uint8_t(from.member("labels").at(1).integerBetween(1, 255));
    held.extentAfter = int(from.member("extentAfter").integerBetween(0, kMostGenerations));
    held.addedSeeds = readVoxels(file, from.member("added"), dims);
    held.allowedAgain = readVoxels(file, from.member("allowedAgain"), dims);
    held.saved = readBricks(file, from.member("bricks"), dims);
    held.changesForbidden = from.member("changesForbidden").boolean();
    held.forbidden = file.block(from.member("forbidden"));
    return GrowthUndo(std::move(held));
}

} // namespace vs::studio
