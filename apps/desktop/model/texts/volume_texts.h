// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <QString>

#include <vector>

namespace vs::desktop {

// One thing that a volume is, in the person's language.
struct Property {
    const char* key; // for scripts
    QString name;
    QString text;
};

// What a person wants to know of a volume: where it comes from, where it lies, what its values are. What its
// files do not say is left out.
std::vector<Property> propertiesOf(const volume::Volume& volume);

// "3–5, 9" for the slices 2, 3, 4 and 8, which are in order: people count them from 1.
QString runsOf(const std::vector<int>& numbers);

} // namespace vs::desktop
