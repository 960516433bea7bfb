// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/exports/exports.h"

#include <QWidget>

class QCheckBox;
class QScrollArea;

namespace vs::desktop {

// A list of segments with their colours, of which some are chosen: at first all.
class SegmentChecks : public QWidget {
    Q_OBJECT

public:
    explicit SegmentChecks(std::vector<studio::ExportedSegment> segments);

    [[nodiscard]] std::vector<studio::ExportedSegment> chosen() const;
    [[nodiscard]] const std::vector<studio::ExportedSegment>& segments() const { return segments_; }

signals:
    void changed();

private:
    QScrollArea* makeList();
    void chooseAll();
    void refresh();

    std::vector<studio::ExportedSegment> segments_;
    QCheckBox* all_ = nullptr;
    std::vector<QCheckBox*> boxes_; // one for each segment
};

} // namespace vs::desktop
