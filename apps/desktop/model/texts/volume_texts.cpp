// SPDX-License-Identifier: Apache-2.0
#include "model/texts/volume_texts.h"

#include "model/texts/texts.h"

#include <QLocale>
#include <QStringList>

#include <array>

namespace vs::desktop {

namespace {

QString number(double value) { return QString::number(value, 'g', 6); }

QString three(glm::dvec3 values, const QString& between) {
    return QStringList{number(values.x), number(values.y), number(values.z)}.join(between);
}

QString directionName(char letter) {
    switch (letter) {
    case 'L':
        return tr("left");
    case 'R':
        return tr("right");
    case 'P':
        return tr("posterior");
    case 'A':
        return tr("anterior");
    case 'S':
        return tr("superior");
    default:
        return tr("inferior");
    }
}

QString orientationText(const volume::GridGeometry& grid) {
    const std::string code = grid.orientationCode();
    return tr("%1: columns run to %2, rows to %3, slices to %4")
        .arg(QString::fromStdString(code), directionName(code[0]), directionName(code[1]),
             directionName(code[2]));
}

QString valuesText(const volume::Volume& volume) {
    QString text = tr("%1 to %2").arg(number(volume.range.lo), number(volume.range.hi));
    if (!volume.unit.empty()) {
        text += ' ' + QString::fromStdString(volume.unit);
    }
    if (volume.nonFiniteCount > 0) {
        text += tr(", %1 not finite").arg(volume.nonFiniteCount);
    }
    return text;
}

QString scaleText(const volume::ScanDetails& details) {
    if (details.slope == 1 && details.intercept == 0) {
        return tr("as they are stored");
    }
    return tr("%1 × stored value %2 %3")
        .arg(number(details.slope), details.intercept < 0 ? "−" : "+", number(std::abs(details.intercept)));
}

QString modalityText(const volume::ScanDetails& details) {
    const QString modality = QString::fromStdString(details.modality);
    return details.isAngiography ? tr("%1, angiography").arg(modality) : modality;
}

} // namespace

QString runsOf(const std::vector<int>& numbers) {
    QStringList runs;
    for (std::size_t first = 0; first < numbers.size();) {
        std::size_t last = first;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        runs << (last == first ? QString::number(numbers[first] + 1)
                               : QString("%1–%2").arg(numbers[first] + 1).arg(numbers[last] + 1));
        first = last + 1;
    }
    return runs.join(", ");
}

QString placeText(const volume::GridGeometry& grid) {
    return tr("%1 mm, %2").arg(three(grid.spacing(), " × "), QString::fromStdString(grid.orientationCode()));
}

QString mirroredText(const volume::GridGeometry& one, const volume::GridGeometry& other) {
    const std::string before = one.orientationCode();
    const std::string after = other.orientationCode();
    char exchanged = 0; // where a single axis runs to its other side: where it runs to now
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (before[axis] != after[axis]) {
            exchanged = exchanged == 0 ? after[axis] : '?';
        }
    }
    switch (exchanged) {
    case 'L':
    case 'R':
        return tr("The scan is mirrored against the file: left and right are exchanged.");
    case 'A':
    case 'P':
        return tr("The scan is mirrored against the file: front and back are exchanged.");
    case 'S':
    case 'I':
        return tr("The scan is mirrored against the file: top and bottom are exchanged.");
    default:
        return tr("The scan is mirrored against the file.");
    }
}

std::vector<Property> propertiesOf(const volume::Volume& volume, const volume::GridGeometry& grid,
                                   const volume::GridGeometry& inFile) {
    const auto& details = volume.details;
    const auto text = [](const std::string& said) { return QString::fromStdString(said); };
    const glm::dvec3 origin(grid.worldFromVoxel[3]);
    std::vector<Property> properties{
        {"file", tr("File"), textOf(volume.path)},
        {"format", tr("Format"), text(details.format)},
        {"patient", tr("Patient"), text(details.patient)},
        {"study", tr("Study"), text(details.study)},
        {"series", tr("Series"), text(details.series)},
        {"modality", tr("Modality"), modalityText(details)},
        {"size", tr("Size"),
         tr("%1 × %2 × %3 voxels, %4, %5")
             .arg(grid.dims.x)
             .arg(grid.dims.y)
             .arg(grid.dims.z)
             .arg(volume::name(volume.type), QLocale().formattedDataSize(qint64(volume.bytes.size())))},
        {"spacing", tr("Spacing"), tr("%1 mm").arg(three(grid.spacing(), " × "))},
        {"extent", tr("Extent"), tr("%1 mm").arg(three(grid.spacing() * glm::dvec3(grid.dims), " × "))},
        {"orientation", tr("Orientation"), orientationText(grid)},
        {"inFile", tr("In the file"), grid == inFile ? QString() : placeText(inFile)},
        {"origin", tr("First voxel"), tr("%1 mm (left, posterior, superior)").arg(three(origin, ", "))},
        {"values", tr("Values"), valuesText(volume)},
        {"scale", tr("Scale"), scaleText(details)},
        {"time", tr("Time"), tr("volume %1 of %2").arg(details.frame + 1).arg(details.frames)},
        {"channels", tr("Channels"), "1"},
        {"interpolated", tr("Interpolated slices"), runsOf(details.interpolated)}};
    std::erase_if(properties, [](const Property& property) { return property.text.isEmpty(); });
    return properties;
}

} // namespace vs::desktop
