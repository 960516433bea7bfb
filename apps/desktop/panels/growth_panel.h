// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace vs::desktop {

class ScrubBar;
class SegmentTable;
class StudioController;

// The segments, how the one at work looks, and playback of its growth. Rules, edits and numbers have cards of
// their own.
class GrowthPanel : public QWidget {
    Q_OBJECT

public:
    explicit GrowthPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    QWidget* makeSearch(SegmentTable* table);
    QWidget* makeListRow();
    QWidget* makePlayback();
    QWidget* makeScrubRow();
    QWidget* makeNotice();
    QWidget* makeOptions();
    QWidget* makeLimit();
    void refresh();

    StudioController& studio_;
    QToolButton* remove_ = nullptr;
    QSlider* opacity_ = nullptr;
    bool isShowing_ = false;        // what is set is the document's, not the person's
    bool isOpacityDragged_ = false; // and one change of it is in the document
    QCheckBox* autoStart_ = nullptr;
    QSpinBox* speed_ = nullptr;
    QToolButton* play_ = nullptr;
    QToolButton* backward_ = nullptr;
    QToolButton* pause_ = nullptr;
    QToolButton* stop_ = nullptr;
    QToolButton* step_ = nullptr;
    QToolButton* back_ = nullptr;
    QToolButton* end_ = nullptr;
    ScrubBar* scrub_ = nullptr;
    QLabel* generation_ = nullptr;
    QWidget* notice_ = nullptr; // that growth has stopped by itself
    QLabel* noticeText_ = nullptr;
};

} // namespace vs::desktop
