// SPDX-License-Identifier: Apache-2.0
// Files are read back by VTK's readers.
#include "mesh/write_mesh.h"

#include "base/error.h"
#include "shapes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkAppendPolyData.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace vs::mesh {
namespace {

class Formats : public testing::Test {
protected:
    Formats() {
        Mesh red = ball(6);
        red.name = "Red one";
        red.colour = {1, 0, 0.2};
        Mesh glass = torus(10, 4);
        glass.name = "Glass, \"quoted\"";
        glass.colour = {0, 0.5, 1};
        glass.opacity = 0.4;
        meshes_ = {red, glass};
        std::filesystem::create_directories(folder_);
    }
    ~Formats() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path written(const char* name) const {
        writeMeshes(folder_ / name, meshes_);
        return folder_ / name;
    }
    static std::string textOf(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    // Every triangle is there, with its corners where they were and in their order.
    void expectSame(vtkPolyData& data, double tolerance = 0) const {
        ASSERT_EQ(std::size_t(data.GetNumberOfCells()),
                  meshes_[0].triangles.size() + meshes_[1].triangles.size());
        vtkIdType cell = 0;
        double worst = 0;
        for (const Mesh& mesh : meshes_) {
            for (const glm::uvec3 t : mesh.triangles) {
                auto* corners = data.GetCell(cell++)->GetPoints();
                for (int i = 0; i < 3; ++i) {
                    glm::dvec3 place;
                    corners->GetPoint(i, &place.x);
                    worst = std::max(worst, glm::distance(place, glm::dvec3(mesh.points[t[i]])));
                }
            }
        }
        EXPECT_LE(worst, tolerance);
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / fmt::format("vs_mesh_formats_{}", getpid());
    std::vector<Mesh> meshes_;
};

TEST_F(Formats, Stl) {
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName(written("a.stl").c_str());
    reader->MergingOff();
    reader->Update();
    expectSame(*reader->GetOutput());
    EXPECT_EQ(textOf(folder_ / "a.stl").find("Volume Studio, millimetres, SPACE=LPS"), 0U);
}

TEST_F(Formats, Ply) {
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(written("a.ply").c_str());
    reader->Update();
    expectSame(*reader->GetOutput());
    auto* colours = reader->GetOutput()->GetPointData()->GetArray("RGB");
    ASSERT_NE(colours, nullptr);
    EXPECT_EQ(colours->GetComponent(0, 0), 255);
    EXPECT_EQ(colours->GetComponent(0, 2), 51);
    EXPECT_EQ(colours->GetComponent(colours->GetNumberOfTuples() - 1, 2), 255);
    EXPECT_NE(textOf(folder_ / "a.ply").substr(0, 400).find("SPACE=LPS"), std::string::npos);
}

TEST_F(Formats, Obj) {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(written("a.obj").c_str());
    reader->Update();
    expectSame(*reader->GetOutput()); // numbers are written with all their digits
    const std::string text = textOf(folder_ / "a.obj");
    EXPECT_EQ(
        text.find("# Volume Studio, millimetres, SPACE=LPS\nmtllib a.mtl\no Red_one\nusemtl Red_one_1\n"),
        0U);
    EXPECT_NE(text.find("\no Glass,_\"quoted\"\n"), std::string::npos);
    EXPECT_NE(textOf(folder_ / "a.mtl").find("Kd 1.0000 0.0000 0.2000"), std::string::npos);
}

TEST_F(Formats, Glb) {
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName(written("a.glb").c_str());
    reader->ApplyDeformationsToGeometryOn();
    reader->Update();
    // Blocks within blocks, in the order of the nodes.
    vtkNew<vtkAppendPolyData> all;
    const std::function<void(vtkDataObject*)> collect = [&](vtkDataObject* object) {
        if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(object)) {
            for (unsigned i = 0; i < blocks->GetNumberOfBlocks(); ++i) {
                collect(blocks->GetBlock(i));
            }
        } else if (auto* data = vtkPolyData::SafeDownCast(object)) {
            all->AddInputData(data);
        }
    };
    collect(reader->GetOutputDataObject(0));
    all->Update();
    auto* data = all->GetOutput();
    // From metres with superior up back to millimetres in LPS.
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        glm::dvec3 p;
        data->GetPoint(i, &p.x);
        data->GetPoints()->SetPoint(i, 1000 * p.x, -1000 * p.z, 1000 * p.y);
    }
    expectSame(*data, 1e-5); // floats in metres
}

TEST_F(Formats, GlbSaysWhatThingsAre) {
    const std::string bytes = textOf(written("a.glb"));
    std::uint32_t total = 0;
    std::uint32_t length = 0;
    std::memcpy(&total, bytes.data() + 8, 4);
    std::memcpy(&length, bytes.data() + 12, 4);
    EXPECT_EQ(total, bytes.size());
    const auto json = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(json["nodes"][1]["name"], "Glass, \"quoted\"");
    const auto& material = json["materials"][1];
    EXPECT_EQ(material["alphaMode"], "BLEND");
    EXPECT_NEAR(double(material["pbrMetallicRoughness"]["baseColorFactor"][1]), 0.214, 0.001); // 0.5, linear
    EXPECT_FALSE(json["materials"][0].contains("alphaMode"));
}

TEST_F(Formats, NothingToWriteIsAnError) {
    const std::vector<Mesh> nothing(2);
    EXPECT_THROW(writeMeshes(folder_ / "a.stl", nothing), WriteError);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.stl"));
    EXPECT_THROW(writeMeshes(folder_ / "a.fbx", meshes_), WriteError);
    EXPECT_THROW(writeMeshes(folder_ / "none" / "a.stl", meshes_), WriteError);
}

} // namespace
} // namespace vs::mesh
