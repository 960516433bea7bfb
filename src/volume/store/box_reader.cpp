// SPDX-License-Identifier: Apache-2.0
#include "volume/store/box_reader.h"

#include <algorithm>
#include <cstring>

namespace vs::volume {

namespace {

void fillRow(std::byte* to, std::size_t bytes, const std::vector<std::byte>& fill) {
    for (std::size_t at = 0; at < bytes; at += fill.size()) {
        std::memcpy(to + at, fill.data(), fill.size());
    }
}

} // namespace

BoxReader::BoxReader(const Multiscales& store, std::size_t level, const Box3& box, int channel, int time)
    : store_(store), array_(store.levels.at(level).array), box_(box), valueBytes_(bytesOf(array_.type)) {
    const std::size_t axes = array_.shape.size();
    fixed_.assign(axes, 0);
    if (store.channelAxis >= 0) {
        fixed_[std::size_t(store.channelAxis)] = channel;
    }
    if (store.timeAxis >= 0) {
        fixed_[std::size_t(store.timeAxis)] = time;
    }
    strides_.assign(axes, 1);
    for (std::size_t axis = axes - 1; axis > 0; --axis) {
        strides_[axis - 1] = strides_[axis] * array_.chunks[axis];
    }
    for (int i = 0; i < 3; ++i) {
        const int axis = store.spatial[std::size_t(i)];
        // A chunk that is larger than the array ends where that ends.
        side_[i] =
            axis < 0 ? 1 : int(std::min(array_.chunks[std::size_t(axis)], array_.shape[std::size_t(axis)]));
        stride_[i] = axis < 0 ? 0 : std::size_t(strides_[std::size_t(axis)]) * valueBytes_;
    }
    first_ = box.lo / side_;
    count_ = (box.hi - 1) / side_ + 1 - first_;
    constexpr double most = 1 << 26;
    if (const double chunks = double(count_.x) * count_.y * count_.z; chunks > most) {
        refuse(array_.folder, fmt::format("it has {:.3g} chunks", chunks),
               "save it with larger ones; 64 x 64 x 64 voxels are usual");
    }
}

glm::ivec3 BoxReader::placeOf(int n) const {
    return first_ + glm::ivec3(n % count_.x, n / count_.x % count_.y, n / count_.x / count_.y);
}

std::vector<std::int64_t> BoxReader::chunkAt(int n) const {
    std::vector<std::int64_t> chunk(fixed_.size());
    for (std::size_t axis = 0; axis < fixed_.size(); ++axis) {
        chunk[axis] = fixed_[axis] / array_.chunks[axis];
    }
    const glm::ivec3 place = placeOf(n);
    for (int i = 0; i < 3; ++i) {
        if (const int axis = store_.spatial[std::size_t(i)]; axis >= 0) {
            chunk[std::size_t(axis)] = place[i];
        }
    }
    return chunk;
}

std::size_t BoxReader::offsetOf(glm::ivec3 inChunk) const {
    std::size_t offset = 0;
    for (std::size_t axis = 0; axis < fixed_.size(); ++axis) {
        offset += std::size_t(fixed_[axis] % array_.chunks[axis] * strides_[axis]) * valueBytes_;
    }
    return offset + std::size_t(inChunk.x) * stride_[0] + std::size_t(inChunk.y) * stride_[1] +
           std::size_t(inChunk.z) * stride_[2];
}

void BoxReader::copyRow(std::byte* to, std::size_t bytes, const std::byte* from) const {
    if (stride_[0] == valueBytes_) {
        std::memcpy(to, from, bytes);
        return;
    }
    for (std::size_t at = 0; at < bytes; at += valueBytes_, from += stride_[0]) {
        std::memcpy(to + at, from, valueBytes_);
    }
}

void BoxReader::readInto(std::span<std::byte> out, int n) const {
    const glm::ivec3 place = placeOf(n);
    const Box3 part = intersect(box_, {place * side_, (place + 1) * side_});
    const auto values = array_.readChunk(chunkAt(n));
    const auto fill = values ? std::vector<std::byte>() : array_.fillValue();
    const glm::ivec3 size = box_.size();
    const std::size_t rowBytes = std::size_t(part.size().x) * valueBytes_;
    for (int z = part.lo.z; z < part.hi.z; ++z) {
        for (int y = part.lo.y; y < part.hi.y; ++y) {
            const glm::ivec3 to = glm::ivec3(part.lo.x, y, z) - box_.lo;
            std::byte* row = out.data() + ((std::size_t(to.z) * std::size_t(size.y) + std::size_t(to.y)) *
                                               std::size_t(size.x) +
                                           std::size_t(to.x)) *
                                              valueBytes_;
            if (!values) {
                fillRow(row, rowBytes, fill);
                continue;
            }
            copyRow(row, rowBytes, values->data() + offsetOf(glm::ivec3(part.lo.x, y, z) - place * side_));
        }
    }
}

std::vector<std::byte> readBox(const Multiscales& store, std::size_t level, const Box3& box, int channel,
                               int time) {
    const BoxReader reader(store, level, box, channel, time);
    std::vector<std::byte> out(box.volume() * bytesOf(store.levels[level].array.type));
    for (int n = 0; n < reader.chunks(); ++n) {
        reader.readInto(out, n);
    }
    return out;
}

} // namespace vs::volume
