// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "sculpt/sculpture/brick_backup.h"
#include "sculpt/sculpture/sculpture.h"

namespace vs::sculpt {

// What of the volume was trimmed away around what one works on (Keep, Clip), as what is left for tools: T, a
// scalar on the sculpture's grid, stored as that is. 1 where nothing was trimmed; of what is cut, tools have
// min(S, T). A trim that raises the sculpture from S, which tools had cut, to S' makes T max(S, 1 - S'): what
// they had, to the bit, and what they may still cut. Takes room on the device from the first trim on, as much
// as the sculpture.
class Trimmed {
public:
    // Nothing was ever trimmed.
    [[nodiscard]] bool isEmpty() const { return !leftForTools_; }
    // T; there must have been a trim.
    [[nodiscard]] const gl::Texture& leftForTools() const { return leftForTools_; }

    // Follows a change of the sculpture that has been made, a trim or another one, and says what undoes that;
    // what is restored is trimmed no more. Throws Error or std::bad_alloc when there is no memory for it, and
    // has changed nothing then.
    BrickDelta follow(const Sculpture& sculpture, const BrickDelta& change, bool isTrim);
    // Undo or redo of what follow() did.
    void swap(BrickDelta& delta) { delta.swap(leftForTools_); }

    // What is trimmed, for files, where anything ever was; and what was kept so becomes it again.
    [[nodiscard]] BrickDelta content(Precision precision) const;
    void restore(const Sculpture& sculpture, const BrickDelta& content);

private:
    void prepare(const Sculpture& sculpture);
    [[nodiscard]] gl::Texture nothingTrimmed(const Sculpture& sculpture);
    BrickDelta follow(const Sculpture& sculpture, const BrickDelta& change, const Box3& box,
                      const gl::Texture& before);

    gl::Texture leftForTools_; // made by the first trim
    gl::Program program_;      // made by the first trim too
};

} // namespace vs::sculpt
