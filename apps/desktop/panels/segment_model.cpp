// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_model.h"

#include "model/segments/segment_controller.h"
#include "model/texts/quantities.h"
#include "parts/icons.h"
#include "parts/theme.h"

#include <QIcon>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace vs::desktop {

namespace {

// A swatch: opaque on the left, as it is seen on the right.
QIcon swatchOf(const studio::SegmentInfo& segment) {
    constexpr int kSide = 36; // painted large, shown at half the size or less
    QPixmap pixmap(kSide, kSide);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor colour =
        QColor::fromRgbF(float(segment.colour.r), float(segment.colour.g), float(segment.colour.b));
    painter.setPen(Qt::NoPen);
    const QRectF all(2, 2, kSide - 4, kSide - 4);
    QColor seen = colour;
    seen.setAlphaF(segment.isVisible ? float(segment.opacity) : 0.0F);
    painter.setBrush(seen);
    painter.drawRoundedRect(all, 6, 6);
    painter.setClipRect(QRectF(0, 0, kSide / 2.0, kSide));
    painter.setBrush(colour);
    painter.drawRoundedRect(all, 6, 6);
    painter.setClipping(false);
    painter.setPen(QPen(colour, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(all, 6, 6);
    painter.end();
    QIcon swatch(pixmap);
    swatch.addPixmap(pixmap, QIcon::Selected); // not tinted
    return swatch;
}

using Treatment = studio::SegmentInfo::Treatment;

QString lockTip(const studio::SegmentInfo& info) {
    if (info.isLocked) {
        return SegmentModel::tr("Locked: no tool changes it, nor cuts it");
    }
    return info.treatment == Treatment::Spare ? SegmentModel::tr("Tools spare it: click to lock it")
           : info.treatment == Treatment::TakeOnly
               ? SegmentModel::tr("Tools take only this: click to lock it")
               : SegmentModel::tr("Click to lock it");
}

const char* lockIcon(const studio::SegmentInfo& info) {
    if (info.isLocked) {
        return "lock";
    }
    return info.treatment == Treatment::Spare      ? "spare"
           : info.treatment == Treatment::TakeOnly ? "takeOnly"
                                                   : "unlock";
}

QString amount(double millilitres) { return millilitres <= 0 ? QString("\u2013") : volumeText(millilitres); }

} // namespace

SegmentModel::SegmentModel(SegmentController& segments, QObject* parent)
    : QAbstractTableModel(parent), segments_(segments) {
    refresh();
}

int SegmentModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(shown_.segments.size());
}

const studio::SegmentInfo& SegmentModel::segment(int row) const {
    return shown_.segments.at(std::size_t(row));
}

int SegmentModel::workingRow() const {
    const auto found =
        std::find_if(shown_.segments.begin(), shown_.segments.end(),
                     [&](const studio::SegmentInfo& segment) { return segment.label == shown_.atWork; });
    return int(found - shown_.segments.begin());
}

QVariant SegmentModel::data(const QModelIndex& index, int role) const {
    const studio::SegmentInfo& info = segment(index.row());
    if (role == kSortRole) {
        return sortKey(index);
    }
    if (role == Qt::AccessibleTextRole || role == Qt::ToolTipRole) {
        switch (index.column()) {
        case Colour:
            return tr("Colour of %1: click to choose another").arg(QString::fromStdString(info.name));
        case Name:
            return role == Qt::ToolTipRole ? tr("New strokes go to the segment that is marked; double-click "
                                                "or F2 to rename it")
                                           : QString::fromStdString(info.name);
        case Volume:
            return role == Qt::ToolTipRole ? tr("What is shown of it now")
                                           : millilitres_[std::size_t(index.row())];
        case Eye:
            return info.isVisible ? tr("Seen: click to hide it") : tr("Hidden: click to show it");
        default:
            return lockTip(info);
        }
    }
    if (role == Qt::DecorationRole) {
        switch (index.column()) {
        case Colour:
            return swatchOf(info);
        case Eye:
            return icon(info.isVisible ? "eye" : "eyeOff");
        case Lock:
            return icon(lockIcon(info));
        default:
            return {};
        }
    }
    if ((role == Qt::DisplayRole || role == Qt::EditRole) && index.column() == Name) {
        return QString::fromStdString(info.name);
    }
    if (role == Qt::DisplayRole && index.column() == Volume) {
        return millilitres_[std::size_t(index.row())];
    }
    if (role == Qt::TextAlignmentRole && index.column() == Volume) {
        return int(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ForegroundRole && (index.column() == Volume || !info.isVisible)) {
        return theme::kQuiet;
    }
    return {};
}

// Those that are seen, and those that are locked or that tools treat apart, stand before the others.
QVariant SegmentModel::sortKey(const QModelIndex& index) const {
    const studio::SegmentInfo& info = segment(index.row());
    switch (index.column()) {
    case Name:
        return QString::fromStdString(info.name);
    case Volume:
        return segments_.millilitres(info.label);
    case Eye:
        return info.isVisible ? 0 : 1;
    case Lock:
        return info.isLocked ? 0 : 1 + (int(Treatment::TakeOnly) - int(info.treatment));
    default:
        return info.label;
    }
}

QVariant SegmentModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::ToolTipRole) {
        return tr("Click to sort by it, the other way round, and as they were made");
    }
    if (role == Qt::DecorationRole && (section == Eye || section == Lock)) {
        return icon(section == Eye ? "eye" : "lock");
    }
    if (role == Qt::DisplayRole && (section == Name || section == Volume)) {
        return section == Name ? tr("Name") : tr("Volume");
    }
    return {};
}

bool SegmentModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    return role == Qt::EditRole && index.column() == Name &&
           segments_.rename(segment(index.row()).name, value.toString());
}

Qt::ItemFlags SegmentModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Name ? usual | Qt::ItemIsEditable : usual;
}

void SegmentModel::toggle(const QModelIndex& index) {
    const studio::SegmentInfo info = segment(index.row());
    if (index.column() == Eye) {
        segments_.setVisible(info.name, !info.isVisible);
    } else if (index.column() == Lock) {
        segments_.setLocked(info.name, !info.isLocked);
    }
}

void SegmentModel::refresh() {
    const studio::SegmentList now = segments_.list();
    std::vector<QString> amounts;
    for (const studio::SegmentInfo& info : now.segments) {
        amounts.push_back(amount(segments_.millilitres(info.label)));
    }
    if (now == shown_ && amounts == millilitres_) {
        return;
    }
    const bool isOther = now.segments.size() != shown_.segments.size() || millilitres_.empty();
    if (isOther) {
        beginResetModel();
    }
    shown_ = now;
    millilitres_ = std::move(amounts);
    if (isOther) {
        endResetModel();
    } else {
        emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    }
}

} // namespace vs::desktop
