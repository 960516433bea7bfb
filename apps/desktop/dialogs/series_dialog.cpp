// SPDX-License-Identifier: Apache-2.0
#include "dialogs/series_dialog.h"

#include "parts/panel_parts.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vs::desktop {

namespace {

QString text(const std::string& value) { return QString::fromStdString(value); }

// "0.49 × 0.49 × 1.25 mm"; what the files do not state is a question mark.
QString spacingOf(const volume::SeriesChoice& choice) {
    const auto number = [](std::optional<double> mm) {
        return mm ? QString::number(*mm, 'g', 3) : QString("?");
    };
    const auto pixel = choice.pixelSpacing;
    return QString("%1 × %2 × %3 mm")
        .arg(number(pixel ? std::optional(pixel->x) : std::nullopt),
             number(pixel ? std::optional(pixel->y) : std::nullopt), number(choice.sliceSpacing));
}

} // namespace

SeriesDialog::SeriesDialog(const OpenRequest& request, const std::vector<volume::SeriesChoice>& choices,
                           QWidget* parent)
    : QDialog(parent), request_(request), choices_(choices),
      list_(named(new QTreeWidget, "seriesList", tr("Series"))) {
    setObjectName("seriesDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Which series?"));
    auto* column = new QVBoxLayout(this);
    const QString folder = text(request.volume.lexically_normal().string());
    auto* heading = new QLabel(tr("%1 holds %2 series. Open which?").arg(folder).arg(choices.size()));
    heading->setWordWrap(true);
    column->addWidget(heading);
    list_->setHeaderLabels(
        {tr("No."), tr("Description"), tr("Kind"), tr("Size"), tr("Spacing"), tr("Images")});
    list_->setRootIsDecorated(false);
    list_->setAllColumnsShowFocus(true);
    list_->setUniformRowHeights(true);
    addRows();
    column->addWidget(list_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setObjectName("openSeries");
    buttons->button(QDialogButtonBox::Open)->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &SeriesDialog::takeCurrent);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QTreeWidget::itemActivated, this, &SeriesDialog::takeCurrent);
    list_->setFocus();
    resize(760, 340);
}

void SeriesDialog::addRows() {
    const auto largest = std::max_element(choices_.begin(), choices_.end(),
                                          [](const auto& a, const auto& b) { return a.images < b.images; });
    for (std::size_t n = 0; n < choices_.size(); ++n) {
        const auto& choice = choices_[n];
        const QString description =
            choice.description.empty() ? tr("(no description)") : text(choice.description);
        auto* row = new QTreeWidgetItem(list_, {QString::number(n + 1), description, text(choice.modality),
                                                QString("%1 × %2").arg(choice.size.x).arg(choice.size.y),
                                                spacingOf(choice), QString::number(choice.images)});
        row->setToolTip(1, text(choice.uid));
        row->setTextAlignment(5, Qt::AlignRight);
        if (choice.images == largest->images && list_->currentItem() == nullptr) {
            list_->setCurrentItem(row); // most often it is what was meant
        }
    }
    for (int i = 0; i < list_->columnCount(); ++i) {
        list_->resizeColumnToContents(i);
    }
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
}

void SeriesDialog::takeCurrent() {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    if (row < 0) {
        return;
    }
    const std::string& uid = choices_[std::size_t(row)].uid;
    const auto same =
        std::count_if(choices_.begin(), choices_.end(), [&](const auto& c) { return c.uid == uid; });
    // By its identifier, which stays when files are added, unless parts of one series are the choices.
    request_.series = !uid.empty() && same == 1 ? uid : std::to_string(row + 1);
    accept();
    emit chosen(request_);
}

} // namespace vs::desktop
