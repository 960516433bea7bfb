// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/keepers/recent_documents.h"

#include <QImage>
#include <QObject>
#include <QTimer>

namespace vs::desktop {

class StudioController;

// Keeps the list of recent documents and their pictures: what was seen last of each. A picture is taken when
// it has been at rest for a moment, and once more before the document goes.
class ThumbnailKeeper : public QObject {
    Q_OBJECT

public:
    static constexpr QSize kSize{480, 300}; // pixels: a card at twice the scale

    explicit ThumbnailKeeper(StudioController& studio);
    // Takes the picture if it is complete and new. Costs the reading of one picture; the rest is done on
    // another thread.
    void keep();

signals:
    void kept(); // a picture file is written

private:
    [[nodiscard]] KnownDocument present() const;
    void remember();

    StudioController& studio_;
    QTimer calm_;
    int taken_ = -1; // which of the picture loop's pictures
};

// Writes a picture whole or not at all: two windows may write the same one. Makes its folder.
void writeThumbnail(const QString& path, const QImage& picture);

} // namespace vs::desktop
