// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace vs::desktop {

// Quantities as people read them, in units that suit them: scans have voxels from a nanometre to a metre.

// A volume: "12.5 ml", "96.8 nl".
QString volumeText(double millilitres);
// Where something lies, without its sign, by the unit and the digits that suit a scan with such voxels:
// "12.3", and "mm" apart, as several places share it.
QString placeText(double mm, double stepMm);
QString placeUnit(double stepMm);

} // namespace vs::desktop
