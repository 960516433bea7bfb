// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/phrase.h"

#include <QString>

#include <string_view>
#include <vector>

namespace vs::desktop {

// What the core library calls things and says of what was done, in the person's language: texts that are
// marked with VS_TEXT there. What has no translation stays English, as the library's error messages do.
QString libraryText(std::string_view english);
QString libraryText(const Phrase& phrase);

// The names and descriptions of presets that are translated.
std::vector<const char*> presetTexts();

} // namespace vs::desktop
