// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "gl/texture.h"
#include "segment/growth/brick_table.h"
#include "segment/growth/growth_mirror.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vs::segment {

// The segment whose voxels have no label yet, and whether there are others.
struct Owner {
    std::uint8_t label = 1;
    bool hasOthers = false;
};

// Which voxels belong to segments, to which, and since which generation, on the device: one bit, one byte and
// 16 bits a voxel (of the grid filled up to whole bricks), and 8 bits more once generations above 65,535
// occur. shaders/words.glsl draws the layout. Labels lag behind: a grown voxel without one belongs to the
// segment at work. Internal to this folder.
class SeedMap {
public:
    static constexpr int kLongest16 = 0xffff;
    static constexpr int kLongest = 0xffffff;
    // Words of a plane: 32 voxels each.
    static constexpr std::size_t kWordsPerTile = 16;
    static constexpr std::size_t kWordsPerBrick = 1024;
    // A brick in the planes of grown voxels, of generations, and of their high bits.
    static constexpr std::size_t kGrownBytes = kWordsPerBrick * 4;
    static constexpr std::size_t kGenerationBytes = kWordsPerBrick * 64;
    static constexpr std::size_t kLateBytes = kWordsPerBrick * 32;

    // Makes an empty map of a grid. Throws GlError when the device has no room, or when there are more voxels
    // than lists can name.
    explicit SeedMap(glm::ivec3 dims, gl::Reach reach = gl::Reach::Device);

    // The bytes of a shared map on the host, laid out as on the device (gl::Buffer::shared()).
    struct Shared {
        std::uint32_t* grown = nullptr;
        std::uint16_t* generations = nullptr; // their lower 16 bits
        std::uint8_t* late = nullptr;         // and eight more; null where it is not wide

        [[nodiscard]] std::uint32_t generationAt(std::size_t i) const {
            return generations[i] | (late != nullptr ? std::uint32_t(late[i]) << 16U : 0U);
        }
        void setGeneration(std::size_t i, std::uint32_t generation) const {
            generations[i] = std::uint16_t(generation);
            if (late != nullptr) {
                late[i] = std::uint8_t(generation >> 16U);
            }
        }
    };
    [[nodiscard]] Shared shared() const;

    [[nodiscard]] glm::ivec3 dims() const { return dims_; }
    [[nodiscard]] std::size_t planeBytes() const; // of one bit a voxel, with the brick of zeros
    // A plane of zeros that the map's owner can reach as it can reach the map.
    [[nodiscard]] gl::Buffer makePlane(const std::string& label) const;
    [[nodiscard]] gl::TexelBuffer makeTexelPlane(const std::string& label) const; // R32UI
    [[nodiscard]] const gl::Buffer& grown() const { return grown_.buffer(); }
    // The grown voxels as texels of four words (RGBA32UI), which software renderers read many times faster.
    [[nodiscard]] const gl::TexelBuffer& grownTexels() const { return grown_; }
    [[nodiscard]] const gl::Texture& labels() const { return labels_; } // R8UI
    [[nodiscard]] BrickTable& bricks() { return bricks_; }
    [[nodiscard]] const BrickTable& bricks() const { return bricks_; }

    // Makes room for generations above kLongest16.
    void widen();
    [[nodiscard]] bool isWide() const { return bool(late_); }
    // The defines that shaders which include generations.glsl are to be compiled with.
    [[nodiscard]] gl::Defines widthDefines() const {
        return isWide() ? gl::Defines{{"VS_WIDE", "1"}} : gl::Defines{};
    }

    // Binds what words.glsl and generations.glsl read: storage 0 (grown), 3 and 4, image 0 (labels).
    void bind(gl::Program& program) const;
    // Binds what owners.glsl reads: texture 3.
    void bindOwner(gl::Program& program, const Owner& owner) const;
    // Runs a program with a row of groups a brick; the bricks are in storage 7 and their first one's place in
    // the uniform firstBrick.
    void dispatchOverBricks(gl::Program& program, std::span<const std::uint32_t> bricks, gl::Barrier after,
                            int groupsPerBrick = 16);
    // Puts a list of numbers into storage 7.
    void bindList(std::span<const std::uint32_t> numbers);

    // Where a voxel's bit is in a plane: bit % 32 of word bit / 32; and its number among the generations.
    [[nodiscard]] std::size_t bitOf(glm::ivec3 voxel) const {
        const Place place = placeOf(voxel);
        return (std::size_t(place.brick) * kWordsPerBrick + place.word) * 32 + place.bit;
    }

    // Gives listed voxels (linear indices) a generation and no label; 0: takes it away.
    void store(std::span<const std::uint32_t> voxels, int generation);
    // Labels the voxels of the segment at work in these bricks.
    void writeLabels(std::span<const std::uint32_t> bricks, const Owner& owner);

    // All there is about a brick, for undo.
    [[nodiscard]] std::vector<std::byte> saveBrick(std::uint32_t brick) const;
    void restoreBrick(std::uint32_t brick, std::span<const std::byte> bytes);
    // Makes of a list what saveBrick() would give of a brick that holds this.
    void layOut(std::uint32_t brick, const MirroredBrick& from, std::vector<std::byte>& bytes) const;
    // Whether so many bytes can be a brick's: with or without generations above kLongest16.
    [[nodiscard]] bool isBrick(std::uint32_t brick, std::size_t sizeBytes) const;

    // Downloads a plane (like grown()) as one byte a voxel of a box, x fastest.
    [[nodiscard]] std::vector<std::uint8_t> downloadPlane(const gl::Buffer& plane, const Box3& box) const;
    // Sets a plane's bits within a box from one byte a voxel; all others become zero.
    void uploadPlane(gl::Buffer& plane, const Box3& box, std::span<const std::uint8_t> inside) const;
    // Downloads the generations of a box; 0 where nothing has grown.
    [[nodiscard]] std::vector<std::uint32_t> downloadGenerations(const Box3& box) const;

    // What it takes on the device.
    [[nodiscard]] std::size_t deviceBytes() const;

    [[nodiscard]] std::uint32_t indexOf(glm::ivec3 voxel) const;
    [[nodiscard]] glm::ivec3 voxelAt(std::uint32_t index) const;

private:
    // Where a voxel's bit is: in which word of which brick.
    struct Place {
        std::uint32_t brick = 0;
        std::uint32_t word = 0;
        std::uint32_t bit = 0;
    };
    [[nodiscard]] Place placeOf(glm::ivec3 voxel) const;
    // Where the bit of a voxel of a brick is in the brick: wordAt() and bitOf() of shaders/words.glsl. Only
    // the lower five bits of its coordinates count.
    static constexpr std::uint32_t bitInBrick(glm::uvec3 v) {
        const std::uint32_t tile = (v.z & 24U) << 1U | (v.y & 24U) >> 1U | (v.x & 24U) >> 3U;
        const std::uint32_t word = (v.z & 6U) << 1U | (v.y & 4U) >> 1U | (v.x & 4U) >> 2U;
        return (tile << 4U | word) << 5U | (v.z & 1U) << 4U | (v.y & 3U) << 2U | (v.x & 3U);
    }
    void storeOnHost(std::span<const std::uint32_t> voxels, int generation);

    glm::ivec3 dims_;
    gl::Reach reach_;
    BrickTable bricks_;
    gl::TexelBuffer grown_;
    gl::Buffer generations_;
    gl::Buffer late_; // made by widen()
    gl::Texture labels_;
    gl::Buffer list_;
    gl::ProgramVariants store_{"segment/shaders/store_generation.comp"};
    gl::Program writeLabels_;
};

} // namespace vs::segment
