// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/value_json.h"
#include "studio/document/document_state.h"
#include "studio/json/state_file.h"

#include <limits>

namespace vs::studio {

// Parts of a document's state that stand in several places of it. Private to the state of sessions. What is
// read throws SessionError naming file and member.

inline constexpr long kAnyNumber = std::numeric_limits<long>::max();

// Runs through a list of JSON.
template <typename Read>
void forEachIn(const JsonReader& list, Read read) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        read(list.at(i));
    }
}

Json stored(StateWriter& file, const sculpt::BrickDelta& delta);
sculpt::BrickDelta readDelta(StateReader& file, const JsonReader& from, glm::ivec3 dims);

Json stored(const SavedParts& parts);
SavedParts readParts(const JsonReader& from);

// Where voxels lie: the columns of worldFromVoxel, without their last row.
Json stored(const volume::GridGeometry& geometry);
volume::GridGeometry readGeometry(const JsonReader& from, glm::ivec3 dims);

Json stored(const Measurements& measurements);
Measurements readMeasurements(const JsonReader& from);

} // namespace vs::studio
