// SPDX-License-Identifier: Apache-2.0
#include "start/start_card.h"

#include "model/keepers/recent_documents.h"
#include "model/texts/language.h"
#include "model/texts/texts.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"
#include "parts/theme.h"

#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

#include <array>

namespace vs::desktop {

namespace {

constexpr int kPictureHeight = 135;
constexpr double kRound = 7;

// "today 14:05", "yesterday", "12 Mar 2026".
QString whenSeen(const QDateTime& time) {
    if (!time.isValid()) {
        return {};
    }
    const qint64 days = time.date().daysTo(QDate::currentDate());
    return days == 0   ? tr("today %1").arg(time.time().toString("HH:mm"))
           : days == 1 ? tr("yesterday")
                       : textLocale().toString(time.date(), "d MMM yyyy");
}

QString placeOf(const KnownDocument& document) {
    QString folder = QFileInfo(document.path()).path();
    const QString home = QDir::homePath();
    return folder.startsWith(home + "/") ? "~" + folder.mid(home.size()) : folder;
}

} // namespace

StartCard::StartCard(const KnownDocument& document, const QString& objectName, QWidget* parent)
    : QAbstractButton(parent), picture_(document.picturePath()), isSession_(document.isSession()),
      hasSegments_(document.hasSegments), isMissing_(document.isMissing()) {
    setObjectName(objectName);
    setText(document.name());
    setProperty("report", document.name());
    const QString when = whenSeen(document.seen);
    details_ = isMissing_       ? tr("not found in %1").arg(placeOf(document))
               : when.isEmpty() ? document.details
                                : when + " · " + document.details;
    about_ = isMissing_               ? tr("There is no such file any more")
             : document.request.given ? tr("Comes with the program, and is played step by step")
             : hasSegments_           ? tr("Has segments")
                                      : tr("A raw scan, without segments");
    setAccessibleName(document.name() + ", " + details_ + ", " + about_);
    setToolTip((document.request.given ? document.details : QDir::toNativeSeparators(document.path())) +
               "\n" + about_);
    setFixedSize(kSize);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(isMissing_ ? Qt::ArrowCursor : Qt::PointingHandCursor);
}

void StartCard::offerForgetting() {
    forget_ = makeIconButton("clear", "", tr("Forget %1").arg(text()), tr("Take it off this list (Delete)"));
    forget_->setObjectName("forget_" + objectName());
    forget_->setParent(this);
    forget_->setIconSize(QSize(14, 14));
    forget_->setProperty("onPicture", true);
    forget_->setFixedSize(24, 24);
    forget_->move(width() - 24 - 6, 6);
    forget_->setVisible(isMissing_);
    connect(forget_, &QToolButton::clicked, this, &StartCard::forgetRequested);
}

void StartCard::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (forget_ != nullptr && (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)) {
        emit forgetRequested();
    } else if (isEnter) {
        click();
    } else {
        QAbstractButton::keyPressEvent(event);
    }
}

void StartCard::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    if (forget_ != nullptr) {
        forget_->show();
    }
    update();
}

void StartCard::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    if (forget_ != nullptr) {
        forget_->setVisible(isMissing_);
    }
    update();
}

void StartCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    const bool isActive = hasFocus() || (underMouse() && !isMissing_);
    painter.setPen(QPen(isActive ? theme::kAccent : theme::kLine, hasFocus() ? 2 : 1));
    painter.setBrush(isDown() ? theme::kField : theme::kPanel);
    painter.drawRoundedRect(frame, kRound, kRound);
    paintPicture(painter, QRectF(frame.left() + 1, frame.top() + 1, frame.width() - 2, kPictureHeight));
    paintBadge(painter, frame);

    const QRectF lines = frame.adjusted(10, kPictureHeight + 7, -10, -6);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(isMissing_ ? theme::kDisabled : theme::kText);
    painter.drawText(lines, Qt::AlignLeft | Qt::AlignTop,
                     QFontMetricsF(bold).elidedText(text(), Qt::ElideMiddle, lines.width()));
    painter.setFont(font());
    painter.setPen(isMissing_ ? theme::kDisabled : theme::kQuiet);
    painter.drawText(lines, Qt::AlignLeft | Qt::AlignBottom,
                     QFontMetricsF(font()).elidedText(details_, Qt::ElideRight, lines.width()));
}

void StartCard::paintPicture(QPainter& painter, const QRectF& frame) const {
    QPainterPath top; // round above, straight below
    top.setFillRule(Qt::WindingFill);
    top.addRoundedRect(frame, kRound - 1, kRound - 1);
    top.addRect(frame.adjusted(0, kRound, 0, 0));
    painter.save();
    painter.setClipPath(top);
    painter.fillRect(frame, QColor(0x0c, 0x0e, 0x10)); // as the view behind a scan, in either theme
    if (!picture_.isNull()) {
        painter.setOpacity(isMissing_ ? 0.25 : 1);
        const QSizeF size = QSizeF(picture_.size()).scaled(frame.size(), Qt::KeepAspectRatioByExpanding);
        QRectF target(QPointF(), size);
        target.moveCenter(frame.center());
        painter.drawPixmap(target, picture_, QRectF(picture_.rect()));
    } else {
        QRect place(0, 0, 56, 56);
        place.moveCenter(frame.center().toPoint());
        painter.setOpacity(0.55);
        desktop::icon(isSession_ ? "session" : "raw")
            .paint(&painter, place, Qt::AlignCenter, QIcon::Disabled);
    }
    painter.restore();
}

// Layers in the colours that segments have, or in grey.
void StartCard::paintBadge(QPainter& painter, const QRectF& frame) const {
    const QRectF badge(frame.left() + 8, frame.top() + kPictureHeight - 30, 24, 24);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x1f, 0x22, 0x26, 0xd8));
    painter.drawRoundedRect(badge, 6, 6);
    const QColor grey(0x8b, 0x94, 0x9d);
    const bool isColoured = hasSegments_ && !isMissing_;
    const std::array colours{isColoured ? QColor(0x00, 0x9e, 0x73) : grey.darker(140),
                             isColoured ? QColor(0xe6, 0x9f, 0x00) : grey.darker(118),
                             isColoured ? QColor(0x56, 0xb4, 0xe9) : grey};
    for (int layer = 0; layer < 3; ++layer) {
        const QPointF middle = badge.center() + QPointF(0, 3.5 - 3.5 * layer);
        painter.setBrush(colours[std::size_t(layer)]);
        painter.drawPolygon(QPolygonF{middle + QPointF(-8, 0), middle + QPointF(0, -4),
                                      middle + QPointF(8, 0), middle + QPointF(0, 4)});
    }
    painter.restore();
}

} // namespace vs::desktop
