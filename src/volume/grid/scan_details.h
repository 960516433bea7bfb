// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace vs::volume {

// What the files of a scan say of it beside where it lies and what its values are: for people to read.
// Texts are UTF-8, and empty where nothing is said.
struct ScanDetails {
    std::string format;         // "DICOM", "NIfTI" ...
    std::string patient;        // name and number
    std::string study;          // what was scanned, and when
    std::string series;         // number and description
    std::string modality;       // as DICOM says it: "CT", "MR", "PT" ...
    bool isAngiography = false; // made to show vessels
    // Values are slope * stored + intercept: of the first slice, where they differ from slice to slice.
    double slope = 1;
    double intercept = 0;
    int frame = 0; // which volume of the file's it is, of so many
    int frames = 1;
    int slices = 0; // of the whole stack, whatever part of it was read; 0: it says nothing
    // Slices along the third voxel axis that no file holds, in order: they were interpolated.
    std::vector<int> interpolated;
};

} // namespace vs::volume
