// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/keepers/recent_documents.h"

#include <vector>

namespace vs::desktop {

// The experiments that come with the program, on scans that are here: to be played when they are opened. Each
// once, on a scan that the program makes if it can.
std::vector<KnownDocument> caseDocuments();

} // namespace vs::desktop
