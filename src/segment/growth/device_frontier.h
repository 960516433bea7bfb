// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "segment/growth/frontier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// Expands on the device, 128 voxels at a time: only tiles of 8^3 voxels that something may happen in are
// looked at. While little grows, voxels are tested as they are offered; once much does, rows of four tiles
// are tested whole when the set first comes near them, which is quicker a voxel. Beside the seed map it keeps
// three bits a voxel: which voxels the rules let in, and the newest of two generations. Internal to this
// folder.
class DeviceFrontier final : public Frontier {
public:
    // Makes room for a seed map's grid. Throws GlError when there is none on the device.
    explicit DeviceFrontier(const SeedMap& seedMap);

    std::vector<SeedAnswer> testSeeds(SeedMap& seedMap, const Rules& rules, int playhead,
                                      std::span<const std::uint32_t> voxels) override;
    void invalidate() override;
    void add(std::span<const std::uint32_t> voxels) override;
    std::vector<std::uint64_t> expand(SeedMap& seedMap, const Rules& rules, int generation,
                                      int expansions) override;
    [[nodiscard]] int mostExpansions() const override { return kMaxExpansions; }
    int flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
              const gl::TexelBuffer& region, const gl::Buffer& reached, int expansions) override;
    [[nodiscard]] std::size_t bytes() const override {
        return allowed_.buffer().size() + newest_.buffer().size() + work_.size() + expansions_.size() +
               list_.size() + answers_.size();
    }

private:
    // The most expansions in one submission.
    static constexpr int kMaxExpansions = 128;

    struct Expansion;
    enum class Testing { ByVoxel, ByRows };

    void clearNewest();
    [[nodiscard]] std::uint32_t planeStart(int plane) const;
    void collect(SeedMap& seedMap, const Rules& rules);
    // Where voxels are put: into the newest; or into the newest or a plane in storage 2, but only what lies
    // in the plane in storage 1.
    enum class Into { Newest, NewestWithin, PlaneWithin };
    void push(const SeedMap& seedMap, std::span<const std::uint32_t> voxels, const Constraints& constraints,
              Into into = Into::Newest);
    void prepareToNote(gl::Program& program, int expansion, int list, std::uint32_t stamp) const;
    void begin(int expansions);
    void goOverToRows(const SeedMap& seedMap);
    void judge(const Expansion& last, int expansions);
    std::vector<std::uint64_t> run(const SeedMap& seedMap, gl::Program& program, gl::Program* allow,
                                   const Constraints& constraints, gl::Defines noteDefines, int generation,
                                   int expansions);

    std::uint32_t tileCount_;
    std::size_t planeWords_;
    gl::TexelBuffer allowed_;
    gl::TexelBuffer newest_; // two planes
    gl::Buffer work_;        // see shaders/active_tiles.glsl
    gl::Buffer expansions_;
    gl::Buffer answers_; // about seeds
    gl::Buffer list_;    // voxel numbers on their way to the device
    std::vector<std::uint32_t> added_;
    std::uint32_t rulesNumber_ = 1;
    std::uint32_t stamp_ = 0;         // of the last expansion
    int now_ = 0;                     // which plane holds the newest voxels, and which list their tiles
    std::uint32_t carried_ = 0;       // tiles in it
    std::uint32_t carriedUnmade_ = 0; // rows of tiles
    bool isValid_ = false;
    bool isAtWork_ = false; // still so where something was thrown: what was begun is not finished
    Testing testing_ = Testing::ByVoxel;
    bool growsMuch_ = false;      // enough for rows
    int expansionsByVoxel_ = 0;   // tried since the rules changed; the next submission tries as many
    bool isOver_ = false;         // nothing grew at last
    bool newestIsLast_ = false;   // the newest voxels have the generation before the next; else any
    bool newestIsRegion_ = false; // the newest voxels are the whole region's

    ConstrainedProgram testSeeds_{"segment/shaders/test_seeds.comp"};
    ConstrainedProgram allow_{"segment/shaders/allow_tiles.comp"};
    ConstrainedProgram expand_{"segment/shaders/expand_tiles.comp"};
    gl::ProgramVariants collect_{"segment/shaders/collect_region.comp"};
    gl::ProgramVariants push_{"segment/shaders/push_voxels.comp"};
    gl::ProgramVariants note_{"segment/shaders/note_tiles.comp"};
    gl::ProgramVariants noteRows_{"segment/shaders/note_rows.comp"};
};

} // namespace vs::segment
