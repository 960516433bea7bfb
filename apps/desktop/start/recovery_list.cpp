// SPDX-License-Identifier: Apache-2.0
#include "start/recovery_list.h"

#include "model/texts/language.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

RecoveryList::RecoveryList(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(8);
    hide();
}

void RecoveryList::refresh() {
    for (QFrame* row : rows_) {
        row->hide();
        row->deleteLater(); // its button may have asked for this
    }
    rows_.clear();
    for (const LostWork& lost : RecoveryKeeper::lostWork()) {
        rows_.push_back(makeRow(lost, int(rows_.size())));
        layout()->addWidget(rows_.back());
    }
    setVisible(!rows_.empty());
}

QFrame* RecoveryList::makeRow(const LostWork& lost, int number) {
    auto* row = new QFrame;
    row->setObjectName("recovery");
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(14, 10, 12, 10);
    line->setSpacing(10);
    auto* picture = new QLabel;
    picture->setPixmap(icon("recover").pixmap(QSize(26, 26), devicePixelRatioF()));
    line->addWidget(picture);

    const QString when = textLocale().toString(lost.when, "d MMM yyyy, HH:mm");
    auto* texts = new QVBoxLayout;
    texts->setSpacing(1);
    auto* title =
        new QLabel(lost.problem.isEmpty()
                       ? (lost.edits == 1 ? tr("%1: one edit was not saved").arg(lost.name)
                                          : tr("%1: %2 edits were not saved").arg(lost.name).arg(lost.edits))
                       : tr("%1 cannot be recovered").arg(lost.name));
    title->setObjectName("cardTitle");
    title->setTextFormat(Qt::PlainText);
    auto* about = makeQuietLabel(lost.problem.isEmpty()
                                     ? tr("The program ended without being closed. Last edit: %1").arg(when)
                                     : lost.problem);
    about->setWordWrap(true);
    texts->addWidget(title);
    texts->addWidget(about);
    line->addLayout(texts, 1);

    const QString suffix = QString::number(number);
    auto* discard =
        named(new QPushButton(tr("Discard…")), "discard", tr("Discard the edits of %1").arg(lost.name));
    discard->setObjectName("discard" + suffix);
    connect(discard, &QPushButton::clicked, this, [this, lost] { askToDiscard(lost); });
    line->addWidget(discard);
    if (lost.problem.isEmpty()) {
        auto* recover =
            named(new QPushButton(tr("Recover")), "recover", tr("Recover the edits of %1").arg(lost.name));
        recover->setObjectName("recover" + suffix);
        recover->setProperty("primary", true);
        connect(recover, &QPushButton::clicked, this, [this, lost] { emit recoverRequested(lost); });
        line->addWidget(recover);
    }
    return row;
}

void RecoveryList::askToDiscard(const LostWork& lost) {
    QMessageBox question(QMessageBox::Warning, tr("Volume Studio"),
                         tr("Discard the edits of %1 for good?").arg(lost.name), QMessageBox::NoButton, this);
    question.setObjectName("discardQuestion");
    auto* discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    discard->setObjectName("discardForGood");
    question.setDefaultButton(question.addButton(tr("&Keep"), QMessageBox::RejectRole));
    question.exec();
    if (question.clickedButton() == discard) {
        RecoveryKeeper::discard(lost);
    }
    refresh();
}

} // namespace vs::desktop
