// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/store/multiscales.h"

#include <optional>

namespace vs::volume {

// What is known of the finest level of a store without extremes of its own, by which of its chunks have no
// file: those hold the fill value, and elsewhere anything may be. Nothing: all have one, or there are too
// many files to go through. All of its files must be in this folder (a store on the web comes in parts).
std::optional<CellExtremes> extremesByMissing(const Multiscales& store, int channel, int time);

} // namespace vs::volume
