// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/keepers/recent_documents.h"

#include <QObject>
#include <QThreadPool>

namespace vs::desktop {

// Pictures of scans that were never open here: a slice beside the middle, seen from the patient's left.
// Made one at a time on a thread of its own, kept where those of recent documents are.
class SlicePictures : public QObject {
    Q_OBJECT

public:
    explicit SlicePictures(QObject* parent);
    // Waits for the one that is being made, drops the others.
    ~SlicePictures() override;
    // Makes the picture of a volume of moderate size, unless there is one or it has been asked for before.
    void want(const KnownDocument& document);

signals:
    void made();

private:
    QThreadPool pool_;
    QStringList asked_;
};

} // namespace vs::desktop
