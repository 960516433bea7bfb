// SPDX-License-Identifier: Apache-2.0
#include "transfer/function_gallery.h"

#include "model/document/function_editor.h"
#include "model/texts/library_texts.h"
#include "parts/panel_parts.h"
#include "transfer/function_picture.h"

#include "render/colours/colour_map.h"
#include "render/colours/function_edits.h"
#include "render/colours/transfer_function_json.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

constexpr QSize kThumbnail{148, 30};
constexpr QSize kMapPicture{148, 10};
constexpr int kWidth = 172; // of a button: the longest name fits
constexpr int kColumns = 3;

QImage plainPicture(const QColor& colour) {
    QImage image(kThumbnail, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

} // namespace

FunctionGallery::FunctionGallery(FunctionEditor& editor, QWidget* parent)
    : QFrame(parent, Qt::Popup), editor_(editor) {
    named(this, "functionGallery", tr("Transfer functions and colour tables"));
    setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(6);
    column->addWidget(makeQuietLabel(tr("Transfer functions")));
    auto* presets = new QGridLayout;
    presets->setSpacing(4);
    fillPresets(presets);
    column->addLayout(presets);
    column->addWidget(makeQuietLabel(tr("Colour table of the points")));
    auto* maps = new QGridLayout;
    maps->setSpacing(4);
    fillMaps(maps);
    column->addLayout(maps);
}

QToolButton* FunctionGallery::makeButton(const std::string& name, const QString& text, const QString& tip,
                                         const QImage& image, const std::function<void()>& take) {
    auto* button = named(new QToolButton, name.c_str(), text);
    button->setText(text);
    button->setToolTip(tip);
    button->setIcon(QPixmap::fromImage(image));
    button->setIconSize(image.size());
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setProperty("choice", true);
    button->setFixedWidth(kWidth);
    connect(button, &QToolButton::clicked, this, [this, take] {
        close();
        take();
    });
    return button;
}

void FunctionGallery::fillPresets(QGridLayout* grid) {
    const QColor ground = palette().color(QPalette::Base);
    int n = 0;
    const auto add = [&](QToolButton* button) {
        grid->addWidget(button, n / kColumns, n % kColumns);
        ++n;
    };
    add(makeButton("preset.none", tr("The mode's own"),
                   tr("Ivory surfaces and white rays; the volume as the displayed range has it"),
                   plainPicture(QColor(0xe8, 0xdc, 0xc4)), [this] { editor_.take({}); }));
    for (const std::string& name : render::presetNames()) {
        const auto preset = render::findPreset(name);
        add(makeButton("preset." + name, libraryText(preset->name), libraryText(preset->description),
                       functionPicture(*preset, kThumbnail, ground),
                       [this, preset] { editor_.take(preset); }));
    }
}

void FunctionGallery::fillMaps(QGridLayout* grid) {
    int n = 0;
    const auto add = [&](QToolButton* button) {
        grid->addWidget(button, n / kColumns, n % kColumns);
        ++n;
    };
    for (const render::ColourMap& map : render::colourMaps()) {
        const std::string name(map.name);
        add(makeButton("map." + name, libraryText(name), libraryText(map.description),
                       colourMapPicture(name, kMapPicture), [this, name] { editor_.useColourMap(name); }));
    }
    QImage own(kMapPicture, QImage::Format_RGB32); // colours side by side
    for (int x = 0; x < own.width(); ++x) {
        const auto colour =
            render::kSafeColours[std::size_t(x) * render::kSafeColours.size() / std::size_t(own.width())];
        for (int y = 0; y < own.height(); ++y) {
            own.setPixelColor(x, y, QColor(colour.x, colour.y, colour.z));
        }
    }
    add(makeButton("map.none", tr("their own"), tr("Each point has a colour of its own"), own,
                   [this] { editor_.useColourMap({}); }));
}

void FunctionGallery::showAt(const QWidget& widget) {
    adjustSize();
    const QRect screen = widget.screen()->availableGeometry();
    QPoint corner = widget.mapToGlobal(QPoint(0, widget.height() + 2));
    corner.setY(std::max(screen.top(), std::min(corner.y(), screen.bottom() - height())));
    corner.setX(std::max(screen.left(), std::min(corner.x(), screen.right() - width())));
    move(corner);
    show();
    if (auto* first = findChild<QToolButton*>()) {
        first->setFocus(Qt::PopupFocusReason);
    }
}

void FunctionGallery::keyPressEvent(QKeyEvent* event) {
    const auto turn = [&](bool next) { focusNextPrevChild(next); };
    switch (event->key()) {
    case Qt::Key_Right:
        return turn(true);
    case Qt::Key_Left:
        return turn(false);
    case Qt::Key_Down:
        for (int i = 0; i < kColumns; ++i) {
            turn(true);
        }
        return;
    case Qt::Key_Up:
        for (int i = 0; i < kColumns; ++i) {
            turn(false);
        }
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (auto* button = qobject_cast<QToolButton*>(focusWidget())) {
            button->click();
        }
        return;
    default:
        QFrame::keyPressEvent(event);
    }
}

} // namespace vs::desktop
