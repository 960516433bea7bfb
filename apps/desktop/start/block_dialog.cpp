// SPDX-License-Identifier: Apache-2.0
#include "start/block_dialog.h"

#include "parts/panel_parts.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

constexpr std::array kPrecisions{sculpt::Precision::Bits8, sculpt::Precision::Bits16,
                                 sculpt::Precision::Bits32};
constexpr std::array kAxes{"X", "Y", "Z"};

QHBoxLayout* rowOf(QFormLayout* form, const QString& text) {
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    form->addRow(text, row);
    return row;
}

} // namespace

BlockDialog::BlockDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("blockDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Sculpt from nothing"));
    auto* page = new QWidget;
    auto* form = makeForm(page);
    form->setVerticalSpacing(12);
    addSize(form);
    addSpacing(form);
    total_ = named(makeQuietLabel({}), "blockTotal", tr("Size of the block"));
    form->addRow(QString(), total_);
    addBeginning(form);
    addPrecision(form);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Begin"));
    buttons->button(QDialogButtonBox::Ok)->setObjectName("blockBegin");
    buttons->button(QDialogButtonBox::Cancel)->setObjectName("blockCancel");
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        const OpenRequest wanted = request();
        accept();
        emit chosen(wanted);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(18);
    column->addWidget(page);
    column->addWidget(buttons);
    showTotal();
}

void BlockDialog::addSize(QFormLayout* form) {
    auto* row = rowOf(form, tr("Voxels"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QByteArray name = QByteArray("blockSize") + kAxes[axis];
        auto* box = named(new QSpinBox, name.constData(), tr("Voxels along %1").arg(kAxes[axis]));
        box->setRange(1, studio::Session::Block::kMostVoxels);
        box->setValue(block_.block.dims[int(axis)]);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setAlignment(Qt::AlignRight);
        connect(box, &QSpinBox::valueChanged, this, &BlockDialog::showTotal);
        row->addWidget(box, 1);
        size_[axis] = box;
    }
}

void BlockDialog::addSpacing(QFormLayout* form) {
    auto* row = rowOf(form, tr("Spacing (mm)"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QByteArray name = QByteArray("blockSpacing") + kAxes[axis];
        auto* box = makeSpinBox(name.constData(), tr("Spacing along %1, in mm").arg(kAxes[axis]));
        box->setDecimals(3);
        box->setRange(studio::Session::Block::kSpacingMm.lo, studio::Session::Block::kSpacingMm.hi);
        box->setValue(block_.block.spacingMm[int(axis)]);
        connect(box, &QDoubleSpinBox::valueChanged, this, &BlockDialog::showTotal);
        row->addWidget(box, 1);
        spacing_[axis] = box;
    }
}

void BlockDialog::addBeginning(QFormLayout* form) {
    auto* beginning = new ChoiceRow(
        {{"blockCarve", tr("A solid block"), tr("What the tools cut is taken away from it")},
         {"blockBuild", tr("Nothing"), tr("What the tools cut is what is seen: it is built up")}},
        0);
    connect(beginning, &ChoiceRow::chosen, this, [this](int n) { block_.isBuiltUp = n == 1; });
    form->addRow(tr("Begin with"), beginning);
}

void BlockDialog::addPrecision(QFormLayout* form) {
    auto* precision = new ChoiceRow({{"precision8", tr("8 bits"), tr("Least memory, for comparison")},
                                     {"precision16", tr("16 bits"), tr("As scans are sculpted")},
                                     {"precision32", tr("32 bits"), tr("Most memory, for comparison")}},
                                    1, 3);
    connect(precision, &ChoiceRow::chosen, this,
            [this](int n) { block_.precision = kPrecisions[std::size_t(n)]; });
    form->addRow(tr("Precision"), precision);
}

OpenRequest BlockDialog::request() const {
    OpenRequest request;
    request.block = block_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        request.block->block.dims[int(axis)] = size_[axis]->value();
        request.block->block.spacingMm[int(axis)] = spacing_[axis]->value();
    }
    return request;
}

void BlockDialog::showTotal() {
    if (total_ == nullptr) {
        return; // not all rows are there yet
    }
    const auto wanted = request().block->block;
    const glm::dvec3 mm = glm::dvec3(wanted.dims) * wanted.spacingMm;
    const auto voxels = double(wanted.dims.x) * wanted.dims.y * wanted.dims.z;
    const bool isTooLarge = voxels > double(studio::Session::kMostMadeVoxels);
    const QString text = isTooLarge
                             ? tr("%1 × %2 × %3 mm, %4 million voxels: at most %5 million are possible")
                             : tr("%1 × %2 × %3 mm, %4 million voxels");
    const QString sizes = text.arg(mm.x, 0, 'g', 4).arg(mm.y, 0, 'g', 4).arg(mm.z, 0, 'g', 4);
    const QString total = sizes.arg(voxels / 1e6, 0, 'f', 1);
    total_->setText(isTooLarge ? total.arg(double(studio::Session::kMostMadeVoxels) / 1e6, 0, 'f', 0)
                               : total);
    if (auto* buttons = findChild<QDialogButtonBox*>()) {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!isTooLarge);
    }
    total_->setProperty("report", total_->text());
}

} // namespace vs::desktop
