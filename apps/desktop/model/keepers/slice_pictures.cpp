// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/slice_pictures.h"

#include "model/keepers/thumbnail_keeper.h"

#include "volume/reading/read_volume.h"

#include <QFileInfo>
#include <QImage>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vs::desktop {

namespace {

constexpr qint64 kMostBytes = qint64(48) << 20; // of the file: read in a second or so

// The extent of the grid's box along the world's axes.
std::pair<glm::dvec3, glm::dvec3> worldBox(const volume::GridGeometry& geometry) {
    glm::dvec3 lo(1e300);
    glm::dvec3 hi(-1e300);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 voxel = side * glm::dvec3(geometry.dims) - 0.5;
        const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
        lo = glm::min(lo, world);
        hi = glm::max(hi, world);
    }
    return {lo, hi};
}

// The value at a place, of the eight voxels around it; the volume's least outside.
double valueAt(const volume::Volume& volume, glm::dvec3 voxel) {
    const glm::ivec3 base(glm::floor(voxel));
    if (glm::any(glm::lessThan(base, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(base + 1, volume.geometry.dims))) {
        return volume.usual.lo;
    }
    const glm::dvec3 part = voxel - glm::dvec3(base);
    double value = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::equal(offset, glm::ivec3(1)));
        value += weight.x * weight.y * weight.z * volume.at(base + offset);
    }
    return value;
}

// The greys between the rarest hundredths at either end.
QImage greys(const std::vector<double>& values, QSize size) {
    auto sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double lo = sorted[sorted.size() / 100];
    const double hi = std::max(sorted[sorted.size() - 1 - sorted.size() / 200], lo + 1e-9);
    QImage image(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
            const double value = values[std::size_t(y) * std::size_t(size.width()) + std::size_t(x)];
            const int grey = int(std::lround(235 * std::clamp((value - lo) / (hi - lo), 0.0, 1.0)));
            image.setPixel(x, y, qRgb(grey, grey, grey));
        }
    }
    return image;
}

// The face to the left, the top of the head up, all of the volume with a margin.
QImage slicePicture(const volume::Volume& volume) {
    const QSize size = ThumbnailKeeper::kSize;
    const auto [lo, hi] = worldBox(volume.geometry);
    const glm::dvec3 centre = 0.5 * (lo + hi);
    const double besides = centre.x + 0.1 * (hi.x - lo.x); // the middle plane of a head is a gap
    const glm::dvec3 extent = 1.06 * (hi - lo);
    const double mmPerPixel = std::max(extent.y / size.width(), extent.z / size.height());
    const glm::dmat4 voxelFromWorld = volume.geometry.voxelFromWorld();
    std::vector<double> values;
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
            const glm::dvec3 world(besides, centre.y + (x - 0.5 * size.width()) * mmPerPixel,
                                   centre.z + (0.5 * size.height() - y) * mmPerPixel);
            values.push_back(valueAt(volume, glm::dvec3(voxelFromWorld * glm::dvec4(world, 1))));
        }
    }
    return greys(values, size);
}

} // namespace

SlicePictures::SlicePictures(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

SlicePictures::~SlicePictures() {
    pool_.clear();
    pool_.waitForDone();
}

void SlicePictures::want(const KnownDocument& document) {
    const QString path = document.picturePath();
    if (document.isSession() || asked_.contains(path) || QFileInfo::exists(path) ||
        !QFileInfo(document.path()).isFile() || QFileInfo(document.path()).size() > kMostBytes) {
        return;
    }
    asked_ << path;
    pool_.start([this, path, file = document.request.volume] {
        try {
            writeThumbnail(path, slicePicture(volume::readVolume(file).volume));
            QMetaObject::invokeMethod(this, &SlicePictures::made, Qt::QueuedConnection);
        } catch (const std::exception&) {
            // It has no picture; why it cannot be read is told when it is opened.
        }
    });
}

} // namespace vs::desktop
