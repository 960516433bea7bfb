// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::studio {

// Work that is shown while it goes on and is one operation when it ends. Only one at a time, and nothing else
// is done meanwhile.
enum class InHand { Nothing, Stroke, Mark, Growth, Scrub };

} // namespace vs::studio
