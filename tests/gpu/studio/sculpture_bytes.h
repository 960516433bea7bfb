// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document.h"

namespace vs::test {

// The whole sculpture of a document, byte for byte: what undo must restore.
inline std::vector<std::byte> sculptureBytes(const studio::Document& document) {
    return document.sculpture().download(document.volume().geometry.box());
}

} // namespace vs::test
