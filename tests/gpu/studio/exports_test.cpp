// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/exports.h"

#include "base/progress.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "studio/state/region.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace vs::studio {
namespace {

using ExportsTest = test::GlTest;
using test::brainSeed;
using test::somePeel;
using test::testHead;
using What = ExportSettings::What;

constexpr double kAtOnce = std::numeric_limits<double>::infinity();

ExportSource read(Document& document, What what, double budgetMs = kAtOnce) {
    ExportReader reader(document, what,
                        what == What::Segments ? exportable(document) : std::vector<ExportedSegment>());
    while (!reader.readSome(budgetMs)) {
        EXPECT_LT(reader.share(), 1);
    }
    EXPECT_EQ(reader.share(), 1);
    return reader.take();
}

// The peeled piece is pasted to the patient's left.
Clip halfOff() {
    Clip clip;
    clip.box = Clip::Box{{-1, -1, -1}, {35.5, 90, 70}};
    return clip;
}

ExportSettings surfaceSettings() {
    ExportSettings settings;
    settings.what = What::Volume;
    settings.range = {50, 255};
    return settings;
}

double millilitresOf(const std::string& line) {
    const auto at = line.rfind(", ");
    return std::stod(line.substr(at + 2));
}

TEST_F(ExportsTest, PiecesAreAsGoodAsTheWhole) {
    Document document(testHead());
    document.apply(somePeel());
    const auto once = read(document, What::Volume);
    const auto pieces = read(document, What::Volume, 0);
    EXPECT_TRUE(once.sculpture == pieces.sculpture);
    const auto values = document.sculpture().values(document.volume().geometry.box());
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_EQ(once.sculpture[i], mesh::packed(values[i]));
    }
}

TEST_F(ExportsTest, ThereIsNothingToReadWhereNothingIsCut) {
    Document document(testHead());
    const auto source = read(document, What::Volume);
    EXPECT_TRUE(source.sculpture.empty());
    EXPECT_TRUE(sculptedVolume(source, {}).bytes == document.volume().bytes);
}

TEST_F(ExportsTest, TheSculptedVolumeIsWhatIsSeen) {
    Document document(testHead());
    document.apply(somePeel());
    const auto& whole = document.volume();
    const auto cuts = document.sculpture().values(whole.geometry.box());
    for (const auto view : {field::SculptureView::Cut, field::SculptureView::Probe}) {
        SetView look;
        look.sculptureView = view;
        document.apply(look);
        const auto left = sculptedVolume(read(document, What::Volume), 7);
        EXPECT_EQ(left.type, whole.type);
        std::size_t filled = 0;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const float away = view == field::SculptureView::Cut ? cuts[i] : 1 - cuts[i];
            if (away < 0.49F) {
                ASSERT_EQ(left.bytes[i], whole.bytes[i]) << "what is seen stays as it is";
            } else if (away == 1) {
                ASSERT_EQ(int(left.bytes[i]), 7);
                ++filled;
            }
        }
        EXPECT_GT(filled, 100U);
    }
}

TEST_F(ExportsTest, PastedPartsAreObjectsWhereTheyWerePut) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("vs_exports_{}.glb", getpid());
    Document document(testHead());
    const auto settings = surfaceSettings();
    const double whole = millilitresOf(writeExport(path, read(document, What::Volume), settings).front());
    document.apply(halfOff());
    const double half = millilitresOf(writeExport(path, read(document, What::Volume), settings).front());
    EXPECT_NEAR(half / whole, 0.5, 0.02) << "the cut goes through the middle";
    document.apply(Paste{{{200, 0, 0}, {}, 2}, {}, true});
    const auto line = writeExport(path, read(document, What::Volume), settings).front();
    EXPECT_NE(line.find("2 surfaces"), std::string::npos) << line;
    EXPECT_NEAR(millilitresOf(line) / whole, 0.5 + 8 * 0.5, 0.1) << "twice as large each way";
    std::filesystem::remove(path);
}

TEST_F(ExportsTest, SegmentsWithVoxelsAreExported) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("vs_exports_{}.stl", getpid());
    Document document(testHead());
    EXPECT_TRUE(exportable(document).empty());
    EXPECT_THROW(writeExport(path, read(document, What::Segments), {}), WriteError);
    document.apply(brainSeed());
    document.apply(Grow{});
    document.apply(UseSegment{"Empty"});
    ASSERT_EQ(exportable(document).size(), 1U);
    const auto source = read(document, What::Segments);
    const double drawn = millilitresOf(writeExport(path, source, {}).front());
    const double grown = double(document.region().voxelCount(1)) * source.geometry.voxelMm3() / 1000;
    EXPECT_NEAR(drawn / grown, 1, 0.03) << "the surface encloses what was grown";
    const auto triangles = estimatedTriangles(source.labels, source.geometry.dims);
    const auto lines = writeExport(path, source, {});
    const double written = double(std::filesystem::file_size(path) - 84) / 50;
    EXPECT_NEAR(double(triangles[1]) / written, 1, 0.01);
    EXPECT_EQ(triangles[2], 0U);
    std::filesystem::remove(path);
    EXPECT_THROW(writeExport(path, source, {}, [](double) { return false; }), GivenUp);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(ExportsTest, FilesSayWhereVoxelsLieOnceThatWasCorrected) {
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("vs_exports_corrected_{}", getpid());
    std::filesystem::create_directories(folder);
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{});
    document.apply(CorrectGeometry{.spacing = glm::dvec3(0.5, 0.5, 2), .orientation = "RAS"});
    const volume::GridGeometry& corrected = document.volume().geometry;
    const auto segments = read(document, What::Segments);
    for (const char* name : {"labels.nrrd", "labels.nii.gz"}) {
        writeExport(folder / name, segments, {});
        const volume::Volume labels = volume::readVolume(folder / name).volume;
        EXPECT_EQ(labels.geometry.orientationCode(), "RAS") << name;
        EXPECT_LT(glm::distance(labels.geometry.spacing(), corrected.spacing()), 1e-6) << name;
        EXPECT_LT(glm::distance(labels.geometry.centreWorld(), corrected.centreWorld()), 1e-4) << name;
    }
    const double voxelsMl = double(document.region().voxelCount(1)) * corrected.voxelMm3() / 1000;
    EXPECT_NEAR(millilitresOf(writeExport(folder / "brain.stl", segments, {}).front()) / voxelsMl, 1, 0.05);
    const auto whole = read(document, What::Volume);
    EXPECT_TRUE(sculptedVolume(whole, {}).geometry == corrected);
    std::filesystem::remove_all(folder);
}

TEST_F(ExportsTest, NamesAreChecked) {
    ExportSettings segments;
    EXPECT_NO_THROW(checkExportName("a.dcm", segments));
    EXPECT_NO_THROW(checkExportName("a.NII.gz", segments));
    EXPECT_THROW(checkExportName("a.gltf", segments), WriteError);
    EXPECT_THROW(checkExportName("a.csv", surfaceSettings()), WriteError);
    EXPECT_NO_THROW(checkExportName("a.Ply", surfaceSettings()));
}

} // namespace
} // namespace vs::studio
