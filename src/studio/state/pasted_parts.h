// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "gl/program.h"
#include "render/camera/placement.h"
#include "sculpt/sculpture/sculpture.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace vs::studio {

// What a document knows about pasted parts: where each is, and the sculpture as it was when each was pasted.
struct PastedState {
    std::vector<render::Placement> places;
    std::vector<std::shared_ptr<const gl::Texture>> sculptures; // one for each paste
};

// Which part of what was cut belongs to which paste. Part k is what was cut between paste k - 1 and paste k;
// the last one takes in what is cut after it too. So part k is where min(S, S_k, 1 - S_(k-1)) is at least
// 0.5, S being the sculpture now and S_k that at paste k: live, with cut faces as smooth as the sculpture's
// own.
class PastedParts {
public:
    // The sculpture as it is now, for the state of a paste.
    static std::shared_ptr<const gl::Texture> remember(const sculpt::Sculpture& sculpture);

    struct Part {
        const gl::Texture* texels = nullptr; // in 0..1, the part from 0.5 up
        const gl::Texture* cells = nullptr;  // RG32F, range per macrocell
        std::uint64_t making = 0; // another number: it may differ even where the sculpture is the same
    };
    // What is drawn at `places` (of a view): part k at place k while there are that many parts; at all other
    // places everything that was cut. Valid until the next call. Costs what has changed since the last.
    std::vector<Part> parts(const sculpt::Sculpture& sculpture, const PastedState& state, std::size_t places);

private:
    struct Derived {
        gl::Texture texels;
        gl::Texture cells;
        std::shared_ptr<const gl::Texture> upTo; // what it was derived with
        std::shared_ptr<const gl::Texture> from;
        std::uint64_t version = 0; // of the sculpture
        std::uint64_t making = 0;
    };
    void derive(Derived& part, const sculpt::Sculpture& sculpture, const Box3& box);

    std::deque<Derived> derived_;
    std::uint64_t makings_ = 0;
    gl::Program program_; // made when first used
    field::CellRangeUpdater updater_;
};

} // namespace vs::studio
