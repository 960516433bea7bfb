// SPDX-License-Identifier: Apache-2.0
#include "mesh/write_mesh.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/lines.h"
#include "mesh/mesh_formats.h"
#include "mesh/vtk_mesh.h"

#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkSTLWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

namespace vs::mesh {

namespace {

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

Mesh together(std::span<const Mesh> meshes) {
    Mesh all;
    for (const Mesh& mesh : meshes) {
        const glm::uvec3 first(std::uint32_t(all.points.size()));
        all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
        std::transform(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(all.triangles),
                       [first](glm::uvec3 triangle) { return triangle + first; });
    }
    return all;
}

// VTK's writers say by their error code that a disk is full, and not always.
void writeBy(vtkWriter& writer, vtkPolyData& data) {
    const QuietVtk quiet;
    writer.SetInputData(&data);
    if (writer.Write() == 0 || writer.GetErrorCode() != 0) {
        throw std::runtime_error("the disk may be full");
    }
}

// VTK does not always notice that a disk is full: what reached it must be as much as was to be written.
void requireBytes(const std::filesystem::path& path, std::uintmax_t bytes) {
    if (std::filesystem::file_size(path) != bytes) {
        throw std::runtime_error("the disk may be full");
    }
}

void writeStl(const std::filesystem::path& path, std::span<const Mesh> meshes) {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetFileTypeToBinary();
    writer->SetHeader(kSpaceNote);
    const auto data = toVtk(together(meshes));
    writeBy(*writer, *data);
    requireBytes(path, 84 + 50 * std::uintmax_t(data->GetNumberOfPolys()));
}

// The bytes of a file's header, with the line that ends it.
std::uintmax_t plyHeaderBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    for (std::string line; nextLine(file, line, path);) {
        if (line == "end_header") {
            return std::uintmax_t(file.tellg());
        }
    }
    return 0;
}

void writePly(const std::filesystem::path& path, std::span<const Mesh> meshes) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colours");
    colours->SetNumberOfComponents(3);
    vtkNew<vtkPLYWriter> writer;
    for (const Mesh& mesh : meshes) {
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            const glm::dvec3 colour = glm::round(mesh.colourOf(i) * 255.0);
            colours->InsertNextTuple3(colour.r, colour.g, colour.b);
        }
    }
    auto data = toVtk(together(meshes));
    data->GetPointData()->SetScalars(colours);
    writer->SetFileName(path.c_str());
    writer->SetFileTypeToBinary();
    writer->SetArrayName("colours");
    writer->AddComment(kSpaceNote);
    writeBy(*writer, *data);
    // Three floats and three bytes of colour a point, a count and three numbers a triangle.
    requireBytes(path, plyHeaderBytes(path) + 15 * std::uintmax_t(data->GetNumberOfPoints()) +
                           13 * std::uintmax_t(data->GetNumberOfPolys()));
}

void writeObj(const std::filesystem::path& path, std::span<const Mesh> meshes) {
    std::filesystem::path materials = path;
    materials.replace_extension(".mtl");
    const std::array<FileWriting, 2> files{
        {{materials, writingOf(mtlText(meshes))},
         {path, writingOf(objText(meshes, materials.filename().string()))}}};
    writeAllAtomically(files);
}

} // namespace

bool isMeshName(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    return extension == ".stl" || extension == ".ply" || extension == ".obj" || extension == ".glb";
}

void writeMeshes(const std::filesystem::path& path, std::span<const Mesh> meshes) {
    const std::string extension = extensionOf(path);
    if (!isMeshName(path)) {
        throw WriteError("{}: the extension names no format of meshes; it must be .stl, .ply, .obj or .glb",
                         path.string());
    }
    if (std::all_of(meshes.begin(), meshes.end(), [](const Mesh& mesh) { return mesh.triangles.empty(); })) {
        throw WriteError("{}: there is no surface to write; choose what has voxels", path.string());
    }
    if (extension == ".obj") {
        writeObj(path, meshes);
    } else if (extension == ".glb") {
        try {
            writeFileAtomically(path, glbBytes(meshes));
        } catch (const std::length_error& error) {
            throw WriteError("{}: glTF cannot hold {}; keep fewer triangles or write .stl", path.string(),
                             error.what());
        }
    } else {
        writeAtomically(path, [&](const std::filesystem::path& temporary) {
            extension == ".stl" ? writeStl(temporary, meshes) : writePly(temporary, meshes);
        });
    }
}

} // namespace vs::mesh
