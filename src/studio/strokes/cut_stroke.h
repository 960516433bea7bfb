// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/brick_backup.h"
#include "studio/operations/operation.h"
#include "studio/strokes/cutter.h"

#include <functional>
#include <memory>
#include <vector>

namespace vs::studio {

// What a stroke is drawn on, as it is now: the frame of the operation's canvas.
using MakeFrame = std::function<render::Frame()>;

// One edit of the sculpture on its way. Whatever is done is in the sculpture at once; finish() gives the
// delta that undoes it, discard() puts everything back.
class CutStroke {
public:
    virtual ~CutStroke() { cutter_->letSurfacesGo(); }
    CutStroke(const CutStroke&) = delete;
    CutStroke& operator=(const CutStroke&) = delete;

    // All that the operation says, at once.
    virtual void replay() = 0;

    // The operation as it has become: with the layers, or the pen points, so far.
    [[nodiscard]] const Operation& operation() const { return operation_; }
    // The sculpture's version at the beginning.
    [[nodiscard]] std::uint64_t sculptureVersion() const { return sculptureVersion_; }
    // Whether it only takes away: then all that can be seen could be seen at the beginning.
    [[nodiscard]] bool onlyCuts() const { return how_ == sculpt::Combine::Cut && !fills(); }
    // Whether it adds material, outward from the surface.
    [[nodiscard]] bool fills() const { return aim_.at == Cutter::Aim::At::Fill; }
    // What was filled at the beginning; null: it changes nothing of that.
    [[nodiscard]] const field::SharedFill& fillBefore() const { return fillBefore_; }
    // When nothing has changed after all, the sculpture counts as untouched.
    sculpt::SculptureDelta finish();
    void discard();
    // After finish(), whose delta this is: everything is back as discard() leaves it.
    void takeBack(sculpt::SculptureDelta& delta);

protected:
    CutStroke(Cutter& cutter, Operation operation, bool restores)
        : cutter_(&cutter), operation_(std::move(operation)),
          how_(restores ? sculpt::Combine::Restore : sculpt::Combine::Cut),
          sculptureVersion_(cutter.sculpture->version()), contentVersion_(cutter.sculpture->contentVersion()),
          backup_(cutter.sculpture->texels()), aim_(cutter.aim),
          cutsFill_(how_ == sculpt::Combine::Cut && cutter.cutsFill()),
          fillBefore_(cutter.fill != nullptr ? *cutter.fill : nullptr),
          target_(cutter.target(backup_, originals_, how_)) {}

    // What the stroke cuts into.
    [[nodiscard]] sculpt::CutTarget& target() { return *target_; }
    // Cuts in a part by an energy for each of its voxels, within the limits that hold. Returns the box in
    // which something has changed.
    static Box3 cutBy(const sculpt::CutTarget::Part& part, const std::vector<float>& energies);
    // The sculpture is cut by something else, at the scene's resolution; finish() has the finer one follow.
    void cutsInScene() { cutsInScene_ = true; }
    // Whether it takes away what is filled along with the scan.
    [[nodiscard]] bool cutsFill() const { return cutsFill_; }
    // Whether it takes that away and nothing else.
    [[nodiscard]] bool takesFill() const { return aim_.at == Cutter::Aim::At::Filled; }

    Cutter* cutter_;
    Operation operation_;
    sculpt::Combine how_;
    std::uint64_t sculptureVersion_;
    std::uint64_t contentVersion_;
    sculpt::BrickBackup backup_;

private:
    Cutter::Aim aim_;
    bool cutsFill_ = false;
    field::SharedFill fillBefore_;
    sculpt::FineBricks originals_; // of the finer sculpture
    std::unique_ptr<sculpt::CutTarget> target_;
    bool cutsInScene_ = false;
};

} // namespace vs::studio
