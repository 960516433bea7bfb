// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_overlay.h"
#include "field/bricks/brick_pool.h"
#include "field/bricks/brick_reader.h"
#include "field/bricks/brick_table.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"
#include "gl/shader_source.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vs::field {

// What shaders need to know of the level whose bricks they see; mirrors BricksBlock in
// field/shaders/bricks.glsl (std140).
struct BricksBlock {
    glm::vec4 levelScale{1};   // xyz: place in the level = place in the scene * this, w: steps of the scene
                               // in one of the level
    glm::vec4 levelOrigin{0};  // xyz: + this, w: 1 / side of a brick
    glm::ivec4 levelDims{1};   // xyz: voxels of the level, w: side of a brick
    glm::ivec4 brickCounts{1}; // xyz: bricks, w: all of them
    glm::vec4 poolScale{1};    // xyz: 1 / texels of the pool, w: texels of a slot
    glm::vec4 brickValue{1};   // x scale, y offset
    glm::ivec4 brickCells{1};  // xy: slots of the pool, z: where ranges of cells begin, w: cells of a brick
                               // along each axis, 0 if theirs are not there
};
inline constexpr gl::BlockMember kBricksBlockMembers[] = {
    VS_BLOCK_MEMBER(BricksBlock, levelScale), VS_BLOCK_MEMBER(BricksBlock, levelOrigin),
    VS_BLOCK_MEMBER(BricksBlock, levelDims),  VS_BLOCK_MEMBER(BricksBlock, brickCounts),
    VS_BLOCK_MEMBER(BricksBlock, poolScale),  VS_BLOCK_MEMBER(BricksBlock, brickValue),
    VS_BLOCK_MEMBER(BricksBlock, brickCells)};
inline constexpr gl::BlockLayout kBricksBlockLayout{"BricksBlock", sizeof(BricksBlock), kBricksBlockMembers};
static_assert(isWhole(kBricksBlockLayout));

struct DetailOptions {
    std::size_t deviceBytes = std::size_t(256) << 20; // that bricks may take on the device
    std::size_t hostBytes = std::size_t(256) << 20;   // and values of bricks on the host
    int side = 64;                                    // voxels of a brick along each axis
    int threads = 2;                                  // that read
    // What the finest level holds is known voxel by voxel, and the macrocells say it.
    bool areRangesKnown = false;
    // The scene's own resolution is looked up in bricks too, for tests.
    bool hasOwnLevel = false;
};

// What levels of a scan hold that are finer than its scene: pictures at rest are drawn from them. Bricks of
// any of them share a pool on the device, which grows with what is looked at. A program that is compiled with
// BRICKS looks up bricks of one level (use()); it notes which ones it came through, and where one is not
// there it takes the scene's own value and remembers that it did. Who dispatched it then asks for what was
// missing, and dispatches again what is not exact when that has come. Of bricks that have been read it is
// known what values they hold, and of those on the device also where: rays go past what cannot be seen, and
// need not have it. All calls but the reader's own threads need a current context.
class Detail {
public:
    // Levels of `source` that are finer than the scene's grid and lie as it does. Throws Error where there is
    // none, and GlError where the device has no room for the pool.
    Detail(const std::shared_ptr<const volume::BrickSource>& source, const volume::GridGeometry& scene,
           const DetailOptions& options);

    // The coarsest level whose voxels are no larger than a pixel of so many steps of the scene, along all
    // axes that finer ones divide more finely, or the finest; nothing: the scene's own voxels are no larger.
    [[nodiscard]] std::optional<int> levelFor(double pixelSteps) const;
    // The next; nothing: the scene's own voxels come next.
    [[nodiscard]] std::optional<int> coarserThan(int level) const;

    // Shaders see this level from now on.
    void use(int level);
    [[nodiscard]] int level() const { return level_; }
    // The finest that can be used.
    [[nodiscard]] int finest() const { return finest_; }
    // Whether its voxels are smaller than the scene's.
    [[nodiscard]] bool isFiner() const { return grids_[std::size_t(level_)].isFiner(); }
    // One of its steps, in steps of the scene: 0.25 for a level four times as fine.
    [[nodiscard]] double step() const { return grids_[std::size_t(level_)].step; }
    // Whether rays should go by what bricks hold (programs compiled with BRICK_RANGES), and not only by
    // macrocells of so many voxels of the scene along each axis: where these do not know it, or are much
    // larger than the cells of bricks.
    [[nodiscard]] bool hasTellingRanges(int macrocell) const;
    // Which layers a program looks up besides.
    struct Layers {
        bool hasCuts = false;
        bool hasSegments = false;
    };
    // What such a program is compiled with, but for BRICK_RANGES: BRICKS, FINER, FINER_CUTS, FINER_SEGMENTS.
    void addDefines(const Layers& layers, gl::Defines& defines) const;
    // FINER_SEGMENTS: how many kinds of segments the layer tells apart, 2 with translucent ones.
    [[nodiscard]] std::string segmentKinds() const;
    // Binds uniform block 4, textures 6 and 12 and storage 6: see field/shaders/bricks.glsl; of layers also
    // textures 15 (cuts) and 4 (segments), with what lies over the bricks now.
    void bind(const Layers& layers);

    // What lies over the scan in a layer is that from now on, as of that version of it; `changedSince` says
    // in which box of the finest level's voxels it may differ from what it was at another one.
    void lay(BrickLayer layer, const std::shared_ptr<const BrickOverlay>& overlay, std::uint64_t version,
             const std::function<Box3(std::uint64_t)>& changedSince);
    [[nodiscard]] std::uint64_t laidVersion(BrickLayer layer) const { return overIn(layer).version; }
    // Whether there is room for a layer on the device; else failures() tells.
    [[nodiscard]] bool hasOverlay(BrickLayer layer) const { return bool(pool_.overlay(layer)); }

    // After a dispatch: asks for what it missed, what is nearest to the viewer first, whose place in the
    // scene's voxel space that is. Returns how many bricks are missing.
    std::size_t endRound(glm::dvec3 viewerVoxel);
    // Puts what was read in its place, waiting up to so long for something. Returns whether anything changed.
    bool deliver(double waitMs);
    // Bricks that are being waited for.
    [[nodiscard]] std::size_t coming() const { return reader_.outstanding(); }
    // The last round used more bricks than there is room for.
    [[nodiscard]] bool isFull() const { return isFull_; }

    // Lines about what pictures show coarser than their pixels ask for, each once: bricks that could not be
    // read, and what there was no room for.
    [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }
    void tell(const std::string& line);

    [[nodiscard]] const std::vector<BrickGrid>& grids() const { return grids_; }
    [[nodiscard]] std::size_t deviceBytes() const;
    [[nodiscard]] std::size_t hostBytes() const { return reader_.cachedBytes(); }
    [[nodiscard]] std::size_t bricksRead() const { return bricksRead_; }

private:
    [[nodiscard]] bool isFineEnough(glm::dvec3 spacing, double pixelSteps) const;
    [[nodiscard]] bool reaches(const BrickKey& key, const Box3& finest) const;
    void layOver(BrickLayer layer, const BrickKey& key);
    void layOverAll(BrickLayer layer);
    void makeRoomFor(BrickLayer layer);
    [[nodiscard]] LayerFormats layerFormats() const;
    void remakePool(const LayerFormats& formats);
    void growPool();
    [[nodiscard]] bool hasLostPool() const;
    void place(const ReadBrick& brick);
    void show();
    void writeBlock();

    std::vector<BrickGrid> grids_; // of the source's levels that are used, the finest first
    BrickReader reader_;
    BrickTexels texels_;
    DetailOptions options_;
    std::size_t poolBytes_; // that the pool may have for now
    BrickPool pool_;
    BrickTable table_;
    struct Laid {
        std::shared_ptr<const BrickOverlay> overlay;
        std::uint64_t version = 0;
    };
    struct Over {
        std::shared_ptr<const BrickOverlay> overlay; // null: nothing lies over the bricks
        std::uint64_t version = 0;
        std::function<Box3(std::uint64_t)> changedSince;
        std::map<BrickKey, Laid> laid; // over the bricks of the pool
        Laid laidOverAll;              // over all of the level in use that are in the pool
    };
    OfBrickLayers<Over> over_;
    [[nodiscard]] const Over& overIn(BrickLayer layer) const { return over_[std::size_t(layer)]; }
    [[nodiscard]] Over& overIn(BrickLayer layer) { return over_[std::size_t(layer)]; }
    gl::Buffer block_;
    std::set<BrickKey> failed_;
    std::vector<std::string> failures_;
    std::size_t bricksRead_ = 0;
    int level_ = -1;
    int finest_ = 0;       // level of which a page table has room for all bricks
    bool isShown_ = false; // shaders see where bricks of the level in use are
    bool isFull_ = false;
};

} // namespace vs::field
