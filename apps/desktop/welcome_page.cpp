// SPDX-License-Identifier: Apache-2.0
#include "welcome_page.h"

#include "icons.h"
#include "panel_parts.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(14);
    column->addStretch(3);
    auto* picture = new QLabel;
    picture->setPixmap(icon("peel").pixmap(QSize(96, 96), devicePixelRatioF()));
    picture->setAlignment(Qt::AlignCenter);
    column->addWidget(picture);

    auto* title = new QLabel(tr("Volume Studio"));
    QFont font = title->font();
    font.setPointSizeF(2.2 * font.pointSizeF());
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    title->setAlignment(Qt::AlignCenter);
    column->addWidget(title);
    auto* text =
        makeQuietLabel(tr("Reshape a 3D scan with your pen: peel it, drill it, and let what you mark grow.\n"
                          "Open a volume or a session, or drop a file or a DICOM folder here."));
    text->setAlignment(Qt::AlignCenter);
    column->addWidget(text);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(10);
    auto* open = named(new QPushButton(tr("Open a file…")), "openButton", tr("Open a file"));
    auto* folder =
        named(new QPushButton(tr("Open a DICOM folder…")), "openFolderButton", tr("Open a DICOM folder"));
    folder->setMinimumHeight(open->sizeHint().height());
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(folder);
    buttons->addStretch(1);
    column->addSpacing(8);
    column->addLayout(buttons);
    auto* formats = makeQuietLabel(tr("DICOM · NIfTI · NRRD · MetaImage · VTK · raw"));
    formats->setAlignment(Qt::AlignCenter);
    column->addWidget(formats);
    column->addStretch(4);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::openFolderRequested);
}

} // namespace vs::desktop
