// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <vector>

namespace vs::desktop {

// What can be exported, in the order of the dialog's choices.
enum class ExportKind { Segments, Volume, Table };

// A format that something can be exported in.
struct ExportFormat {
    QString text;
    QString suffix;              // ".stl"
    double bytesPerTriangle = 0; // of surfaces; 0: it holds no surface
    QString tip;

    [[nodiscard]] bool isMesh() const { return bytesPerTriangle > 0; }
};

// The usual one first.
std::vector<ExportFormat> exportFormats(ExportKind kind);

} // namespace vs::desktop
