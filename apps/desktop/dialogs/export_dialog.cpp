// SPDX-License-Identifier: Apache-2.0
#include "dialogs/export_dialog.h"

#include "dialogs/segment_checks.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr int kMostPasses = 50;
constexpr int kLeastShare = 2; // per cent

// "443 000": no more digits than an estimate has.
QString rounded(double number) {
    const double step = number < 1000 ? 10 : std::pow(10, std::floor(std::log10(number)) - 2);
    return grouped(qulonglong(std::round(number / step) * step));
}

QDoubleSpinBox* makeValueBox(const char* name, const QString& accessibleName, const volume::Volume& volume,
                             double value) {
    auto* box = makeSpinBox(name, accessibleName);
    box->setRange(std::min(volume.range.lo, value), std::max(volume.range.hi, value));
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    const double width = std::max(volume.usual.width(), 1e-9);
    box->setDecimals(
        isWhole && value == std::floor(value) ? 0 : std::clamp(4 - int(std::floor(std::log10(width))), 0, 8));
    box->setValue(value);
    return box;
}

} // namespace

ExportDialog::ExportDialog(StudioController& studio, const QString& folder, const QString& name,
                           QWidget* parent)
    : SavingDialog(studio, "export", parent), export_(studio), folder_(folder), fileName_(name) {
    setWindowTitle(tr("Export"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    fields_ = new QWidget;
    auto* inner = new QVBoxLayout(fields_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(12);
    const bool hasSegments = studio.segments().hasVoxels();
    auto* kinds = new ChoiceRow(
        {{"exportSegments", tr("Segments"), tr("Surfaces of segments, label maps and DICOM segmentations")},
         {"exportVolume", tr("Sculpted volume"), tr("What is left of the scan: its surface, or its values")},
         {"exportTable", tr("Table"), tr("The numbers of segments, for a spreadsheet")}},
        hasSegments ? 0 : 1);
    inner->addWidget(kinds);
    list_ = new SegmentChecks(studio::exportable(*studio.host().document()));
    inner->addWidget(list_);
    connect(list_, &SegmentChecks::changed, this, &ExportDialog::refresh);
    auto* page = new QWidget;
    form_ = makeForm(page);
    inner->addWidget(page);
    column->addWidget(fields_);
    makeFormatRow();
    makeSurfaceRows();
    makeVolumeRows();
    addBottom(column, export_, tr("Export\u2026"), tr("Export"));
    connect(kinds, &ChoiceRow::chosen, this, [this](int kind) { setKind(ExportKind(kind)); });
    connect(&export_, &DocumentExport::estimated, this, &ExportDialog::showEstimate);
    fields_->setMinimumWidth(420);
    column->setSizeConstraint(QLayout::SetFixedSize); // always as large as what is shown
    setKind(hasSegments ? ExportKind::Segments : ExportKind::Volume);
    if (hasSegments) {
        QTimer::singleShot(0, &export_, &DocumentExport::estimate); // once it is seen
    }
}

void ExportDialog::makeFormatRow() {
    format_ = named(new QComboBox, "exportFormat", tr("Format"));
    form_->addRow(tr("Format"), format_);
    formatTip_ = makeQuietLabel({});
    formatTip_->setWordWrap(true);
    form_->addRow(QString(), formatTip_);
    connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
}

void ExportDialog::makeSurfaceRows() {
    smoothing_ = makeSlider("exportSmoothing", tr("Smoothing"), 0, kMostPasses,
                            studio::ExportSettings::kUsualSmoothing);
    smoothing_->setToolTip(tr("Takes steps between slices away and keeps the volume"));
    smoothingRow_ = withValue(smoothing_, [](int n) { return n == 0 ? tr("none") : QString::number(n); });
    form_->addRow(tr("Smoothing"), smoothingRow_);
    share_ = makeSlider("exportTriangles", tr("Triangles to keep"), kLeastShare, 100, 100);
    share_->setToolTip(tr("Fewer triangles make smaller files; flat places lose them first"));
    shareRow_ = withValue(share_, [](int n) { return n == 100 ? tr("all") : tr("%1 %").arg(n); });
    form_->addRow(tr("Triangles"), shareRow_);
    isEachAlone_ = makeCheckBox("exportEach", tr("A file for each segment"),
                                tr("Named after the file and the segment"), false);
    form_->addRow(QString(), isEachAlone_);
    connect(share_, &QSlider::valueChanged, this, &ExportDialog::showEstimate);
}

void ExportDialog::makeVolumeRows() {
    const volume::Volume& volume = studio_.host().document()->volume();
    const Range range = studio_.view().shown().range;
    rangeRow_ = new QWidget;
    auto* row = new QHBoxLayout(rangeRow_);
    row->setContentsMargins(0, 0, 0, 0);
    least_ = makeValueBox("exportLeast", tr("Values from"), volume, range.lo);
    most_ = makeValueBox("exportMost", tr("Values to"), volume, range.hi);
    rangeRow_->setToolTip(tr("The surface of values in this range, at first the displayed one"));
    row->addWidget(least_);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(most_);
    row->addStretch(1);
    form_->addRow(tr("Values"), rangeRow_);
    fill_ = makeValueBox("exportFill", tr("Value of what is cut"), volume, volume.usual.lo);
    fill_->setToolTip(tr("What is written where the scan was cut away"));
    form_->addRow(tr("Cut away becomes"), fill_);
    estimate_ = named(makeQuietLabel({}), "exportEstimate", tr("Size"));
    form_->addRow(QString(), estimate_);
}

const ExportFormat& ExportDialog::format() const {
    return formats_.at(std::size_t(std::max(format_->currentIndex(), 0)));
}

void ExportDialog::setKind(ExportKind kind) {
    kind_ = kind;
    formats_ = exportFormats(kind);
    const QSignalBlocker blocker(format_);
    format_->clear();
    for (const ExportFormat& one : formats_) {
        format_->addItem(tr("%1 (%2)").arg(one.text, one.suffix));
    }
    smoothing_->setValue(kind == ExportKind::Segments ? studio::ExportSettings::kUsualSmoothing : 0);
    refresh();
}

// What does not matter for what is chosen is not shown.
void ExportDialog::refresh() {
    const bool isVolume = kind_ == ExportKind::Volume;
    const bool isMesh = format().isMesh();
    const auto show = [this](QWidget* field, bool isShown) { form_->setRowVisible(field, isShown); };
    list_->setVisible(!isVolume && !list_->segments().empty());
    formatTip_->setText(format().tip);
    show(smoothingRow_, isMesh);
    show(shareRow_, isMesh);
    show(isEachAlone_, isMesh && !isVolume && list_->segments().size() > 1);
    show(rangeRow_, isVolume && isMesh);
    show(fill_, isVolume && !isMesh);
    showEstimate();
    save_->setEnabled(isVolume || !chosen().empty());
    message_->setVisible(!isVolume && list_->segments().empty());
    message_->setText(tr("No segment has voxels yet: seed and grow one first."));
}

void ExportDialog::showEstimate() {
    std::size_t triangles = 0;
    for (const auto& segment : chosen()) {
        triangles += export_.triangles()[segment.label];
    }
    const bool isShown = kind_ == ExportKind::Segments && format().isMesh() && triangles > 0;
    form_->setRowVisible(estimate_, isShown);
    if (isShown) {
        const double kept = double(triangles) * share_->value() / 100;
        const QString size = QLocale(QLocale::English)
                                 .formattedDataSize(qint64(kept * format().bytesPerTriangle), 0,
                                                    QLocale::DataSizeTraditionalFormat);
        estimate_->setText(tr("about %1 triangles, %2").arg(rounded(kept), size));
    }
}

std::vector<studio::ExportedSegment> ExportDialog::chosen() const {
    return kind_ == ExportKind::Volume ? std::vector<studio::ExportedSegment>() : list_->chosen();
}

studio::ExportSettings ExportDialog::settings() const {
    using What = studio::ExportSettings::What;
    studio::ExportSettings settings;
    settings.what = kind_ == ExportKind::Volume ? What::Volume : What::Segments;
    settings.isEachAlone = isEachAlone_->isVisible() && isEachAlone_->isChecked();
    settings.refinement.smoothing = smoothing_->value();
    settings.refinement.share = share_->value() / 100.0;
    const Range shown = studio_.view().shown().range;
    settings.range = {numberIn(*least_, shown.lo), numberIn(*most_, shown.hi)};
    settings.fill = numberIn(*fill_, studio_.host().document()->volume().usual.lo);
    return settings;
}

SavingDialog::Question ExportDialog::question() const {
    const QString suffix = format().suffix;
    return {tr("Export"), tr("%1 (*%2)").arg(format().text, suffix), folder_, suffix.mid(1),
            fileName_ + suffix};
}

void ExportDialog::save(const QString& path) {
    lock(1000);
    export_.save(path.toStdString(), settings(), chosen());
}

} // namespace vs::desktop
