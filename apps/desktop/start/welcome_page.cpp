// SPDX-License-Identifier: Apache-2.0
#include "start/welcome_page.h"

#include "model/keepers/case_documents.h"
#include "model/keepers/slice_pictures.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"
#include "start/card_grid.h"
#include "start/recovery_list.h"
#include "start/start_card.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kMostPerRow = 5;
constexpr int kMargin = 36;
} // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent), pictures_(new SlicePictures(this)) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, kMargin, 0, kMargin);
    column->setSpacing(12);
    addHead(column);
    recovery_ = new RecoveryList;
    column->addWidget(recovery_);
    connect(recovery_, &RecoveryList::recoverRequested, this, &WelcomePage::recoverRequested);
    recent_ = addSection(column, tr("Recent"));
    examples_ = addSection(column, tr("Examples on this machine"));
    cases_ = addSection(column, tr("Cases, played step by step"));
    column->addStretch(1);
    content->setMaximumWidth(kMostPerRow * (StartCard::kSize.width() + CardGrid::kGap) - CardGrid::kGap);

    auto* middle = new QWidget;
    auto* row = new QHBoxLayout(middle);
    row->setContentsMargins(kMargin, 0, kMargin, 0);
    row->addStretch(1);
    row->addWidget(content, 1000); // all the room up to its greatest width
    row->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(middle);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    constexpr int kCalmMs = 1500; // a program that was started to open something has left by then
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, &WelcomePage::makePictures);
    connect(pictures_, &SlicePictures::made, this, [this] {
        if (isVisible()) {
            refresh();
        }
    });
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);
}

void WelcomePage::addHead(QVBoxLayout* column) {
    mark_ = new QLabel;
    auto* title = new QLabel(tr("Volume Studio"));
    QFont font = title->font();
    font.setPointSizeF(2.0 * font.pointSizeF());
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(2);
    texts->addWidget(title);
    texts->addWidget(makeQuietLabel(
        tr("Reshape a 3D scan with your pen: peel it, drill it, and let what you mark grow.")));
    auto* head = new QHBoxLayout;
    head->setSpacing(16);
    head->addWidget(mark_);
    head->addLayout(texts, 1);
    column->addLayout(head);

    auto* open = named(new QPushButton(tr("Open a file…")), "openButton", tr("Open a file"));
    auto* folder =
        named(new QPushButton(tr("Open a DICOM folder…")), "openFolderButton", tr("Open a DICOM folder"));
    folder->setMinimumHeight(open->sizeHint().height());
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(10);
    buttons->addWidget(open);
    auto* block =
        named(new QPushButton(tr("Sculpt from nothing…")), "blockButton", tr("Sculpt from nothing"));
    block->setMinimumHeight(open->sizeHint().height());
    buttons->addWidget(folder);
    buttons->addWidget(block);
    auto* hint = makeQuietLabel(tr("or drop a file or a folder anywhere in this window\n"
                                   "DICOM · NIfTI · NRRD · MetaImage · VTK · raw · sessions"));
    hint->setWordWrap(true);
    buttons->addSpacing(8);
    buttons->addWidget(hint, 1);
    column->addSpacing(6);
    column->addLayout(buttons);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);
    connect(block, &QPushButton::clicked, this, &WelcomePage::blockRequested);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::openFolderRequested);
}

WelcomePage::Section WelcomePage::addSection(QVBoxLayout* column, const QString& title) {
    Section section{new QLabel(title), new CardGrid};
    section.title->setObjectName("sectionTitle");
    section.cards->setAccessibleName(title);
    column->addSpacing(14);
    column->addWidget(section.title);
    column->addWidget(section.cards);
    return section;
}

void WelcomePage::refresh() {
    // The keyboard stays where it was among the new cards.
    const QString focused = focusWidget() != nullptr ? focusWidget()->objectName() : QString();
    mark_->setPixmap(icon("peel").pixmap(QSize(64, 64), devicePixelRatioF()));
    recovery_->refresh();
    const auto recent = recentDocuments();
    auto examples = exampleDocuments();
    std::erase_if(examples, [&recent](const KnownDocument& example) {
        return std::any_of(recent.begin(), recent.end(),
                           [&](const KnownDocument& other) { return other.path() == example.path(); });
    });
    fill(recent_, recent, "recent", true);
    fill(examples_, examples, "example", false);
    fill(cases_, caseDocuments(), "case", false);
    if (auto* card = findChild<StartCard*>(focused); card != nullptr && !focused.isEmpty()) {
        card->setFocus();
    }
}

void WelcomePage::fill(Section& section, const std::vector<KnownDocument>& documents, const QString& name,
                       bool canForget) {
    std::vector<StartCard*> cards;
    for (const KnownDocument& document : documents) {
        auto* card = new StartCard(document, name + QString::number(cards.size()));
        connect(card, &StartCard::clicked, this, [this, document] {
            if (document.isMissing()) {
                refresh();
            } else {
                emit documentChosen(document.request);
            }
        });
        if (canForget) {
            card->offerForgetting();
            connect(card, &StartCard::forgetRequested, this, [this, document] {
                forgetDocument(document);
                refresh();
            });
        }
        cards.push_back(card);
    }
    section.cards->setCards(cards);
    section.title->setVisible(!cards.empty());
    section.cards->setVisible(!cards.empty());
}

// Pictures drawn in the colours of another theme are drawn anew.
void WelcomePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible()) {
        refresh();
    }
}

void WelcomePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
    calm_.start();
}

void WelcomePage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    calm_.stop();
}

void WelcomePage::makePictures() {
    for (const KnownDocument& document : exampleDocuments()) {
        pictures_->want(document);
    }
}

} // namespace vs::desktop
