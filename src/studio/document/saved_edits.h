// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document_state.h"
#include "studio/state/history.h"

#include <map>
#include <memory>
#include <vector>

namespace vs::studio {

// Between a document's parts on the device and those of a DocumentState. Private to that.

// Sculptures of earlier pastes, which several states of pasted parts share, on their way to the host.
class KeptPastes {
public:
    SavedParts saved(const PastedState& state);
    // What was cut at each, in the order of the numbers that were given out.
    [[nodiscard]] std::vector<sculpt::BrickDelta> contents(sculpt::Precision precision) const;

private:
    int numberOf(const std::shared_ptr<const gl::Texture>& paste);

    std::vector<std::shared_ptr<const gl::Texture>> pastes_;
};

// They are on the device again.
class RestoredPastes {
public:
    RestoredPastes(const std::vector<sculpt::BrickDelta>& contents, const sculpt::Sculpture& sculpture);
    // Throws Error when it names what is not there.
    [[nodiscard]] PastedState restored(const SavedParts& saved) const;

private:
    [[nodiscard]] std::shared_ptr<const gl::Texture> at(int number) const;

    std::vector<std::shared_ptr<const gl::Texture>> pastes_;
};

std::vector<SavedEdit> savedEdits(const History& history, const std::vector<Edit>& edits, KeptPastes& pastes);
std::vector<Edit> restoredEdits(std::vector<SavedEdit> edits, const RestoredPastes& pastes,
                                const gl::Texture* fence);

// States of growth that know whether a sculpture fences them, but not where it is: it is this one.
segment::GrowthSnapshot fencedBy(segment::GrowthSnapshot growth, const gl::Texture* fence);

} // namespace vs::studio
