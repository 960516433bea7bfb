// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/texts/language.h"

#include <QString>

namespace vs::desktop {

// How the window is coloured. It is calm, and dark at first, so that the picture is the brightest thing in
// it; or light; or as the desktop's own windows are.
enum class Theme { Dark, Light, Desktop };

// What a person has chosen once for all documents. Kept in Settings.
struct Preferences {
    Theme theme = Theme::Dark;
    Language language = Language::Desktop; // from the next start on
    int undoMegabytes = 512;               // that undo keeps in memory; the rest is in a temporary file
    // What scans and edits may take on the device, and bricks of large scans on the host; 0: what is usual.
    int deviceMegabytes = 0;
    int hostMegabytes = 0;
    QString recordings;          // where dialogs that save begin; empty: where they like
    bool smoothSampling = false; // of volumes that are opened
    bool shadows = false;        // of volumes that are opened
    QString sliceWindow;         // of CT scans that are opened (render::kSliceWindows); empty: automatic
    bool tintsSlices = false;    // of volumes that are opened
    bool turntable = false;      // the head stays up while the volume is turned
    int firstStrokePercent = 25; // of what is displayed, where a segment's first stroke stops; 0: nowhere

    static Preferences load();
    void save() const;

    bool operator==(const Preferences&) const = default;
};

} // namespace vs::desktop
