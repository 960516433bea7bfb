// SPDX-License-Identifier: Apache-2.0
#include "start/recovery_list.h"

#include "model/texts/language.h"
#include "model/texts/texts.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"

#include <QDateTime>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

QString nameOf(const studio::LostWork& lost) {
    return lost.name.empty() ? tr("Made from nothing") : QString::fromStdString(lost.name);
}

QString titleOf(const studio::LostWork& lost) {
    if (!lost.problem.empty()) {
        return tr("%1 cannot be recovered").arg(nameOf(lost));
    }
    return lost.edits == 1 ? tr("%1: one edit was not saved").arg(nameOf(lost))
                           : tr("%1: %2 edits were not saved").arg(nameOf(lost)).arg(lost.edits);
}

QStringList textsAbout(const studio::LostWork& lost) {
    if (!lost.problem.empty()) {
        return {QString::fromStdString(lost.problem)};
    }
    const QString when = textLocale().toString(QDateTime::fromSecsSinceEpoch(lost.when), "d MMM yyyy, HH:mm");
    QStringList texts{tr("The program ended without being closed. Last edit: %1").arg(when)};
    if (!lost.missing.empty()) {
        texts.push_back(tr("Its volume %1 is not there").arg(textOf(lost.missing)));
    }
    if (!lost.leftOut.empty()) {
        texts.push_back(tr("Not all of it can be read: %1").arg(QString::fromStdString(lost.leftOut)));
    }
    return texts;
}

} // namespace

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
    for (const studio::LostWork& lost : studio::lostWork()) {
        rows_.push_back(makeRow(lost, int(rows_.size())));
        layout()->addWidget(rows_.back());
    }
    setVisible(!rows_.empty());
}

QFrame* RecoveryList::makeRow(const studio::LostWork& lost, int number) {
    auto* row = new QFrame;
    row->setObjectName("recovery");
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(14, 10, 12, 10);
    line->setSpacing(10);
    auto* picture = new QLabel;
    picture->setPixmap(icon("recover").pixmap(QSize(26, 26), devicePixelRatioF()));
    line->addWidget(picture);

    auto* texts = new QVBoxLayout;
    texts->setSpacing(1);
    auto* title = new QLabel(titleOf(lost));
    title->setObjectName("cardTitle");
    title->setTextFormat(Qt::PlainText);
    texts->addWidget(title);
    for (const QString& text : textsAbout(lost)) {
        auto* about = makeQuietLabel(text);
        about->setTextFormat(Qt::PlainText);
        about->setWordWrap(true);
        texts->addWidget(about);
    }
    line->addLayout(texts, 1);

    const QString suffix = QString::number(number);
    auto* discard =
        named(new QPushButton(tr("Discard…")), "discard", tr("Discard the edits of %1").arg(nameOf(lost)));
    discard->setObjectName("discard" + suffix);
    connect(discard, &QPushButton::clicked, this, [this, lost] { askToDiscard(lost); });
    line->addWidget(discard);
    if (lost.problem.empty()) {
        auto* recover = named(new QPushButton(lost.missing.empty() ? tr("Recover") : tr("Find and recover…")),
                              "recover", tr("Recover the edits of %1").arg(nameOf(lost)));
        recover->setObjectName("recover" + suffix);
        recover->setProperty("primary", true);
        connect(recover, &QPushButton::clicked, this, [this, lost] { emit recoverRequested(lost); });
        line->addWidget(recover);
    }
    return row;
}

void RecoveryList::askToDiscard(const studio::LostWork& lost) {
    QMessageBox question(QMessageBox::Warning, tr("Volume Studio"),
                         tr("Discard the edits of %1 for good?").arg(nameOf(lost)), QMessageBox::NoButton,
                         this);
    question.setObjectName("discardQuestion");
    auto* discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    discard->setObjectName("discardForGood");
    question.setDefaultButton(question.addButton(tr("&Keep"), QMessageBox::RejectRole));
    question.exec();
    if (question.clickedButton() == discard) {
        if (const auto held = studio::HeldJournal::hold(lost.journal)) { // else another window has it in hand
            held->remove();
        }
    }
    refresh();
}

} // namespace vs::desktop
