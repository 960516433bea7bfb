// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include <QDateTime>
#include <QString>

#include <filesystem>
#include <vector>

namespace vs::desktop {

// What the start screen offers to open: a volume or a session that was open before, or an example.
struct KnownDocument {
    OpenRequest request; // absolute paths
    QString details;     // "256 × 256 × 108"
    bool hasSegments = false;
    QDateTime seen;                  // when it was last open
    std::filesystem::path scan = {}; // that was pointed out for a session
    // What a document that comes with the program, and lies in no file, is called, and where its picture is.
    QString title = {};
    QString picture = {};

    [[nodiscard]] QString path() const;
    [[nodiscard]] QString name() const; // of the file or folder
    [[nodiscard]] bool isSession() const { return !request.session.empty() || request.given; }
    [[nodiscard]] bool isMissing() const;
    // Tells documents apart: the path, and what was chosen of the file there.
    [[nodiscard]] QString key() const;
    // Where its picture is kept, in the user's cache; there need not be one.
    [[nodiscard]] QString picturePath() const;
};

// The documents that were open of late, the newest first. Kept in Settings, shared by all windows.
std::vector<KnownDocument> recentDocuments();
// The folders in which they and the scans of sessions lie, each once.
std::vector<std::filesystem::path> foldersUsedBefore();
// Puts a document in front; the oldest goes when there are many.
void rememberDocument(const KnownDocument& document);
// Takes a document off the list, and deletes its picture.
void forgetDocument(const KnownDocument& document);

// Scans that Debian packages have put on this machine, and the examples that came with this program.
std::vector<KnownDocument> exampleDocuments();

} // namespace vs::desktop
