// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/refine.h"
#include "mesh/visible_surface.h"
#include "studio/document/document.h"
#include "studio/exports/segment_measures.h"
#include "volume/grid/brick_source.h"
#include "volume/io/read.h"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

// What of a document other programs can read: doc/exports.md. In two steps: what is needed is read from the
// document on its own thread, in pieces; files are made of that on any thread.
namespace vs::studio {

// One segment as files name it.
struct ExportedSegment {
    std::uint8_t label = 1; // in the label map
    std::int64_t value = 1; // in files
    std::string name;
    glm::dvec3 colour{0.8}; // sRGB, 0 to 1
    double opacity = 1;
};

struct ExportSettings {
    enum class What {
        Segments, // surfaces; a label map; a DICOM segmentation; a table: by the file's extension
        Volume,   // what is left of the volume: its surface, as surface mode shows it; its values
    };
    static constexpr int kUsualSmoothing = 10; // passes, of segments

    What what = What::Segments;
    bool isEachAlone = false; // a file for each segment, NAME-SEGMENT.EXT; of surfaces only
    mesh::Refinement refinement = {};
    Range range;                     // of the volume's surface
    std::optional<double> fill = {}; // what is written where the volume was cut; not set: its least value
};

// All that files are made of.
struct ExportSource {
    const volume::Volume* volume = nullptr; // may be missing where neither it nor a table is asked for
    volume::GridGeometry geometry;          // where the voxels lie
    bool isCorrected = false;               // which is elsewhere than the volume's file says
    volume::ReadOptions reading; // how the volume was read from volume->path: finds its DICOM series again
    // Segments: those to export, and where they are.
    std::vector<ExportedSegment> segments;
    std::vector<std::uint8_t> labels;
    // Volume: what is cut of it, as mesh::VisibleVolume has it, and the pasted parts that are seen, where
    // they are seen.
    std::vector<std::uint16_t> sculpture;
    field::SculptureView view = field::SculptureView::Cut;
    struct Part {
        std::vector<std::uint16_t> sculpture; // the part where it is at least a half
        render::Placement place;
        std::string name;
    };
    std::vector<Part> parts;
    // Volume: the finest level of a scan that is worked on at a coarser one, for stores, and what is cut of
    // it (0 to 1), both for boxes of its voxels, and whether nothing is in one.
    struct Finest {
        std::shared_ptr<const volume::BrickSource> levels;
        std::function<std::vector<float>(const Box3&)> cut;
        std::function<bool(const Box3&)> isUncut;
        volume::GridGeometry geometry;
    };
    std::optional<Finest> finest;
    // Segments, for stores and surfaces: labels of boxes of the finest level, where they grew at that, and
    // whether one has none.
    struct FinestLabels {
        std::function<std::vector<std::uint8_t>(const Box3&)> labels;
        std::function<bool(const Box3&)> isEmpty;
        volume::GridGeometry geometry;
    };
    std::optional<FinestLabels> finestLabels;
    field::SharedMarks marks; // colours that surfaces have where they are marked; null: none
    std::shared_ptr<const SegmentMeasures> finestMeasures; // figures of those; null: of `labels`
};

// All segments of a document that have voxels.
std::vector<ExportedSegment> exportable(const Document& document);

// Reads what an export needs from a document, which must not change meanwhile.
class ExportReader {
public:
    // `segments` are those to export; the document's volume must outlive what is read.
    ExportReader(Document& document, ExportSettings::What what, std::vector<ExportedSegment> segments = {});

    // Reads on for about `budgetMs`, at least a piece; true when all is read.
    bool readSome(double budgetMs);
    [[nodiscard]] double share() const; // read so far, 0 to 1
    // How the document's volume was read: for DICOM segmentations, which name the series they lie on.
    void setReading(const volume::ReadOptions& reading) { source_.reading = reading; }
    ExportSource take() { return std::move(source_); }

private:
    void readSlab();
    [[nodiscard]] std::vector<std::uint16_t>& sculptureInHand();

    Document& document_;
    ExportSource source_;
    bool needsLabels_ = false;
    std::vector<std::size_t> places_; // of the view, of the parts
    std::size_t sculptures_ = 0;      // to read: the document's own, then each part's
    std::size_t at_ = 0;              // which of them is in hand
    int slice_ = 0;                   // the next one of it
};

// The volume without what is cut, of its own type: values that can be seen are as they were, and those cut
// away go over to the fill from where the sculpture is a half to where it is 1, so that the cut face stays
// smooth. The displayed range and pasted parts play no role.
volume::Volume sculptedVolume(const ExportSource& source, const std::optional<double>& fill);
// Has values of a type go over to the fill so where the sculpture (0 to 1, a number for each) has cut them.
void takeCutAway(std::span<std::byte> values, volume::ScalarType type, std::span<const float> sculpture,
                 field::SculptureView view, double fill);

// Says what is wrong with a file's name for what is to be exported: WriteError.
void checkExportName(const std::filesystem::path& path, const ExportSettings& settings);

// Makes the file, or the files. Returns one line for each: its name and what is in it. Throws WriteError when
// there is nothing to write, GivenUp when `progress` says so.
std::vector<std::string> writeExport(const std::filesystem::path& path, const ExportSource& source,
                                     const ExportSettings& settings, const mesh::Progress& progress = {});

// How many triangles the surface of each label has before they are made fewer, by label; quickly, from the
// number of faces between voxels.
std::array<std::size_t, 256> estimatedTriangles(std::span<const std::uint8_t> labels, glm::ivec3 dims);

} // namespace vs::studio
