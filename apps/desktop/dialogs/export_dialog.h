// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dialogs/saving_dialog.h"
#include "model/exports/document_export.h"
#include "model/exports/export_formats.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace vs::desktop {

class SegmentChecks;

// Segments, what is left of the volume, or a table, for other programs: what, in which format, how fine; says
// beforehand how large it becomes; shows how far it is, and can be given up.
class ExportDialog : public SavingDialog {
    Q_OBJECT

public:
    // `folder` is where it begins, `name` what the file is called at first, without an extension.
    ExportDialog(StudioController& studio, const QString& folder, const QString& name, QWidget* parent);

protected:
    [[nodiscard]] Question question() const override;
    void save(const QString& path) override;

private:
    void makeFormatRow();
    void makeSurfaceRows();
    void makeVolumeRows();
    void setKind(ExportKind kind);
    void refresh();
    void showEstimate();
    [[nodiscard]] const ExportFormat& format() const;
    [[nodiscard]] studio::ExportSettings settings() const;
    [[nodiscard]] std::vector<studio::ExportedSegment> chosen() const;

    DocumentExport export_;
    QString folder_;
    QString fileName_;                  // without an extension
    std::vector<ExportFormat> formats_; // those in the box
    ExportKind kind_ = ExportKind::Segments;
    QFormLayout* form_ = nullptr;
    SegmentChecks* list_ = nullptr;
    QComboBox* format_ = nullptr;
    QLabel* formatTip_ = nullptr;
    QSlider* smoothing_ = nullptr;
    QSlider* share_ = nullptr; // per cent of the triangles
    QWidget* smoothingRow_ = nullptr;
    QWidget* shareRow_ = nullptr;
    QCheckBox* isEachAlone_ = nullptr;
    QDoubleSpinBox* least_ = nullptr;
    QDoubleSpinBox* most_ = nullptr;
    QWidget* rangeRow_ = nullptr;
    QDoubleSpinBox* fill_ = nullptr;
    QLabel* estimate_ = nullptr;
};

} // namespace vs::desktop
