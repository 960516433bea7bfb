// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/dicom/dicom_elements.h"
#include "volume/grid/scan_details.h"

#include <string>

namespace vs::volume {

// Bytes in the character sets that (0008,0005) names, as UTF-8, by DCMTK. Where they are none of it, and for
// what cannot be printed, '?'.
std::string textIn(const std::string& characterSet, const std::string& bytes);

// "Doe, Jane Ann" for "Doe^Jane^Ann" (PS3.5, 6.2.1.1); of several ways of writing it the first.
std::string readablePersonName(const std::string& name);

// "2024-01-31" for "20240131"; nothing for what is no date.
std::string readableDate(const std::string& date);

// What a data set says of its scan for people.
ScanDetails detailsOf(const DicomDataSet& set);

} // namespace vs::volume
