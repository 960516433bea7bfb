// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/exports/exports.h"

namespace vs::studio {

// What is left of the volume, as a store; of a scan that is worked on at a coarser level, its finest one, box
// by box. Returns a line about it. Throws WriteError.
std::string writeSculptedStore(const std::filesystem::path& path, const ExportSource& source,
                               const std::optional<double>& fill);
// The segments to export, as a label map in a store: coarser levels have the commonest label, and the names
// and colours stand beside it ("image-label"). Throws WriteError.
std::string writeLabelStore(const std::filesystem::path& path, const ExportSource& source);

} // namespace vs::studio
