// SPDX-License-Identifier: Apache-2.0
#include "dialogs/geometry_card.h"

#include "dialogs/correction_picture.h"
#include "model/studio/studio_controller.h"
#include "model/texts/volume_texts.h"
#include "parts/panel_parts.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

using Turn = GeometryDraft::Turn;
using render::SliceKind;

constexpr int kDecimals = 6;

// As few decimals as the spacings need, but at least four.
int decimalsFor(glm::dvec3 mm) {
    const double least = std::min({mm.x, mm.y, mm.z});
    return std::clamp(3 - int(std::floor(std::log10(least))), 4, kDecimals);
}

} // namespace

GeometryCard::GeometryCard(StudioController& studio)
    : studio_(studio), draft_(*studio.host().geometryInFile(), *studio.host().geometry()) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* content = nullptr;
    outer->addWidget(makeCard(tr("Correct"), content));
    auto* hint =
        makeQuietLabel(tr("Flip and turn these slices until they are what the letters at their edges "
                          "say. Voxels keep their values and their cuts; the file is never changed."));
    hint->setWordWrap(true);
    content->addWidget(hint);
    auto* slices = new QHBoxLayout;
    slices->setSpacing(12);
    for (const SliceKind kind : render::kSliceKinds) {
        slices->addWidget(makeSlice(kind));
    }
    slices->addStretch(1);
    content->addLayout(slices);
    content->addWidget(makeSpacings());
    meaning_ = named(new QLabel, "correctionMeaning", tr("What the correction means"));
    meaning_->setWordWrap(true);
    content->addWidget(meaning_);
    content->addWidget(makeButtons());
    connect(&studio_.host(), &DocumentHost::corrected, this, &GeometryCard::refresh);
    refresh();
}

QWidget* GeometryCard::makeSlice(SliceKind kind) {
    struct Texts {
        QByteArray prefix;
        QString title;
    };
    const std::array<Texts, 3> texts{
        {{"axial", tr("Axial")}, {"coronal", tr("Coronal")}, {"sagittal", tr("Sagittal")}}};
    const QByteArray prefix = texts.at(std::size_t(kind)).prefix;
    const QString title = texts.at(std::size_t(kind)).title;
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(5);
    column->addWidget(makeQuietLabel(title));
    auto* picture = new CorrectionPicture(*studio_.host().volume(), studio_.view().sliceWindow(), kind);
    pictures_.at(std::size_t(kind)) = named(picture, prefix + "Correction", title);
    column->addWidget(picture);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    const auto add = [&](const char* icon, const char* name, const QString& text, const QString& tip,
                         Turn turn) {
        auto* button = makeIconButton(icon, prefix + name, text.arg(title), tip);
        connect(button, &QToolButton::clicked, this, [this, kind, turn] {
            draft_.turn(kind, turn);
            refresh();
        });
        buttons->addWidget(button);
    };
    add("flipAcross", "FlipAcross", tr("Flip left and right: %1"),
        tr("Exchanges left and right of this slice; this alone mirrors the scan"), Turn::FlipAcross);
    add("flipDown", "FlipDown", tr("Flip top and bottom: %1"),
        tr("Exchanges top and bottom of this slice; this alone mirrors the scan"), Turn::FlipDown);
    add("turnQuarter", "Turn", tr("Turn by a quarter: %1"), tr("Turns this slice clockwise by a quarter"),
        Turn::Clockwise);
    add("exchangeAxes", "Exchange", tr("Exchange axes: %1"),
        tr("Exchanges two axes: what runs across this slice runs down; this alone mirrors the scan"),
        Turn::Exchange);
    buttons->addStretch(1);
    column->addLayout(buttons);
    return holder;
}

QWidget* GeometryCard::makeSpacings() {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(new QLabel(tr("Spacing (mm)")));
    const std::array<QString, 3> names{tr("Spacing of columns in mm"), tr("Spacing of rows in mm"),
                                       tr("Spacing of slices in mm")};
    const std::array<const char*, 3> objects{"spacingColumns", "spacingRows", "spacingSlices"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto* box = makeSpinBox(objects[axis], names[axis]);
        box->setDecimals(decimalsFor(draft_.spacing()));
        box->setRange(studio::CorrectGeometry::kLeastSpacingMm, studio::CorrectGeometry::kMostSpacingMm);
        box->setSingleStep(0.1);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setValue(draft_.spacing()[int(axis)]);
        connect(box, &QDoubleSpinBox::valueChanged, this, &GeometryCard::takeSpacing);
        spacings_[axis] = box;
        row->addWidget(box, 1);
        if (axis < 2) {
            row->addWidget(new QLabel(QString(QChar(0x00d7)))); // times
        }
    }
    return holder;
}

QWidget* GeometryCard::makeButtons() {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    asInFile_ = named(new QPushButton(tr("As in the file")), "geometryAsInFile", tr("As in the file"));
    asInFile_->setToolTip(tr("Spacing and orientation that the file says"));
    apply_ = named(new QPushButton(tr("Apply")), "applyGeometry", tr("Apply"));
    apply_->setToolTip(tr("Corrects the scan; this can be undone"));
    for (QPushButton* button : {asInFile_, apply_}) {
        button->setAutoDefault(false);
    }
    row->addStretch(1);
    row->addWidget(asInFile_);
    row->addWidget(apply_);
    connect(asInFile_, &QPushButton::clicked, this, [this] {
        draft_.reset();
        refresh();
    });
    connect(apply_, &QPushButton::clicked, this, &GeometryCard::apply);
    return holder;
}

// What was not typed stays as it is, also where the box rounds it.
void GeometryCard::takeSpacing() {
    glm::dvec3 mm = draft_.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        mm[axis] = numberIn(*spacings_[std::size_t(axis)], mm[axis]);
    }
    draft_.setSpacing(mm);
    refresh();
}

void GeometryCard::apply() {
    studio_.editor().apply(draft_.correction());
    refresh();
}

void GeometryCard::refresh() {
    const volume::GridGeometry grid = draft_.grid();
    for (CorrectionPicture* picture : pictures_) {
        picture->show(grid);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const QSignalBlocker silence(spacings_[std::size_t(axis)]);
        spacings_[std::size_t(axis)]->setValue(draft_.spacing()[axis]);
    }
    meaning_->setText(meaning());
    meaning_->setProperty("report", meaning_->text());
    asInFile_->setEnabled(grid != *studio_.host().geometryInFile());
    apply_->setEnabled(grid != *studio_.host().geometry());
}

QString GeometryCard::meaning() const {
    const volume::GridGeometry& file = *studio_.host().geometryInFile();
    const volume::GridGeometry grid = draft_.grid();
    if (grid == file) {
        return tr("As in the file: %1.").arg(placeText(file));
    }
    const QString says = tr("%1; in the file %2.").arg(placeText(grid), placeText(file));
    return volume::areMirrored(grid, file) ? says + ' ' + mirroredText(file, grid) : says;
}

} // namespace vs::desktop
