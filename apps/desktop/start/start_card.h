// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QPixmap>

class QToolButton;

namespace vs::desktop {

struct KnownDocument;

// A document on the start screen: its picture, name and a line about it, with a badge that tells a scan with
// segments (coloured) from a raw one (grey). One that is missing is greyed and cannot be opened.
class StartCard : public QAbstractButton {
    Q_OBJECT

public:
    static constexpr QSize kSize{216, 186};

    // `index` makes the object's name: "recent0", "example2".
    StartCard(const KnownDocument& document, const QString& objectName, QWidget* parent = nullptr);
    // Offers to forget the document: by its button, or by Delete.
    void offerForgetting();

    [[nodiscard]] QSize sizeHint() const override { return kSize; }

signals:
    void forgetRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintPicture(QPainter& painter, const QRectF& frame) const;
    void paintBadge(QPainter& painter, const QRectF& frame) const;

    QPixmap picture_;
    QString details_;
    QString about_; // the badge's meaning, for the tooltip
    bool isSession_;
    bool hasSegments_;
    bool isMissing_;
    QToolButton* forget_ = nullptr;
};

} // namespace vs::desktop
