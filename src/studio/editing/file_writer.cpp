// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/file_writer.h"

#include "field/fill/fill_labels.h"
#include "image/image.h"
#include "mesh/fill_surface.h"
#include "mesh/write_mesh.h"
#include "render/marks/draw_annotations.h"
#include "studio/editing/measurement_marks.h"
#include "studio/editing/stroke_marks.h"
#include "volume/io/write.h"
#include "volume/store/write_store.h"

#include <chrono>
#include <functional>
#include <span>
#include <string>

namespace vs::studio {

image::Image FileWriter::picture(const SavePicture& op, const View& view, const Drawn& drawn) {
    if (!caster_) {
        caster_.emplace();
    }
    render::Frame picture = display_.frame(view, op.size);
    picture.samples = op.samples;
    picture.background = op.background;
    caster_->render(picture);
    image::Image pixels = caster_->readPicture();
    if (!drawn.isEmpty()) {
        markStrokes(pixels, drawn, op.strokes == ShownStrokes::Last, view, contents_.scan.volume.geometry);
    }
    if (op.annotations) {
        markMeasurements(pixels, allMeasured(*contents_.measurements, contents_.scan.volume), picture.rays,
                         contents_.scan.volume.geometry);
        render::annotate(pixels, picture.rays, contents_.scan.volume.geometry);
    }
    return pixels;
}

Outcome FileWriter::run(const SavePicture& op, const std::filesystem::path& folder, const Drawn& drawn) {
    image::writePng(folder / op.file, picture(op, contents_.view, drawn));
    return {{}, 0, 0, say("%1", op.file)};
}

namespace {

// Values of boxes of a grid, as a store with levels.
template <typename T>
void writeStore(const std::filesystem::path& path, const volume::StoreFacts& facts, volume::ScalarType type,
                volume::Reducing reducing, const std::function<std::vector<T>(const Box3&)>& valuesIn,
                const std::function<bool(const Box3&)>& isZero = {}) {
    volume::StoreSource source;
    source.facts = facts;
    source.facts.name = path.stem().string();
    source.type = type;
    // Nobody goes on with it: what it is made from may have changed before the same is asked for again.
    source.identity = std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
    source.read = [&](const Box3& box) {
        const std::vector<T> values = valuesIn(box);
        const auto bytes = std::as_bytes(std::span(values));
        return std::vector<std::byte>(bytes.begin(), bytes.end());
    };
    source.isZero = isZero;
    volume::StoreLayout layout;
    layout.reducing = reducing;
    volume::writeStore(path, source, layout);
}

// Boxes of values that are all there, x fastest.
template <typename T>
std::function<std::vector<T>(const Box3&)> boxesOf(const std::vector<T>& values, glm::ivec3 dims) {
    return [&values, dims](const Box3& box) {
        std::vector<T> part;
        part.reserve(box.volume());
        forEachVoxel(box, [&](glm::ivec3 v, std::size_t) {
            part.push_back(
                values[(std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
                       std::size_t(v.x)]);
        });
        return part;
    };
}

} // namespace

// The labels that have voxels, as people know them.
std::vector<volume::StoreFacts::Label> FileWriter::labelFacts() const {
    std::vector<volume::StoreFacts::Label> labels;
    for (const SegmentInfo& info : contents_.segments.segments) {
        if (contents_.region.voxelCount(info.label) > 0) {
            const glm::u8vec4 rgba(glm::round(glm::dvec4(info.colour, info.opacity) * 255.0));
            labels.push_back({info.label, info.name, {rgba.r, rgba.g, rgba.b, rgba.a}});
        }
    }
    return labels;
}

Outcome FileWriter::run(const SaveMarks& op, const std::filesystem::path& folder) {
    if (contents_.marks->isEmpty()) {
        throw Error("{}: nothing is marked that could be written", op.file);
    }
    const volume::GridGeometry& grid = contents_.scan.volume.geometry;
    volume::writeColours(folder / op.file, grid, field::coloursOfVoxels(*contents_.marks));
    return {{}, 0, 0, say("%1", op.file)};
}

Outcome FileWriter::run(const SaveFill& op, const std::filesystem::path& folder) {
    if (contents_.filled.fill->isEmpty()) {
        throw Error("{}: nothing is filled that could be written", op.file);
    }
    const auto labels = field::materialLabels(*contents_.filled.fill);
    volume::writeGrid(folder / op.file, contents_.scan.volume.geometry,
                      std::span<const std::uint8_t>(labels));
    return {{}, 0, contents_.filled.fill->voxels(), say("%1", op.file)};
}

Outcome FileWriter::run(const SaveFillSurface& op, const std::filesystem::path& folder) {
    const auto count = int(contents_.filled.materials->size());
    if (op.material && *op.material > count) {
        throw Error("material: {} must be one of the materials that there are ({})", *op.material, count);
    }
    std::vector<mesh::Mesh> meshes;
    for (int material = op.material.value_or(1); material <= op.material.value_or(count); ++material) {
        mesh::Mesh mesh =
            mesh::fillSurface(*contents_.filled.fill, std::uint8_t(material), contents_.scan.volume.geometry);
        const Material& about = contents_.filled.materials->at(std::size_t(material - 1));
        mesh.name = about.name;
        mesh.colour = about.colour;
        if (!mesh.triangles.empty()) {
            meshes.push_back(std::move(mesh));
        }
    }
    if (meshes.empty()) {
        throw Error("{}: nothing is filled that could be written", op.file);
    }
    mesh::writeMeshes(folder / op.file, meshes);
    return {{}, 0, 0, say("%1", op.file)};
}

Outcome FileWriter::run(const SaveLabels& op, const std::filesystem::path& folder) {
    if (const auto* finest = contents_.region.finest(); finest != nullptr && volume::isStoreName(op.file)) {
        writeStore<std::uint8_t>(folder / op.file, {contents_.region.geometry(), "", "", "", labelFacts()},
                                 volume::ScalarType::UInt8, volume::Reducing::Commonest,
                                 finest->labelReader(), finest->emptyBoxes());
        return {{}, 0, contents_.grownVoxels(), say("%1", op.file)};
    }
    const auto labels = contents_.region.labelMap();
    if (volume::isStoreName(op.file)) {
        const volume::GridGeometry& grid = contents_.scan.volume.geometry;
        writeStore<std::uint8_t>(folder / op.file, {grid, "", "", "", labelFacts()},
                                 volume::ScalarType::UInt8, volume::Reducing::Commonest,
                                 boxesOf(labels, grid.dims));
        return {{}, 0, contents_.grownVoxels(), say("%1", op.file)};
    }
    volume::writeGrid(folder / op.file, contents_.scan.volume.geometry,
                      std::span<const std::uint8_t>(labels));
    return {{}, 0, contents_.grownVoxels(), say("%1", op.file)};
}

Outcome FileWriter::run(const SaveSculpture& op, const std::filesystem::path& folder) {
    const sculpt::FineSculpture* finer = contents_.sculpture.finer();
    if (finer != nullptr && volume::isStoreName(op.file)) {
        writeStore<float>(folder / op.file, {*cutter_.geometry, "", "", "", {}}, volume::ScalarType::Float32,
                          volume::Reducing::Mean, finer->reader(), finer->emptyBoxes());
        return {{}, 0, 0, say("%1", op.file)};
    }
    const std::vector<float> values = cutter_.sculptureAsFloats();
    if (volume::isStoreName(op.file)) {
        const volume::GridGeometry& grid = contents_.scan.volume.geometry;
        writeStore<float>(folder / op.file, {grid, "", "", "", {}}, volume::ScalarType::Float32,
                          volume::Reducing::Mean, boxesOf(values, grid.dims));
        return {{}, 0, 0, say("%1", op.file)};
    }
    volume::writeGrid(folder / op.file, contents_.scan.volume.geometry, std::span<const float>(values));
    return {{}, 0, 0, say("%1", op.file)};
}

} // namespace vs::studio
