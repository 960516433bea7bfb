// SPDX-License-Identifier: Apache-2.0
#include "dialogs/correction_picture.h"

#include "parts/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr int kSide = 176;
constexpr QColor kOutside{11, 13, 15}; // as slices have it

// The value between the four voxels of a slice around a place; at its border the outermost go on.
double valueAt(const volume::Volume& volume, const render::SliceGeometry& slice, glm::dvec3 voxel) {
    const glm::ivec3 last = volume.geometry.dims - 1;
    const glm::ivec3 base(glm::floor(voxel));
    const glm::dvec3 part = voxel - glm::dvec3(base);
    double value = 0;
    for (int corner = 0; corner < 4; ++corner) {
        glm::ivec3 place = base;
        double weight = 1;
        for (const int axis : {slice.acrossAxis(), slice.downAxis()}) {
            const bool isNext = (axis == slice.acrossAxis() ? corner & 1 : corner >> 1) != 0;
            place[axis] += isNext ? 1 : 0;
            weight *= isNext ? part[axis] : 1 - part[axis];
        }
        value += weight > 0 ? weight * volume.at(glm::clamp(place, glm::ivec3(0), last)) : 0;
    }
    return value;
}

bool isInside(glm::dvec3 voxel, glm::ivec3 dims) {
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(-0.5))) &&
           glm::all(glm::lessThanEqual(voxel, glm::dvec3(dims) - 0.5));
}

QImage pictureOf(const volume::Volume& volume, const Range& window, const render::SliceGeometry& slice,
                 QSize size) {
    const int middle = slice.count() / 2;
    const double index = middle;
    render::SliceView view{slice.kind(), middle, {}, 1, {size.width(), size.height()}};
    view.pixelMm = render::pixelMmToShowAll(slice, view.size);
    QImage image(size, QImage::Format_RGB32);
    image.fill(kOutside);
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
            const glm::dvec3 voxel = slice.voxelAt(view.placeAt(glm::dvec2(x, y) + 0.5), index);
            if (isInside(voxel, volume.geometry.dims)) {
                const double value = valueAt(volume, slice, voxel);
                const double share = (value - window.lo) / std::max(window.width(), 1e-9);
                const int grey =
                    std::isfinite(share) ? int(std::lround(255 * std::clamp(share, 0.0, 1.0))) : 0;
                image.setPixel(x, y, qRgb(grey, grey, grey));
            }
        }
    }
    return image;
}

// Read on any picture.
void drawLetters(QPainter& painter, const QRectF& box, int flags, const std::string& letters) {
    const QString text = QString::fromStdString(letters);
    painter.setPen(QColor(0, 0, 0, 190));
    for (const QPointF offset : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)}) {
        painter.drawText(box.translated(offset), flags, text);
    }
    painter.setPen(theme::kPen);
    painter.drawText(box, flags, text);
}

} // namespace

CorrectionPicture::CorrectionPicture(const volume::Volume& volume, const Range& window,
                                     render::SliceKind kind)
    : volume_(volume), window_(window), kind_(kind), grid_(volume.geometry) {
    setFixedSize(kSide, kSide);
}

void CorrectionPicture::show(const volume::GridGeometry& grid) {
    grid_ = grid;
    update();
}

void CorrectionPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const render::SliceGeometry slice(grid_, kind_);
    const QImage picture = pictureOf(volume_, window_, slice, size() * devicePixelRatioF());
    painter.drawImage(QRectF(rect()), picture, QRectF(picture.rect()));
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const auto letters = slice.letters();
    const QRectF box = QRectF(rect()).adjusted(6, 3, -6, -3);
    drawLetters(painter, box, Qt::AlignLeft | Qt::AlignVCenter, letters.left);
    drawLetters(painter, box, Qt::AlignRight | Qt::AlignVCenter, letters.right);
    drawLetters(painter, box, Qt::AlignHCenter | Qt::AlignTop, letters.top);
    drawLetters(painter, box, Qt::AlignHCenter | Qt::AlignBottom, letters.bottom);
}

} // namespace vs::desktop
