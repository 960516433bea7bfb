// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string_view>
#include <vector>

namespace vs::desktop {

// What the core library calls things and says of what was done, in the person's language: names of
// operations, presets and colour tables, messages with numbers and 'quoted' names in them. What has no
// translation stays English, as the library's error messages do.
QString libraryText(std::string_view english);

// The texts that libraryText() knows, with %1, %2 ... where numbers and quoted names stand.
std::vector<const char*> knownLibraryTexts();

} // namespace vs::desktop
