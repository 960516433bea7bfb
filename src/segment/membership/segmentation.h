// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "segment/membership/apart_tiles.h"
#include "segment/membership/continuation.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace vs::segment {

// How a segment is to be seen: what is translucent is drawn with glass (render/colours/segment_colours.h).
enum class Look : std::uint8_t { Hidden = 0, Opaque = 1, Translucent = 2 };
using Looks = std::array<Look, 256>; // by label
Looks allOpaque();

// Smooth: the region radiated by a Gaussian. Plain: 1 inside and 0 outside, for scrubbing; what was updated
// so is smoothed by the next smooth update.
enum class Smoothing { Plain, Smooth };

// The anti-aliased segments as renderer and surface extraction see them: the voxels shown by a Growth,
// convolved with a separable Gaussian (sigma R/3 steps with R = 3, the same in mm along all axes; nothing
// lies outside the grid), then held to the truth by mirroring at 0.5: at least 0.5 at each shown voxel's
// centre, below 0.5 at every other. The surface is its 0.5 level. Behind a fence that ended a segment it goes
// on for some voxels that are not the segment's (segment/membership/continuation.h).
class Segmentation {
public:
    // Throws GlError when the device has no room: 1 byte and 1 bit a voxel, another bit once there has been a
    // fence, as much again while there are translucent segments, and 12 MiB of scratch.
    explicit Segmentation(const volume::GridGeometry& geometry);

    // Brings the volume up to date with what `growth` shows of segments that are not hidden, always the same
    // growth. Cost follows the number of tiles of 16^3 voxels around which membership changed. Smoothing ends
    // when it has taken `budgetMs`, but not before the first tiles: what changed first is smoothed first, and
    // the rest stays as it was until the next update; with no budget at all everything does. `fence` is what
    // the picture does not show. Returns the box of voxels rewritten.
    Box3 update(const Growth& growth, Smoothing smoothing = Smoothing::Smooth,
                const Looks& looks = allOpaque(), double budgetMs = kNoHurry, const Fence& fence = {});
    static constexpr double kNoHurry = 1e30;

    // Which segments, by their labels, the next updates also keep alone, as if no other were shown: a bit a
    // voxel for all of them, 4 bytes a tile for each, and about a byte a voxel of tiles in which others touch
    // one.
    void keepApart(const std::vector<std::uint8_t>& labels);
    // Their tiles, which field/shaders/one_segment.glsl reads. Null unless some are kept.
    [[nodiscard]] const ApartTiles* apart() const { return apart_ ? &*apart_ : nullptr; }

    // Whether the last update was cut short.
    [[nodiscard]] bool isBehind() const { return isBehind_; }

    // Whether some of it may be no segment's: what goes on behind cuts.
    [[nodiscard]] bool goesOnBehindCuts() const { return continuation_.has_value(); }

    // R8, linear filter, values in [0, 1]: the opaque segments together. RG8 while there are translucent
    // ones: those together in g.
    [[nodiscard]] const gl::Texture& texels() const { return texels_; }
    // RG32F, smallest and largest value of each macrocell, as field::CellRangeUpdater makes them; after a
    // plain update 0 and 1 where something has changed.
    [[nodiscard]] const gl::Texture& cells() const { return cells_; }
    // The membership, downloaded, x fastest.
    [[nodiscard]] std::vector<float> values() const;
    // What it takes on the device at the moment.
    [[nodiscard]] std::size_t deviceBytes() const;
    // How the segments look that it shows.
    [[nodiscard]] const Looks& looks() const { return looks_; }
    // Counts the updates that changed something that pictures show: memberships, whose voxels are, or what is
    // kept apart.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    // The voxels that may differ from what they were at an earlier version(), at 0 from those of no segment,
    // while the looks are the same.
    [[nodiscard]] Box3 changedSince(std::uint64_t version) const;

    // Voxels along an edge of the tiles that an update rewrites.
    static constexpr int kTile = 16;

    using Labels = std::array<std::uint32_t, 8>; // a bit for each

private:
    // One for the opaque segments, one for the translucent ones.
    struct Channel {
        gl::Buffer shown;  // one bit a voxel, laid out as in shaders/words.glsl
        gl::Buffer turned; // one bit a voxel: counts as the opposite; made with the continuation
        gl::Buffer owners; // a number for each word of `shown`: see shaders/show_rows.comp; made with apart_
        std::vector<Labels> labels; // that reach each tile; made with apart_
        // Per tile: which of its 27 neighbours (itself included) changes there reach and that are not
        // smoothed yet, bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1).
        std::vector<std::uint32_t> pending;
        std::deque<std::uint32_t> queue; // tiles to smooth, the oldest first
        std::vector<bool> isQueued;      // by tile
        std::vector<std::uint32_t> owed; // bricks in which segments are to be continued before that
    };

    struct Of { // all segments together, or one of them alone
        std::uint8_t label = 0;
        bool isApart = false;
    };

    void takeLooks(const Looks& looks);
    std::vector<std::uint32_t> bringUpToDate(const Growth& growth, Smoothing smoothing, const Looks& looks,
                                             double budgetMs, const Fence& fence);
    void startAnew();
    std::vector<std::uint32_t> show(const Growth& growth, int channel,
                                    const std::vector<std::uint32_t>& bricks);
    std::vector<std::uint32_t> staleBehind(const Growth& growth, const Fence& fence,
                                           const std::vector<std::uint32_t>& changed);
    std::vector<std::uint32_t> goOnBehind(const Growth& growth, const Fence& fence, Channel& channel,
                                          const std::vector<std::uint32_t>& bricks);
    void clearReach(const std::vector<std::uint32_t>& bricks);
    std::vector<std::uint32_t> takeReach(const BrickTable& table, Channel& channel,
                                         const std::vector<std::uint32_t>& bricks);
    void bindMembers(const Channel& channel, const Of& what) const;
    void queueTiles(Channel& channel) const;
    static void owe(Channel& channel, const std::vector<std::uint32_t>& bricks);
    void continueOwed(const Growth& growth, const Fence& fence, Channel& channel, std::size_t tiles);
    std::vector<std::uint32_t> smoothQueued(const Growth& growth, const Fence& fence, int channel,
                                            double budgetMs);
    void write(int channel, const std::vector<std::uint32_t>& tiles, Smoothing smoothing);
    // Tiles smoothed at a time: 512 take 1 MiB of bits and 11 MiB of values.
    static constexpr std::uint32_t kTilesAtOnce = 512;
    void smooth(int channel, std::uint32_t first, std::uint32_t count, const Of& what);
    void writePlain(int channel, std::uint32_t first, std::uint32_t count, const Of& what);
    void writeApart(const Growth& growth, const Fence& fence, const std::vector<std::uint32_t>& changed,
                    Smoothing smoothing);
    void goOnAlone(const Growth& growth, const Fence& fence, const Channel& channel, std::uint8_t label,
                   const std::vector<std::uint32_t>& tiles);
    void writeApart(int channel, std::uint8_t label, const gl::Texture& labels,
                    const ApartTiles::Changes& changes, Smoothing smoothing);
    void noteLabels(Channel& channel, const std::vector<std::uint32_t>& tiles, const gl::Texture& labels);
    [[nodiscard]] ApartTiles::Whose whoseIs(const Channel& channel, std::uint32_t tile,
                                            std::uint8_t label) const;
    [[nodiscard]] std::vector<std::uint32_t> staleApart(const Channel& channel, std::uint8_t label,
                                                        const std::vector<std::uint32_t>& changed) const;
    template <typename Visit>
    void visitAround(std::uint32_t tile, const Visit& visit) const;
    [[nodiscard]] gl::Defines imageDefines(const Of& what) const;
    void summarize(const std::vector<std::uint32_t>& tiles, Smoothing smoothing);
    void listTiles(const std::vector<std::uint32_t>& tiles);
    [[nodiscard]] gl::Defines memberDefines() const;
    void noteChanged(const std::vector<std::uint32_t>& tiles, const std::vector<std::uint32_t>& recoloured,
                     const BrickTable& table, bool hasAllChanged);
    [[nodiscard]] glm::ivec3 tileAt(std::uint32_t tile) const;
    [[nodiscard]] std::uint32_t tileIndex(glm::ivec3 place) const;

    glm::ivec3 dims_;
    glm::ivec3 brickDims_;
    glm::ivec3 tileDims_;
    glm::vec4 weights_[3]; // per axis: the kernel at 0, 1, 2 and 3 voxels
    gl::Texture texels_;
    std::optional<ApartTiles> apart_;
    gl::Texture cells_;
    std::uint64_t seenRevision_ = 0;
    std::uint64_t version_ = 0;
    std::vector<std::uint64_t> changedAt_; // by tile: the version that last changed it
    std::vector<Channel> channels_;
    Looks looks_ = allOpaque();
    bool haveLooksChanged_ = false;
    bool isBehind_ = false;
    bool startsAnew_ = false;                  // what there was is not to be relied on
    bool isRemade_ = false;                    // the texels are others since the last update
    bool wereColoured_ = false;                // there were segments of several colours at the last one
    std::optional<Continuation> continuation_; // made with the first fence
    gl::Buffer turnedAlone_; // one bit a voxel, as a channel's, of the segment that is being written alone

    gl::Buffer tiles_;
    gl::Buffer reach_;
    gl::Buffer labelsOfTiles_;
    gl::Buffer rows_;
    gl::Buffer alongXY_;
    gl::ProgramVariants packRows_{"segment/shaders/pack_rows.comp"};
    gl::Program smoothXY_;
    gl::ProgramVariants smoothZ_{"segment/shaders/smooth_z.comp"};
    gl::ProgramVariants writePlain_{"segment/shaders/write_membership.comp"};
    gl::ProgramVariants listLabels_{"segment/shaders/list_labels.comp"};
    gl::Program completeTiles_; // made when first used
    gl::ProgramVariants summarize_{"segment/shaders/summarize_tiles.comp"};
};

// Brings smooth segments wholly up to date, in portions between which it can be given up (base/progress.h).
void updateWholly(Segmentation& segmentation, const Growth& growth, const Looks& looks);

} // namespace vs::segment
