// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/cell_ranges.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "sculpt/radiation/radiation.h"
#include "sculpt/sculpture/fine_sculpture.h"
#include "sculpt/sculpture/limits.h"
#include "sculpt/sculpture/precision.h"
#include "sculpt/sculpture/sculpture_delta.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vs::sculpt {

enum class Combine { Cut, Restore };

// What has been cut away: a scalar from 0 (untouched) to 1 (cut) on the volume's grid, the cut face at 0.5.
// Kept on the device, together with the range of each macrocell for skipping empty space. Its texels take
// room there from when they are first asked for: whoever only looks at a volume never needs it.
class Sculpture {
public:
    explicit Sculpture(glm::ivec3 dims, Precision precision = Precision::Bits16);
    // A window onto a larger sculpture: has `dims` of its voxels, those from where moveTo() says on. What is
    // outside of it is left out. It has no macrocells and remembers no changes.
    static Sculpture window(glm::ivec3 dims, Precision precision);
    void moveTo(glm::ivec3 origin) { origin_ = origin; }
    // The voxel, of the grid in which radiation and solids are given, that its first one is.
    [[nodiscard]] glm::ivec3 origin() const { return origin_; }

    // From now on there is a finer one, from which this is derived: its texels hold what is at its voxels,
    // and its macrocells all that lies in them. What is cut already is cut in that one, too.
    void refine(std::unique_ptr<FineSculpture> finer);
    [[nodiscard]] FineSculpture* finer() const { return finer_.get(); }
    // Takes over what the finer one has now in a box of its voxels; bricks are protected in `backup` before
    // they change.
    void derive(const Box3& finerBox, BrickBackup& backup);
    // What was cut here, and not in the finer one, is cut there: `change` undoes it here, and both
    // afterwards. When it throws, both are as they were before that cut.
    void cutFiner(SculptureDelta& change);
    // While it is rough, it is cut, and its macrocells are made, as if there were no finer one, which knows
    // nothing of it. What was cut meanwhile must have been put back when that ends, or derived anew.
    void setRough(bool isRough) { isRough_ = isRough; }
    [[nodiscard]] bool isRough() const { return isRough_; }

    // Union with a radiation E, clamped to [0, 1]: S = max(S, E) for a cut, S = min(S, 1 - E) for a restore
    // (doc/behaviour.md, "Point radiation"). Where a restore has E >= 0.5 the result stays below 0.5, so
    // nothing of the same stroke's cut remains visible. Returns the box of voxels that may have changed
    // (tile-tight).
    Box3 combine(const Radiator& radiation, Combine how);
    // Cuts like combine(), but unites the radiation with what the sculpture was in `before` (null: untouched)
    // instead of what it is: in the tiles of the radiation it becomes that union. Puts back what an earlier
    // such call cut too far.
    Box3 combineWith(const gl::Texture* before, const Radiator& radiation);
    // Voxels whose value the last combine() changed; waits for the device.
    [[nodiscard]] std::uint64_t changedVoxels() const;

    // Where all that combines with the sculpture from now on may work; at first everywhere. The memberships
    // must outlive it, or the next call.
    void limitTo(const Limits& limits) { limits_ = limits; }
    [[nodiscard]] bool isLimited() const { return limits_.memberships != nullptr; }
    [[nodiscard]] const Limits& limits() const { return limits_; }
    // For programs that write texels(): what shaders/stored_values.glsl and limits.glsl want to know, and the
    // limits themselves.
    [[nodiscard]] gl::Defines defines() const;
    void bindLimits(gl::Program& program) const;

    // Everything untouched again (Un-Cut). Costs what was touched, and so does its undo: touchedBricks() are
    // what must be protected before.
    void clear();
    // The bricks (32^3) written to since the sculpture was made or cleared; elsewhere it is 0.
    [[nodiscard]] std::vector<Box3> touchedBricks() const;
    // Texels as they are stored (x fastest), and what they mean. upload() refreshes the macrocells.
    [[nodiscard]] std::vector<std::byte> download(const Box3& box) const { return texels().download(box); }
    [[nodiscard]] std::vector<float> values(const Box3& box) const {
        return valuesOf(download(box), precision_);
    }
    void upload(const Box3& box, std::span<const std::byte> texels);
    // Undo or redo, with the macrocells. Throws as BrickDelta::swap() does; then nothing has changed.
    void swap(BrickDelta& delta); // where there is no finer one
    void swap(SculptureDelta& delta);
    // All that is cut, for files; and a sculpture that is untouched becomes what was kept so. Its versions go
    // on from those that it had.
    [[nodiscard]] BrickDelta content() const;
    void restore(const BrickDelta& content, std::uint64_t version, std::uint64_t contentVersion);
    // Brings the macrocells up to date after texels() was written by something else (BrickBackup::restore).
    void refresh(const Box3& box);

    // Throws GlError if the device has no room for them.
    [[nodiscard]] gl::Texture& texels() { return allocated(); }
    [[nodiscard]] const gl::Texture& texels() const { return allocated(); }
    [[nodiscard]] gl::Format format() const { return formatOf(precision_); }
    // Whether they have been asked for.
    [[nodiscard]] bool takesRoom() const { return bool(texels_); }
    // RG32F, field::cellDims(dims) texels: smallest and largest value per macrocell.
    [[nodiscard]] const gl::Texture& cells() const { return cells_; }
    [[nodiscard]] glm::ivec3 dims() const { return dims_; }
    [[nodiscard]] Precision precision() const { return precision_; }
    // Counts every change.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    // Numbers the contents: as version(), but what has been put back as it was can have its number again.
    [[nodiscard]] std::uint64_t contentVersion() const { return contentVersion_; }
    // Says that the contents are what they were when contentVersion() was this.
    void contentIsAsAt(std::uint64_t contentVersion) { contentVersion_ = contentVersion; }
    // Voxels that may differ from what they were at an earlier version(). The longer ago, the more there may
    // be that do not; at version 0 everything was 0.
    [[nodiscard]] Box3 changedSince(std::uint64_t version) const;
    // Whether nothing is cut anywhere: a matter of content, so that undoing the first cut is as if it had
    // never been. May wait for the device.
    [[nodiscard]] bool isEmpty() const;

private:
    enum class Base { Itself, Texture, Nothing };
    Box3 combine(const Radiator& radiation, Combine how, Base base, const gl::Texture* before);
    void summarizeTiles(const Radiator& radiation, const Box3& box);
    void noteWritten(const Box3& box);
    void noteChange(const Box3& box);
    void markTouched(const Box3& box);

    gl::Texture& allocated() const;
    void summarize(const Box3& box);

    glm::ivec3 dims_;
    glm::ivec3 origin_{0};
    bool isWindow_ = false;
    std::unique_ptr<FineSculpture> finer_; // null: there is none
    bool isRough_ = false;
    Precision precision_;
    mutable gl::Texture texels_; // nothing: all 0 still
    gl::Texture cells_;
    Limits limits_;
    gl::ProgramVariants combine_{"sculpt/shaders/combine_sculpture.comp"};
    gl::Program summarize_; // cells of the radiation's tiles
    field::CellRangeUpdater updater_;
    gl::Buffer changed_;
    std::uint64_t version_ = 0;
    std::uint64_t contentVersion_ = 0;
    struct Change {
        std::uint64_t version = 0; // the one it led to
        Box3 box;
    };
    static constexpr std::size_t kChangesRemembered = 64;
    std::vector<Change> changes_; // oldest first; the first holds all that came before it; has room for all
    std::vector<bool> touched_;   // by brick, since it was made or cleared
    mutable std::optional<bool> isEmpty_ = true; // nothing: not known
};

} // namespace vs::sculpt
