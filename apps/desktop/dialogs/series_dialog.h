// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include <QDialog>

class QTreeWidget;

namespace vs::desktop {

// Lists the DICOM series of a folder; one of them is opened.
class SeriesDialog : public QDialog {
    Q_OBJECT

public:
    // Deletes itself when it closes.
    SeriesDialog(const OpenRequest& request, const std::vector<volume::SeriesChoice>& choices,
                 QWidget* parent);

signals:
    // The request, with its series.
    void chosen(const vs::desktop::OpenRequest& request);

private:
    void addRows();
    void takeCurrent();

    OpenRequest request_;
    std::vector<volume::SeriesChoice> choices_;
    QTreeWidget* list_;
};

} // namespace vs::desktop
