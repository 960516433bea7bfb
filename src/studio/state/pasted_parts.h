// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "field/cell_ranges.h"
#include "gl/program.h"
#include "render/camera/placement.h"
#include "sculpt/sculpture/sculpture.h"
#include "sculpt/sculpture/trimmed.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace vs::studio {

// What a person says about a part that was pasted, and where it came from.
struct PartInfo {
    std::string name;
    bool isVisible = true;
    bool takesTrimmed = false; // what Keep and Clip took away belongs to it too
    glm::dvec3 middleVoxel{0}; // of what was seen of it when it was pasted, where it was cut out

    // States of sessions keep it so.
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("name", &PartInfo::name, {.mostCount = 200}),
                          required("visible", &PartInfo::isVisible), required("all", &PartInfo::takesTrimmed),
                          required("middle", &PartInfo::middleVoxel, {.unit = "voxels"})};
    }
};

// A part that was pasted, with what of the sculpture it is.
struct PastedPart : PartInfo {
    // The sculpture as it was when the part before was pasted (null: untouched), and when this one was.
    std::shared_ptr<const gl::Texture> from;
    std::shared_ptr<const gl::Texture> upTo;
};

// What a document knows about pasted parts.
struct PastedState {
    std::vector<render::Placement> places; // where each is
    std::vector<PastedPart> parts;
    std::shared_ptr<const gl::Texture> last; // the sculpture at the last paste, of a part or one that is gone

    // The part, so far without a name, that a paste would make now.
    [[nodiscard]] PastedPart next() const { return {{}, last, nullptr}; }
    // Part k takes in what is cut from now on: nothing was pasted after it.
    [[nodiscard]] bool isOpen(std::size_t k) const { return parts[k].upTo == last; }
};

// Which part of what was cut belongs to which paste. Part k is what tools cut between the paste before and
// its own; the one that was pasted last takes in what is cut after it too. So it is where min(S, S_k, 1 -
// S_(k-1), T) is at least 0.5, S being the sculpture now, S_k that at its own paste and T what trims left for
// tools (sculpt::Trimmed), unless the part takes those too: live, with cut faces as smooth as the sculpture's
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
    std::vector<Part> parts(const sculpt::Sculpture& sculpture, const sculpt::Trimmed& trimmed,
                            const PastedState& state, std::size_t places);
    // The ranges (x fastest) of the macrocells of one part, made afresh: for parts that are not in the state.
    std::vector<glm::vec2> cellsOf(const PastedPart& part, const sculpt::Sculpture& sculpture,
                                   const sculpt::Trimmed& trimmed);

private:
    struct Derived {
        gl::Texture texels;
        gl::Texture cells;
        std::shared_ptr<const gl::Texture> from; // what it was derived with
        std::shared_ptr<const gl::Texture> upTo;
        bool takesTrimmed = false;
        std::uint64_t version = 0; // of the sculpture
        std::uint64_t making = 0;
    };
    void derive(Derived& part, const sculpt::Sculpture& sculpture, const sculpt::Trimmed& trimmed,
                const Box3& box);

    std::deque<Derived> derived_;
    std::uint64_t makings_ = 0;
    gl::Program program_; // made when first used
    field::CellRangeUpdater updater_;
};

} // namespace vs::studio
