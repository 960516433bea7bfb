// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/exports.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "mesh/segment_surface.h"
#include "mesh/write_mesh.h"
#include "render/camera/placement.h"
#include "render/colours/colour.h"
#include "segment/edits/label_sets.h"
#include "segment/measures/measured_segment.h"
#include "studio/exports/store_export.h"
#include "volume/io/inspect.h"
#include "volume/io/write.h"
#include "volume/reading/write_segmentation.h"
#include "volume/store/write_store.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

namespace {

using What = ExportSettings::What;
constexpr double kContouring = 0.5; // of the time that a surface takes
const glm::dvec3 kVolumeColour{0.87, 0.84, 0.78};

bool endsIn(const std::filesystem::path& path, const char* extension) {
    return volume::lowerCase(path.extension().string()) == extension;
}

// --- surfaces

// At the finest level that the segment has grown at.
mesh::Mesh surfaceOf(std::uint8_t label, const ExportSource& source, const std::array<Box3, 256>& boxes,
                     const mesh::Progress& progress) {
    if (source.finestLabels) {
        const auto& finest = *source.finestLabels;
        return mesh::segmentSurface({finest.labels, finest.isEmpty}, finest.geometry, label, progress);
    }
    return mesh::segmentSurface(source.labels, source.geometry, label, boxes[label]);
}

// Points take the colours of marks, as pictures show them.
void colourByMarks(mesh::Mesh& mesh, const ExportSource& source) {
    if (source.marks == nullptr || source.marks->isEmpty()) {
        return;
    }
    const glm::dmat4 voxelFromWorld = source.geometry.voxelFromWorld();
    std::vector<glm::vec3> colours;
    bool isMarked = false;
    for (const glm::vec3 point : mesh.points) {
        const glm::dvec4 mark = source.marks->colourAt(glm::dvec3(voxelFromWorld * glm::dvec4(point, 1)));
        isMarked = isMarked || mark.w > 0;
        colours.emplace_back(render::displayFromLinear(glm::mix(
            render::linearFromDisplay(mesh.colour), render::linearFromDisplay(glm::dvec3(mark)), mark.w)));
    }
    if (isMarked) {
        mesh.colours = std::move(colours);
    }
}

std::vector<mesh::Mesh> segmentMeshes(const ExportSource& source, const mesh::Refinement& refinement,
                                      const mesh::Progress& progress) {
    const auto boxes = segment::labelBoxes(source.labels, source.geometry.dims);
    std::vector<mesh::Mesh> meshes;
    const double count = double(source.segments.size());
    for (std::size_t i = 0; i < source.segments.size(); ++i) {
        const ExportedSegment& segment = source.segments[i];
        const double from = double(i) / count;
        mesh::report(progress, from);
        mesh::Mesh mesh =
            surfaceOf(segment.label, source, boxes, mesh::partOf(progress, from, from + kContouring / count));
        mesh.name = segment.name;
        mesh.colour = segment.colour;
        mesh.opacity = segment.opacity;
        meshes.push_back(mesh::refined(std::move(mesh), refinement,
                                       mesh::partOf(progress, from + kContouring / count, from + 1 / count)));
        colourByMarks(meshes.back(), source);
    }
    return meshes;
}

// What remains where it is, then each pasted part where it was put.
std::vector<mesh::Mesh> volumeMeshes(const ExportSource& source, const ExportSettings& settings,
                                     const mesh::Progress& progress) {
    std::vector<mesh::Mesh> meshes;
    const double count = double(1 + source.parts.size());
    for (std::size_t i = 0; i <= source.parts.size(); ++i) {
        const double from = double(i) / count;
        mesh::report(progress, from);
        const ExportSource::Part* part = i > 0 ? &source.parts[i - 1] : nullptr;
        mesh::Mesh mesh = mesh::visibleSurface(
            {source.volume, settings.range, part != nullptr ? part->sculpture : source.sculpture,
             part != nullptr ? field::SculptureView::Probe : source.view, &source.geometry});
        mesh.name = part != nullptr ? part->name : "Volume";
        mesh.colour = kVolumeColour;
        mesh = mesh::refined(std::move(mesh), settings.refinement,
                             mesh::partOf(progress, from + kContouring / count, from + 1 / count));
        colourByMarks(mesh, source);
        if (part != nullptr) {
            const glm::dmat4 there = render::worldFromPart(part->place, source.geometry);
            for (glm::vec3& point : mesh.points) {
                point = glm::vec3(there * glm::dvec4(point, 1));
            }
        }
        meshes.push_back(std::move(mesh));
    }
    return meshes;
}

std::string described(const std::filesystem::path& path, std::span<const mesh::Mesh> meshes) {
    std::size_t triangles = 0;
    std::size_t surfaces = 0;
    double mm3 = 0;
    for (const mesh::Mesh& mesh : meshes) {
        triangles += mesh.triangles.size();
        surfaces += mesh.triangles.empty() ? 0 : 1;
        mm3 += mesh::volumeMm3(mesh);
    }
    return fmt::format("{}: {} surface{}, {} triangles, {:.6g} ml", path.string(), surfaces,
                       surfaces == 1 ? "" : "s", triangles, mm3 / 1000);
}

// NAME-SEGMENT.EXT, without what makes folders of names.
std::filesystem::path pathOf(const std::filesystem::path& path, const mesh::Mesh& mesh) {
    std::string name = mesh.name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == '/'; }, '_');
    return path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), name, path.extension().string());
}

std::vector<std::string> writeSurfaces(const std::filesystem::path& path, const ExportSource& source,
                                       const ExportSettings& settings, const mesh::Progress& progress) {
    const bool isVolume = settings.what == What::Volume;
    const auto meshes = isVolume ? volumeMeshes(source, settings, progress)
                                 : segmentMeshes(source, settings.refinement, progress);
    mesh::report(progress, 1);
    if (!settings.isEachAlone || isVolume) {
        mesh::writeMeshes(path, meshes);
        return {described(path, meshes)};
    }
    std::vector<std::string> lines;
    for (const mesh::Mesh& mesh : meshes) {
        const auto file = pathOf(path, mesh);
        mesh::writeMeshes(file, std::span(&mesh, 1));
        lines.push_back(described(file, std::span(&mesh, 1)));
    }
    return lines;
}

// --- voxels and tables

// The label map with nothing but the segments to export, in the values of files.
template <typename T>
void writeLabels(const std::filesystem::path& path, const ExportSource& source) {
    std::array<T, 256> values{};
    for (const ExportedSegment& segment : source.segments) {
        values[segment.label] = T(segment.value);
    }
    std::vector<T> written(source.labels.size());
    std::transform(source.labels.begin(), source.labels.end(), written.begin(),
                   [&](std::uint8_t label) { return values[label]; });
    volume::writeGrid(path, source.geometry, std::span<const T>(written));
}

std::string writeLabelMap(const std::filesystem::path& path, const ExportSource& source) {
    const auto fits = [&]<typename T>(T) {
        return std::all_of(source.segments.begin(), source.segments.end(),
                           [](const auto& segment) { return std::in_range<T>(segment.value); });
    };
    if (fits(std::uint8_t())) {
        writeLabels<std::uint8_t>(path, source);
    } else if (fits(std::int16_t())) {
        writeLabels<std::int16_t>(path, source);
    } else {
        writeLabels<std::uint32_t>(path, source);
    }
    return fmt::format("{}: {} labels", path.string(), source.segments.size());
}

// With patient and study of the series that the volume came from, where it came from one and still lies
// there.
std::string writeDicom(const std::filesystem::path& path, const ExportSource& source) {
    volume::SegmentationOrder order;
    order.geometry = source.geometry;
    for (const ExportedSegment& segment : source.segments) {
        order.segments.push_back({segment.label, segment.name, segment.colour});
    }
    // Voxels that were moved lie on none of the series' images, and not in its frame of reference.
    const bool isOnSeries = source.volume != nullptr && !source.volume->path.empty() && !source.isCorrected;
    if (isOnSeries) {
        order.source = source.volume->path;
        order.reading = source.reading;
    }
    const int series = volume::writeDicomSegmentation(path, order, source.labels);
    return fmt::format("{}: {} segment{}, {}", path.string(), order.segments.size(),
                       order.segments.size() == 1 ? "" : "s",
                       source.isCorrected ? "of a corrected geometry, which is no DICOM series': patient and "
                                            "study are empty"
                       : series == 0      ? "of no DICOM series: patient and study are empty"
                                          : "with patient and study of the series");
}

std::string writeTable(const std::filesystem::path& path, const ExportSource& source) {
    std::vector<segment::MeasuredSegment> rows;
    const auto figures = source.finestMeasures != nullptr
                             ? source.finestMeasures->all()
                             : segment::measure(*source.volume, source.geometry, source.labels);
    for (const auto& statistics : figures) {
        const auto segment =
            std::find_if(source.segments.begin(), source.segments.end(),
                         [&](const ExportedSegment& one) { return one.label == statistics.label; });
        if (segment != source.segments.end()) {
            rows.push_back({segment->value, segment->name, glm::u8vec3(glm::round(segment->colour * 255.0)),
                            statistics});
        }
    }
    writeFileAtomically(path, segment::csvOf(rows));
    return fmt::format("{}: {} rows", path.string(), rows.size());
}

std::string writeVolume(const std::filesystem::path& path, const ExportSource& source,
                        const std::optional<double>& fill) {
    const volume::Volume left = sculptedVolume(source, fill);
    volume::writeVolume(path, left);
    return fmt::format("{}: {} values, cut ones {:g}", path.string(), volume::name(left.type),
                       fill.value_or(source.volume->usual.lo));
}

} // namespace

void checkExportName(const std::filesystem::path& path, const ExportSettings& settings) {
    const bool isTable = endsIn(path, ".csv") || endsIn(path, ".dcm");
    if (mesh::isMeshName(path) || volume::isStoreName(path) || (isTable && settings.what == What::Segments)) {
        return;
    }
    try {
        volume::checkGridName(path);
    } catch (const WriteError&) {
        throw WriteError("{}: the extension names no format of {}; it must be .stl, .ply, .obj or .glb for "
                         "surfaces, {}.nrrd, .nii, .nii.gz, .mha, .mhd or .zarr for voxels",
                         path.string(),
                         settings.what == What::Segments ? "segments" : "what is left of a volume",
                         settings.what == What::Segments ? ".dcm for DICOM, .csv for a table, " : "");
    }
}

std::vector<std::string> writeExport(const std::filesystem::path& path, const ExportSource& source,
                                     const ExportSettings& settings, const mesh::Progress& progress) {
    checkExportName(path, settings);
    if (settings.what == What::Segments && source.segments.empty()) {
        throw WriteError("{}: there is no segment to write; seed and grow one, or choose one with voxels",
                         path.string());
    }
    if (mesh::isMeshName(path)) {
        return writeSurfaces(path, source, settings, progress);
    }
    mesh::report(progress, 0);
    if (volume::isStoreName(path)) {
        return {settings.what == What::Volume ? writeSculptedStore(path, source, settings.fill)
                                              : writeLabelStore(path, source)};
    }
    if (settings.what == What::Volume) {
        return {writeVolume(path, source, settings.fill)};
    }
    if (endsIn(path, ".dcm")) {
        return {writeDicom(path, source)};
    }
    if (endsIn(path, ".csv")) {
        return {writeTable(path, source)};
    }
    return {writeLabelMap(path, source)};
}

std::array<std::size_t, 256> estimatedTriangles(std::span<const std::uint8_t> labels, glm::ivec3 dims) {
    // A closed surface of marching cubes has a point on each face between voxels, and twice as many
    // triangles.
    std::array<std::size_t, 256> triangles{};
    const auto meet = [&](std::uint8_t a, std::uint8_t b) {
        if (a != b) {
            triangles[a] += 2;
            triangles[b] += 2;
        }
    };
    const std::size_t row(dims.x);
    const std::size_t slice = row * std::size_t(dims.y);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const std::size_t x = i % row;
        const std::size_t y = i / row % std::size_t(dims.y);
        const std::size_t z = i / slice;
        meet(labels[i], x > 0 ? labels[i - 1] : std::uint8_t(0));
        meet(labels[i], y > 0 ? labels[i - row] : std::uint8_t(0));
        meet(labels[i], z > 0 ? labels[i - slice] : std::uint8_t(0));
        const bool isLast[3] = {x + 1 == row, y + 1 == std::size_t(dims.y), z + 1 == std::size_t(dims.z)};
        for (const bool isAtBorder : isLast) {
            meet(labels[i], isAtBorder ? std::uint8_t(0) : labels[i]);
        }
    }
    return triangles;
}

} // namespace vs::studio
