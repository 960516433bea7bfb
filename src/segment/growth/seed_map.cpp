// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/seed_map.h"

#include "base/error.h"
#include "field/field.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace vs::segment {

namespace {

constexpr std::size_t kSlabBytes = 16;

glm::ivec3 checked(glm::ivec3 dims) {
    if (double(dims.x) * dims.y * dims.z > double(std::numeric_limits<std::uint32_t>::max())) {
        throw GlError("{} x {} x {} voxels are more than growing can name (4,294,967,295); use a smaller "
                      "volume",
                      dims.x, dims.y, dims.z);
    }
    return dims;
}

} // namespace

SeedMap::SeedMap(glm::ivec3 dims, gl::Reach reach)
    : dims_(checked(dims)), reach_(reach), bricks_(dims),
      grown_(planeBytes() / kSlabBytes, gl::Format::RGBA32UI, "grown voxels", reach),
      generations_(planeBytes() * 16, "generations", reach),
      labels_(dims, gl::Format::R8UI, gl::Filter::Nearest, "segment labels"), list_(4, "growth list"),
      writeLabels_("segment/shaders/write_labels.comp") {}

std::size_t SeedMap::planeBytes() const {
    return (bricks_.count() + 1) * SeedMap::kWordsPerBrick * sizeof(std::uint32_t);
}

void SeedMap::widen() {
    if (!isWide()) {
        late_ = gl::Buffer(planeBytes() * 8, "late generations", reach_);
    }
}

SeedMap::Shared SeedMap::shared() const {
    return {reinterpret_cast<std::uint32_t*>(grown_.buffer().shared().data()),
            reinterpret_cast<std::uint16_t*>(generations_.shared().data()),
            isWide() ? reinterpret_cast<std::uint8_t*>(late_.shared().data()) : nullptr};
}

gl::Buffer SeedMap::makePlane(const std::string& label) const { return {planeBytes(), label, reach_}; }

gl::TexelBuffer SeedMap::makeTexelPlane(const std::string& label) const {
    return {planeBytes() / sizeof(std::uint32_t), gl::Format::R32UI, label, reach_};
}

void SeedMap::bind(gl::Program& program) const {
    grown_.buffer().bindStorage(kGrownStorage);
    generations_.bindStorage(kGenerationsStorage);
    (isWide() ? late_ : generations_).bindStorage(kLateGenerationsStorage);
    labels_.bindImage(kLabelsImage, gl::Access::ReadWrite);
    program.set("dims", dims_).set("brickDims", bricks_.brickDims());
}

void SeedMap::bindOwner(gl::Program& program, const Owner& owner) const {
    labels_.bindTexture(kLabelTexture);
    program.set("activeLabel", std::uint32_t(owner.label)).set("hasOthers", owner.hasOthers ? 1 : 0);
}

void SeedMap::bindList(std::span<const std::uint32_t> numbers) {
    list_.reserve(numbers.size() * sizeof(std::uint32_t));
    list_.write(numbers);
    list_.bindStorage(kBricksStorage);
}

void SeedMap::dispatchOverBricks(gl::Program& program, std::span<const std::uint32_t> bricks,
                                 gl::Barrier after, int groupsPerBrick) {
    bindList(bricks);
    for (std::size_t first = 0; first < bricks.size(); first += gl::kMaxGroups) {
        program.set("firstBrick", int(first));
        program.dispatch(
            {groupsPerBrick, int(std::min<std::size_t>(gl::kMaxGroups, bricks.size() - first)), 1}, after);
    }
}

void SeedMap::store(std::span<const std::uint32_t> voxels, int generation) {
    if (generation > kLongest16) {
        widen();
    }
    if (reach_ == gl::Reach::Shared && generation > 0) { // what has not grown has no label
        storeOnHost(voxels, generation);
        return;
    }
    gl::Program& program = store_.with(widthDefines());
    bind(program);
    bindList(voxels);
    program.set("count", int(voxels.size())).set("generation", std::uint32_t(generation));
    program.dispatchOverList(voxels.size(), gl::Barrier::All);
}

void SeedMap::storeOnHost(std::span<const std::uint32_t> voxels, int generation) {
    gl::Buffer::waitForDevice();
    const Shared map = shared();
    for (const std::uint32_t voxel : voxels) {
        const std::size_t bit = bitOf(voxelAt(voxel));
        map.grown[bit / 32] |= 1U << bit % 32;
        map.setGeneration(bit, std::uint32_t(generation));
    }
}

void SeedMap::writeLabels(std::span<const std::uint32_t> bricks, const Owner& owner) {
    bind(writeLabels_);
    bindOwner(writeLabels_, owner);
    dispatchOverBricks(writeLabels_, bricks, gl::Barrier::All); // grown voxels, read here, change next
}

std::vector<std::byte> SeedMap::saveBrick(std::uint32_t brick) const {
    const std::size_t late = isWide() ? kLateBytes : 0;
    std::vector<std::byte> bytes(kGrownBytes + kGenerationBytes + late);
    const std::span<std::byte> all(bytes);
    grown_.buffer().read(all.first(kGrownBytes), brick * kGrownBytes);
    generations_.read(all.subspan(kGrownBytes, kGenerationBytes), brick * kGenerationBytes);
    if (isWide()) {
        late_.read(all.last(late), brick * kLateBytes);
    }
    const auto labels = labels_.download(bricks_.box(brick));
    bytes.insert(bytes.end(), labels.begin(), labels.end());
    return bytes;
}

bool SeedMap::isBrick(std::uint32_t brick, std::size_t sizeBytes) const {
    const std::size_t least = kGrownBytes + kGenerationBytes + bricks_.box(brick).volume();
    return sizeBytes == least || sizeBytes == least + kLateBytes;
}

void SeedMap::restoreBrick(std::uint32_t brick, std::span<const std::byte> bytes) {
    const std::size_t labelBytes = bricks_.box(brick).volume();
    const bool hasLate = bytes.size() > kGrownBytes + kGenerationBytes + labelBytes;
    grown_.buffer().write(bytes.first(kGrownBytes), brick * kGrownBytes);
    generations_.write(bytes.subspan(kGrownBytes, kGenerationBytes), brick * kGenerationBytes);
    if (hasLate) {
        widen();
        late_.write(bytes.subspan(kGrownBytes + kGenerationBytes, kLateBytes), brick * kLateBytes);
    } else if (isWide()) {
        late_.clear(brick * kLateBytes, kLateBytes);
    }
    const auto labels = bytes.last(labelBytes);
    labels_.upload(bricks_.box(brick), std::vector<std::byte>(labels.begin(), labels.end()));
}

SeedMap::Place SeedMap::placeOf(glm::ivec3 voxel) const {
    const std::uint32_t bit = bitInBrick(glm::uvec3(voxel));
    return {bricks_.brickOf(voxel), bit / 32, bit % 32};
}

std::vector<std::uint8_t> SeedMap::downloadPlane(const gl::Buffer& plane, const Box3& box) const {
    std::vector<std::uint8_t> inside(box.volume(), 0);
    forEachVoxel(bricksAround(box), [&](glm::ivec3 brickPlace, std::size_t) {
        const std::uint32_t brick = bricks_.brickOf(brickPlace * field::kBrick);
        const auto words =
            plane.read<std::uint32_t>(SeedMap::kWordsPerBrick, std::size_t(brick) * kGrownBytes);
        forEachVoxel(intersect(bricks_.box(brick), box), [&](glm::ivec3 v, std::size_t) {
            const Place place = placeOf(v);
            inside[indexIn(box, v)] = words[place.word] >> place.bit & 1U;
        });
    });
    return inside;
}

void SeedMap::uploadPlane(gl::Buffer& plane, const Box3& box, std::span<const std::uint8_t> inside) const {
    std::vector<std::uint32_t> words(planeBytes() / sizeof(std::uint32_t), 0);
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t i) {
        const Place place = placeOf(v);
        words[std::size_t(place.brick) * SeedMap::kWordsPerBrick + place.word] |= (inside[i] != 0 ? 1U : 0U)
                                                                                  << place.bit;
    });
    plane.write(std::span<const std::uint32_t>(words));
}

std::vector<std::uint32_t> SeedMap::downloadGenerations(const Box3& box) const {
    std::vector<std::uint32_t> values(box.volume(), 0);
    forEachVoxel(bricksAround(box), [&](glm::ivec3 brickPlace, std::size_t) {
        const std::uint32_t brick = bricks_.brickOf(brickPlace * field::kBrick);
        if (!bricks_.isOccupied(brick)) {
            return;
        }
        const auto grown = grown_.buffer().read<std::uint32_t>(SeedMap::kWordsPerBrick, brick * kGrownBytes);
        const auto low =
            generations_.read<std::uint16_t>(SeedMap::kWordsPerBrick * 32, brick * kGenerationBytes);
        const auto late = isWide()
                              ? late_.read<std::uint8_t>(SeedMap::kWordsPerBrick * 32, brick * kLateBytes)
                              : std::vector<std::uint8_t>();
        forEachVoxel(intersect(bricks_.box(brick), box), [&](glm::ivec3 v, std::size_t) {
            const Place place = placeOf(v);
            const std::size_t i = place.word * 32 + place.bit;
            if ((grown[place.word] >> place.bit & 1U) != 0) {
                values[indexIn(box, v)] = low[i] | (late.empty() ? 0U : std::uint32_t(late[i]) << 16U);
            }
        });
    });
    return values;
}

std::size_t SeedMap::deviceBytes() const {
    const glm::i64vec3 dims(dims_);
    return grown_.buffer().size() + generations_.size() + late_.size() + bricks_.onDevice().size() +
           list_.size() + std::size_t(dims.x * dims.y * dims.z);
}

std::uint32_t SeedMap::indexOf(glm::ivec3 v) const {
    return (std::uint32_t(v.z) * std::uint32_t(dims_.y) + std::uint32_t(v.y)) * std::uint32_t(dims_.x) +
           std::uint32_t(v.x);
}

glm::ivec3 SeedMap::voxelAt(std::uint32_t index) const {
    const glm::uvec3 dims(dims_);
    return {int(index % dims.x), int(index / dims.x % dims.y), int(index / (dims.x * dims.y))};
}

} // namespace vs::segment
